#pragma once
#include "ui/plugin/manipulator.h"

namespace blossom::sweep {

/// Points with their names where a sweep crosses itself, where its normal is smallest and where its smallest weight has the
/// most influence, from the stats of its result (see validity_report.h); none for other features. The last two are told from
/// the surface alone and are small and quiet: every surface has them.
std::vector<vtkSmartPointer<vtkProp>> validityMarks(const ui::OverlayContext&);

}  // namespace blossom::sweep
