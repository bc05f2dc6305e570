#pragma once
#include <memory>
#include <vector>

#include "document/shown.h"

namespace blossom::ui {

/// A row of the document tree.
struct NestedRow {
  std::shared_ptr<const Feature> feature;
  FeatureId parent;    ///< the row that it is a step of; empty: none
  int depth = 0;       ///< how far it is indented
  bool steps = false;  ///< rows of its own steps follow
  friend bool operator==(const NestedRow&, const NestedRow&) = default;
};

/// Features in the order of the tree: those whose shapes are final, in document
/// order, each followed by the steps that have gone into it, the last one
/// first. A step made of one other is followed by that one; several have their
/// steps beneath them, one deeper. O(n log n).
/// @param shapeOf as in document/shown.h; features without a shape are taken
/// for ones that will have an outline
std::vector<NestedRow> nestedRows(const Document&, const Registry&, const ShapeOf& shapeOf);

}  // namespace blossom::ui
