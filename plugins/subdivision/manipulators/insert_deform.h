#pragma once
#include <optional>

#include "kernel/deform.h"
#include "kernel/scheme.h"
#include "ui/plugin/tool.h"

namespace blossom::subdivision {

/// What lies behind a shape that is to be deformed.
struct DeformPlace {
  FeatureId base;      ///< the cage that a deformation takes
  FeatureId existing;  ///< a deformation of it by pulls alone, which takes more pulls; empty: there is none
  FeatureId smooth;    ///< the feature that shows the limit surface of its result; empty: there is none
  Value scheme;        ///< parameter `scheme`
};

/// For a feature that is selected: a cage, a deformed cage, or the smooth surface of one; nothing when it is none of these.
std::optional<DeformPlace> deformPlace(const ui::ToolHost&, const FeatureId& selected);

/// The document with a deformation at that place (a new one, or the existing one changed), shown by a smooth surface; `id`
/// becomes that of the deformation. Parameters not given stay as they are.
Document withDeform(const ui::ToolHost&, Document, const DeformPlace&, const Value& parameters,
                    const std::vector<FeatureId>& targets, FeatureId& id);
/// The document with exactly these pulls at that place.
Document withPulls(const ui::ToolHost&, const DeformPlace&, const std::vector<Pull>&);

}  // namespace blossom::subdivision
