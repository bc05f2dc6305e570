#include "manipulators/validity_marks.h"

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
    constexpr double nearlyFolded = 0.01,
                     nearlyWithoutWeight = 1e-3;  // of a sound surface the marks would only be in the way
    if (shareOf("min_normal_share") < nearlyFolded)
      mark("min_normal_place", context_.look.control, small, tr("smallest normal"));
    if (shareOf("min_weight_share") < nearlyWithoutWeight)
      mark("min_weight_place", context_.look.control, small, tr("smallest weight"));
    mark("crossing_place", context_.look.fault, large, tr("crosses itself"));
    return std::move(props_);
  }

 private:
  [[nodiscard]] std::optional<Vec3> placeOf(const char* name) const {
    const auto found = context_.stats.find(name);
    if (found == context_.stats.end() || !found->is_array() || found->size() != 3) return {};
    return Vec3(found->at(0).get<double>(), found->at(1).get<double>(), found->at(2).get<double>());
  }

  [[nodiscard]] double shareOf(const char* name) const {
    const auto found = context_.stats.find(name);
    return found != context_.stats.end() && found->is_number() ? found->get<double>() : 1;
  }

  void mark(const char* name, const Color& color, double size, const QString& text) {
    const auto place = placeOf(name);
    if (!place) return;
    props_.push_back(ui::pointsProp({*place}, color, size));
    props_.push_back(ui::labelProp(text, *place, ui::labelLook(context_.look, color, 1)));
  }

  const ui::OverlayContext& context_;
  std::vector<vtkSmartPointer<vtkProp>> props_;
};

}  // namespace

std::vector<vtkSmartPointer<vtkProp>> validityMarks(const ui::OverlayContext& context) {
  return ValidityMarks(context).props();
}

}  // namespace blossom::sweep
