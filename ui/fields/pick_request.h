#pragma once
#include <QString>
#include <vector>

#include "document/document.h"
#include "scene/picking.h"

namespace blossom::ui {

/// A request of a form for a pick in the view, until it is answered or ended.
struct PickRequest {
  enum class Want {
    Feature,   ///< a whole feature, as an input
    SubShape,  ///< a face, edge or vertex, as `kind` says
    Point,     ///< a place on anything, or on the ground
    Direction  ///< the normal of a face
  };
  Want want = Want::Point;
  QString parameter;                        ///< path of the parameter: "pins/2/target"; of an input: "shape/1"
  SubShapeKind kind = SubShapeKind::Whole;  ///< of a SubShape
  std::vector<FeatureId> features;          ///< features that may be picked; empty: any
  bool several = false;                     ///< picks are accepted until the request is ended
  QString hint;                             ///< a sentence for the status line
};

}  // namespace blossom::ui
