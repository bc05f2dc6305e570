#pragma once
#include <optional>

#include "kernel/deform.h"
#include "kernel/scheme.h"
#include "ui/plugin/tool.h"

namespace blossom::subdivision {

/// The features involved in deforming a selected shape.
struct DeformPlace {
  FeatureId base;      ///< the cage to deform
  FeatureId existing;  ///< a deformation of it that has only pulls and can get more; empty: none
  FeatureId smooth;    ///< the feature with the limit surface of its result; empty: none
  Value scheme;        ///< parameter `scheme`
};

/// For a selected feature that is a cage, a deformed cage, or the smooth surface of one; empty for other features.
std::optional<DeformPlace> deformPlace(const ui::ToolHost&, const FeatureId& selected);

/// The document with a deformation added or changed, and a smooth surface that shows it; `id` is set to the id of the
/// deformation. Other parameters are unchanged.
Document withDeform(const ui::ToolHost&, Document, const DeformPlace&, const Value& parameters,
                    const std::vector<FeatureId>& targets, FeatureId& id);
/// The document with exactly these pulls in the deformation.
Document withPulls(const ui::ToolHost&, const DeformPlace&, const std::vector<Pull>&);

}  // namespace blossom::subdivision
