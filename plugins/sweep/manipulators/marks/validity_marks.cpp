#include "manipulators/marks/validity_marks.h"

#include <QCoreApplication>
#include <optional>

#include "ui/tools/view_props.h"

namespace blossom::sweep {

namespace {

class ValidityMarks {
  Q_DECLARE_TR_FUNCTIONS(blossom::sweep::ValidityMarks)

 public:
  ValidityMarks(const ui::ToolHost& host, const Value& stats, const std::function<bool(const Vec3&)>& covered)
      : host_(host), stats_(stats), covered_(covered) {}

  std::vector<ui::PropPtr> props() && {
    constexpr double small = 7, large = 11;
    // Every surface has a smallest normal and weight somewhere. Where they are harmless, marks would only be in the way of
    // who pulls there.
    constexpr double worryingShare = 1e-3, worryingWeight = 0.02;
    // Of marks that lie on each other the first is seen. Where the places are close to each other, each name has a row of
    // its own: the worst above its point, the others below theirs.
    mark("crossing_place", host_.look().fault, large, tr("crosses itself"), 0);
    if (below("min_normal_share", worryingShare))
      mark("min_normal_place", host_.look().control, small, tr("smallest normal"), 1);
    if (below("min_weight", worryingWeight)) mark("min_weight_place", host_.look().control, small, tr("smallest weight"), 2);
    return std::move(props_);
  }

 private:
  [[nodiscard]] std::optional<Vec3> placeOf(const char* name) const {
    const auto found = stats_.find(name);
    if (found == stats_.end() || !found->is_array() || found->size() != 3) return {};
    return Vec3(found->at(0).get<double>(), found->at(1).get<double>(), found->at(2).get<double>());
  }

  [[nodiscard]] bool below(const char* name, double limit) const {
    const auto found = stats_.find(name);
    return found != stats_.end() && found->is_number() && found->get<double>() < limit;
  }

  /// @param row 0 above the point, 1 and 2 below it
  void mark(const char* name, const Color& color, double size, const QString& text, int row) {
    const auto place = placeOf(name);
    if (!place) return;
    props_.push_back(ui::pointsProp({*place}, color, size * host_.pixelRatio()));
    if (covered_(*place)) return;
    constexpr double rowHeight = 26;  // logical pixels, of a label and what parts it from the next
    ui::LabelLook look = ui::labelLook(host_.look(), color, host_.pixelRatio());
    if (row > 0) look.shift = {0, -row * rowHeight - 2 * ui::labelGap};
    props_.push_back(ui::labelProp(text, *place, look));
  }

  const ui::ToolHost& host_;
  const Value& stats_;
  const std::function<bool(const Vec3&)>& covered_;
  std::vector<ui::PropPtr> props_;
};

}  // namespace

std::vector<ui::PropPtr> validityMarks(const ui::ToolHost& host, const Value& stats,
                                       const std::function<bool(const Vec3&)>& covered) {
  return ValidityMarks(host, stats, covered).props();
}

}  // namespace blossom::sweep
