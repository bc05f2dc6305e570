#pragma once
#include <functional>

#include "ui/plugin/tool.h"
#include "ui/tools/view_props.h"

namespace blossom::sweep {

/// Points with their names where a sweep crosses itself, where its normal is smallest and where its smallest weight has the
/// most influence, from the stats of its result (see validity_report.h); none for other features. Every surface has the last
/// two; they are marked where they come near to being harmful.
/// @param covered where something else is written: a point there has no name
std::vector<ui::PropPtr> validityMarks(const ui::ToolHost&, const Value& stats,
                                       const std::function<bool(const Vec3&)>& covered);

}  // namespace blossom::sweep
