#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/progress.h"
#include "naming/construction.h"

namespace blossom {

/// What a face came from: labels of faces and edges of sources, sorted. Empty: unknown.
using FaceName = std::vector<std::string>;

/// A face or an edge of a source: of a drawing, or of a solid that is not made of others.
struct SourcePart {
  std::string feature;
  SubShapeKind kind = SubShapeKind::Face;
  int index = 0;
};

/// Names the faces of B-reps after the sources that they came from, step by step (the idea: Kripac, "A mechanism for
/// persistently naming topological entities in history-based parametric solid models", 1997; here a step is traced by where
/// the faces lie, see face_origins.h). A face of unknown origin is named after its neighbours.
class Namer {
 public:
  /// The label of a part of a source, which is given with its shape.
  using LabelOf = std::function<std::string(const SourcePart&, const Shape&)>;

  Namer(Construction& construction, LabelOf labelOf) : construction_(construction), labelOf_(std::move(labelOf)) {}

  /// By number; of a region one name, of curves and meshes none. The reference stays valid. @throws Error Cancelled.
  const std::vector<FaceName>& faces(const std::string& id, const Progress& = Progress::none());

 private:
  std::vector<FaceName> made(const ConstructionStep&, const Progress&);
  std::string labelOf(const ConstructionStep&, std::size_t input, SubShapeKind, int index, const Progress&);

  Construction& construction_;
  LabelOf labelOf_;
  std::map<std::string, std::vector<FaceName>> named_;
};

/// The names of the faces at a face itself, an edge or a vertex of a B-rep, sorted. @throws Error NotFound.
std::vector<FaceName> facesAt(const Brep&, SubShapeKind, int index, const std::vector<FaceName>& names);
/// The same for all sub-shapes of a kind. O(size).
std::vector<std::vector<FaceName>> facesAtAll(const Brep&, SubShapeKind, const std::vector<FaceName>& names);

}  // namespace blossom
