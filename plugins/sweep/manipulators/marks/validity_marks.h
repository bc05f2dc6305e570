#pragma once
#include "ui/plugin/manipulator.h"

namespace blossom::sweep {

/// Points with their names where a sweep crosses itself, where its normal is smallest and where its smallest weight has the
/// most influence, from the stats of its result (see validity_report.h); none for other features. Every surface has the last
/// two; they are marked where they come near to being harmful.
std::vector<vtkSmartPointer<vtkProp>> validityMarks(const ui::OverlayContext&);

}  // namespace blossom::sweep
