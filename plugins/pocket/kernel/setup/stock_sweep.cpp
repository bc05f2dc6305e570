#include "kernel/setup/stock_sweep.h"

#include <algorithm>
#include <cmath>

namespace blossom::pocket {

namespace {

class Carving {
 public:
  Carving(StockField& stock, const Toolpath& path, const ToolAssembly& tool, double allowed)
      : stock_(stock), path_(path), allowed_(allowed), fluteLength_(tool.fluteLength) {
    for (ToolStage& stage : stagesOf(tool, 0))
      if (stage.part != ToolPart::Flutes) carriers_.push_back(std::move(stage));
  }

  std::vector<StockHit> run(const Progress& progress) {
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      progress.report(static_cast<double>(i) / static_cast<double>(path_.moves.size()), "Carving the stock");
      move(i);
    }
    return std::move(hits_);
  }

 private:
  void move(std::size_t number) {
    const std::vector<Vec3> way = steps(polylineOf(startOf(path_, number), path_.moves[number], stock_.cell() / 4));
    const bool isRapid = path_.moves[number].kind == MoveKind::Rapid;
    std::vector<bool> told(carriers_.size(), false);
    bool isCutterTold = false;
    for (std::size_t k = 1; k < way.size(); ++k) {
      if (isRapid && !isCutterTold)
        if (const auto at = stock_.metBy(path_.cutter, way[k - 1], way[k], allowed_)) {
          hits_.push_back({number, ToolPart::Flutes, *at});
          isCutterTold = true;
        }
      for (std::size_t c = 0; c < carriers_.size(); ++c) {
        if (told[c]) continue;
        const auto at = stock_.metBy(carriers_[c], way[k - 1], way[k], allowed_);
        if (!at) continue;
        hits_.push_back({number, carriers_[c].part, *at});
        told[c] = true;
      }
      stock_.cut(path_.cutter, way[k - 1], way[k]);
    }
  }

  /// Ways down in pieces over which the flutes have removed what the shank comes to.
  [[nodiscard]] std::vector<Vec3> steps(const std::vector<Vec3>& way) const {
    if (fluteLength_ == 0) return way;
    std::vector<Vec3> finer{way.front()};
    for (std::size_t k = 1; k < way.size(); ++k) {
      const double falls = way[k - 1].z() - way[k].z();
      const int count = std::max(1, static_cast<int>(std::ceil(2 * falls / fluteLength_)));
      for (int i = 1; i <= count; ++i) finer.emplace_back(way[k - 1] + double(i) / count * (way[k] - way[k - 1]));
    }
    return finer;
  }

  StockField& stock_;
  const Toolpath& path_;
  double allowed_, fluteLength_;
  std::vector<ToolStage> carriers_;
  std::vector<StockHit> hits_;
};

}  // namespace

namespace {

/// When each move ends, in any unit.
std::vector<double> endsOf(const Toolpath& path) {
  const bool isTimed = secondsOf(path).has_value();
  std::vector<double> ends;
  double sum = 0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const ToolMove& move = path.moves[i];
    const double speed = move.kind == MoveKind::Rapid ? path.rapidFeed : move.feed;
    sum += lengthOf(startOf(path, i), move) / (isTimed ? speed : 1);
    ends.push_back(sum);
  }
  return ends;
}

/// A polyline between two shares of its length.
std::vector<Vec3> between(const std::vector<Vec3>& way, double from, double to) {
  if (from <= 0 && to >= 1) return way;
  double length = 0;
  for (std::size_t k = 1; k < way.size(); ++k) length += (way[k] - way[k - 1]).norm();
  std::vector<Vec3> part;
  double before = 0;
  for (std::size_t k = 1; k < way.size(); ++k) {
    const double step = (way[k] - way[k - 1]).norm(), low = from * length - before, high = to * length - before;
    before += step;
    if (step == 0 || high < 0 || low > step) continue;
    const Vec3 along = (way[k] - way[k - 1]) / step;
    if (part.empty()) part.push_back(way[k - 1] + std::clamp(low, 0.0, step) * along);
    part.push_back(way[k - 1] + std::clamp(high, 0.0, step) * along);
  }
  return part;
}

}  // namespace

void cutBetween(StockField& stock, const Toolpath& path, double from, double to, const Progress& progress) {
  const std::vector<double> ends = endsOf(path);
  const double whole = ends.empty() ? 0 : ends.back();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (i % 64 == 0) progress.report(static_cast<double>(i) / static_cast<double>(ends.size()), "Carving the stock");
    const double begin = i == 0 ? 0 : ends[i - 1], length = ends[i] - begin;
    if (ends[i] < from * whole || begin > to * whole || length <= 0) continue;
    const std::vector<Vec3> way = between(polylineOf(startOf(path, i), path.moves[i], stock.cell() / 4),
                                          (from * whole - begin) / length, (to * whole - begin) / length);
    for (std::size_t k = 1; k < way.size(); ++k) stock.cut(path.cutter, way[k - 1], way[k]);
  }
}

std::vector<StockHit> carve(StockField& stock, const Toolpath& path, const ToolAssembly& tool, double allowed,
                            const Progress& progress) {
  return Carving(stock, path, tool, allowed).run(progress);
}

}  // namespace blossom::pocket
