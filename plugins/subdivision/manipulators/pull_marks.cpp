#include "manipulators/pull_marks.h"

#include "ui/tools/view_props.h"

namespace blossom::subdivision {

Props gripMarks(const ui::ToolHost& host, const std::vector<Vec3>& pulled, const std::optional<Vec3>& hovered) {
  Props props;
  if (!pulled.empty()) props.push_back(ui::pointsProp(pulled, host.look().made, 7 * host.pixelRatio()));
  if (hovered) props.push_back(ui::pointsProp({*hovered}, host.look().control, 10 * host.pixelRatio()));
  return props;
}

void addPullMark(const ui::ToolHost& host, const Vec3& from, const Vec3& to, Props& props) {
  props.push_back(ui::linesProp({{from, to}}, host.look().made, 1.5 * host.pixelRatio()));
  props.push_back(ui::pointsProp({to}, host.look().made, 10 * host.pixelRatio()));
}

}  // namespace blossom::subdivision
