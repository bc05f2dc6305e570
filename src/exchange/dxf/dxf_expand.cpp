#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <set>

#include "exchange/dxf/dxf_drawing.h"
#include "exchange/format/finite.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/single_point.h"

namespace blossom {

using namespace parse;

namespace {

/// Blocks in blocks multiply: this many items and segments are more than any drawing made by people.
constexpr std::size_t maximumItems = 1'000'000, maximumSegments = 2'000'000;
constexpr std::size_t deepestNesting = 64;

/// mm per unit of $INSUNITS, 0 for unusual units.
double millimetres(int unit) {
  static constexpr std::array<double, 17> table{1,       25.4,  304.8, 1609344, 1,    10,  1000,  1e6,   25.4e-6,
                                                25.4e-3, 914.4, 1e-7,  1e-6,    1e-3, 100, 10000, 100000};
  return unit >= 0 && unit < static_cast<int>(table.size()) ? table[static_cast<std::size_t>(unit)] : 0;
}

struct Context {
  Eigen::Affine2d place = Eigen::Affine2d::Identity();
  bool isPlaced = false;  ///< place is not the identity
  std::string layer;      ///< of the insert around; empty at the top
  std::optional<Color> color;
};

class Expander {
 public:
  Expander(const DxfDrawing& drawing, const Progress& progress) : drawing_(drawing), progress_(progress) {}

  Curves expand(double unit) {
    Context top;
    if (unit != 1) {
      top.place.scale(unit);
      top.isPlaced = true;
    }
    block(drawing_.model, top);
    return std::move(curves_);
  }
  [[nodiscard]] const std::set<std::string>& missing() const { return missing_; }
  [[nodiscard]] std::size_t collapsed() const { return collapsed_; }

 private:
  void block(const DxfBlock& content, const Context& context) {
    for (const DxfItem& item : content.items) {
      if (++items_ > maximumItems)
        throw Error(ErrorCode::LimitExceeded,
                    fmt::format("Its blocks and arrays unfold into more than {} entities.", maximumItems));
      if (items_ % 4096 == 0) progress_.check();
      if (item.insert)
        insert(item, context);
      else
        path(item, context);
    }
  }

  [[nodiscard]] std::string layerOf(const DxfInk& ink, const Context& context) const {
    return ink.layer == "0" && !context.layer.empty() ? context.layer : ink.layer;
  }

  [[nodiscard]] std::optional<Color> colorOf(const DxfInk& ink, const std::string& layer, const Context& context) const {
    const auto fromRgb = [](int rgb) {
      return Color{(rgb >> 16 & 255) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0};
    };
    if (ink.rgb >= 0) return fromRgb(ink.rgb);
    if (ink.index == 0) return context.color;
    if (ink.index != 256) return dxfColor(std::abs(ink.index));
    const auto it = drawing_.layers.find(layer);
    if (it == drawing_.layers.end()) return {};
    return it->second.rgb >= 0 ? fromRgb(it->second.rgb) : dxfColor(it->second.index);
  }

  void path(const DxfItem& item, const Context& context) {
    segments_ += item.path.segments.size();
    if (segments_ > maximumSegments)
      throw Error(ErrorCode::LimitExceeded, fmt::format("It unfolds into more than {} lines and arcs.", maximumSegments));
    Path placed = context.isPlaced ? transformed(item.path, Eigen::Matrix<double, 2, 3>(context.place.affine())) : item.path;
    if (!allFinite(placed)) throw damaged(item.line, "an entity has a coordinate that is not a number.");
    placed.layer = layerOf(item.ink, context);
    placed.color = colorOf(item.ink, placed.layer, context);
    curves_.paths.push_back(std::move(placed));
  }

  void insert(const DxfItem& item, const Context& context) {
    const DxfInsert& use = *item.insert;
    const auto found = drawing_.blocks.find(use.block);
    if (found == drawing_.blocks.end()) {
      missing_.insert(use.block);
      return;
    }
    if (!open_.insert(use.block).second)
      throw damaged(item.line, fmt::format("the block {} contains itself.", shown(use.block)));
    if (open_.size() > deepestNesting)
      throw Error(ErrorCode::LimitExceeded, fmt::format("Its blocks are nested more than {} deep.", deepestNesting));
    Context inner;
    inner.isPlaced = true;
    inner.layer = layerOf(item.ink, context);
    inner.color = colorOf(item.ink, inner.layer, context);
    for (int row = 0; row < use.rows; ++row)
      for (int column = 0; column < use.columns; ++column) cell(found->second, use, row, column, context, inner);
    open_.erase(use.block);
  }

  void cell(const DxfBlock& content, const DxfInsert& use, int row, int column, const Context& context, Context& inner) {
    // Empty blocks count as well, so that an array of nothing ends too.
    if (++items_ > maximumItems)
      throw Error(ErrorCode::LimitExceeded,
                  fmt::format("Its blocks and arrays unfold into more than {} entities.", maximumItems));
    Eigen::Affine2d plane = Eigen::Affine2d::Identity();
    plane.affine() = use.plane;
    inner.place = context.place * plane * Eigen::Translation2d(use.at) * Eigen::Rotation2Dd(use.angle) *
                  Eigen::Translation2d(column * use.spacing.x(), row * use.spacing.y()) * Eigen::Scaling(use.scale) *
                  Eigen::Translation2d(-content.base);
    const auto& affine = inner.place.affine();
    if (!affine.allFinite() || affine.cwiseAbs().maxCoeff() > 1e15)
      throw Error(ErrorCode::LimitExceeded, "Its blocks scale each other beyond every measure.");
    if (std::abs(affine.leftCols<2>().determinant()) < 1e-18) {
      ++collapsed_;
      return;
    }
    block(content, inner);
  }

  const DxfDrawing& drawing_;
  const Progress& progress_;
  Curves curves_;
  std::set<std::string> open_, missing_;
  std::size_t items_ = 0, segments_ = 0, collapsed_ = 0;
};

}  // namespace

bool isPoint(const DxfDrawing& drawing) { return drawing.point && drawing.degenerate == 1 && drawing.model.items.empty(); }

Curves expandDxf(const DxfDrawing& drawing, std::vector<std::string>& warnings, const Progress& progress) {
  double unit = millimetres(drawing.unit);
  if (unit == 0) {
    warnings.push_back(fmt::format("The unit {} of the drawing is not known; its lengths are taken for mm.", drawing.unit));
    unit = 1;
  }
  Expander expander(drawing, progress);
  Curves curves = expander.expand(unit);
  if (!expander.missing().empty())
    warnings.push_back(fmt::format("{} blocks that are used are not in the file, the first is {}.",
                                   expander.missing().size(), shown(*expander.missing().begin())));
  if (expander.collapsed() > 0)
    warnings.push_back(fmt::format("{} blocks are scaled to nothing and were left out.", expander.collapsed()));
  if (isPoint(drawing)) return pointDrawing(unit * *drawing.point);
  return curves;
}

}  // namespace blossom
