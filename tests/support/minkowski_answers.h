#pragma once
#include "exchange/format/format.h"
#include "geometry/planar/planar.h"
#include "support/command_line.h"
#include "support/modeling.h"

/// What commands that add and morph planar shapes leave behind.
namespace blossom::test {

inline int sumsOf(const Answer& answer) { return answer.json["stats"]["sums"].get<int>(); }

inline double areaInFile(const fs::path& file) {
  return area(toRegion(*readShape(*theApp().formats, file).shape.get<Curves>()));
}

}  // namespace blossom::test
