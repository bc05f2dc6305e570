#pragma once
#include <vtkProp.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

#include "ui/plugin/tool.h"

namespace blossom::subdivision {

using Props = std::vector<vtkSmartPointer<vtkProp>>;

/// Grips as points: the pulled ones and the one under the mouse.
Props gripMarks(const ui::ToolHost&, const std::vector<Vec3>& pulled, const std::optional<Vec3>& hovered);
/// The line of a pull during a drag.
void addPullMark(const ui::ToolHost&, const Vec3& from, const Vec3& to, Props&);

}  // namespace blossom::subdivision
