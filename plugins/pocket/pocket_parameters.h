#pragma once
#include <string>

#include "feature/feature_type.h"
#include "kernel/path/pocket_path.h"
#include "pocket_heights.h"
#include "setup_check.h"
#include "work_zero.h"

namespace blossom::pocket {

enum class Direction { Climb, Conventional };
enum class WorkOffset { G54, G55, G56, G57, G58, G59 };

struct PocketParameters : HolderParameters {
  double toolDiameter = 6, toolCorner = 0;
  int toolNumber = 1;
  double depth = 5, stepdown = 0;
  std::string stepover = "45%";
  Direction direction = Direction::Climb;
  Entry entry = Entry::Ramp;
  double rampAngle = 3;
  double leaveWall = 0, leaveFloor = 0, finish = 0;
  double feed = 800, plungeFeed = 200, spindle = 12000;
  double safeHeight = 5, approach = 1;
  double stockMargin = 5, stockThickness = 0;
  Zero zero = Zero::Drawing;
  ZeroHeight zeroHeight = ZeroHeight::Top;
  WorkOffset workOffset = WorkOffset::G54;
  double tolerance = 0.005;
  SubShapeValue face;
  FaceIs faceIs = FaceIs::Automatic;
  bool skipOpen = false;
};

/// @throws Error InvalidParameter.
PocketOptions optionsOf(const PocketParameters&);

}  // namespace blossom::pocket
