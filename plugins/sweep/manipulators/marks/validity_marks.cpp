#include "manipulators/marks/validity_marks.h"

#include <QCoreApplication>
#include <optional>

#include "ui/tools/view_props.h"

namespace blossom::sweep {

namespace {

class ValidityMarks {
  Q_DECLARE_TR_FUNCTIONS(blossom::sweep::ValidityMarks)

 public:
  explicit ValidityMarks(const ui::OverlayContext& context) : context_(context) {}

  std::vector<vtkSmartPointer<vtkProp>> props() && {
    constexpr double small = 7, large = 11;
    // Every surface has a smallest normal and weight somewhere. Where they are harmless, marks would only be in the way of
    // who pulls there.
    constexpr double worryingShare = 1e-3, worryingWeight = 0.02;
    if (below("min_normal_share", worryingShare))
      mark("min_normal_place", context_.look.control, small, tr("smallest normal"));
    if (below("min_weight", worryingWeight)) mark("min_weight_place", context_.look.control, small, tr("smallest weight"));
    mark("crossing_place", context_.look.fault, large, tr("crosses itself"));
    return std::move(props_);
  }

 private:
  [[nodiscard]] std::optional<Vec3> placeOf(const char* name) const {
    const auto found = context_.stats.find(name);
    if (found == context_.stats.end() || !found->is_array() || found->size() != 3) return {};
    return Vec3(found->at(0).get<double>(), found->at(1).get<double>(), found->at(2).get<double>());
  }

  [[nodiscard]] bool below(const char* name, double limit) const {
    const auto found = context_.stats.find(name);
    return found != context_.stats.end() && found->is_number() && found->get<double>() < limit;
  }

  void mark(const char* name, const Color& color, double size, const QString& text) {
    const auto place = placeOf(name);
    if (!place) return;
    props_.push_back(ui::pointsProp({*place}, color, size * context_.pixelRatio));
    props_.push_back(ui::labelProp(text, *place, ui::labelLook(context_.look, color, context_.pixelRatio)));
  }

  const ui::OverlayContext& context_;
  std::vector<vtkSmartPointer<vtkProp>> props_;
};

}  // namespace

std::vector<vtkSmartPointer<vtkProp>> validityMarks(const ui::OverlayContext& context) {
  return ValidityMarks(context).props();
}

}  // namespace blossom::sweep
