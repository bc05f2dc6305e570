#pragma once
#include <QString>
#include <vector>

#include "document/document.h"
#include "feature/feature_type.h"
#include "ui/plugin/tool.h"

namespace blossom::ui {

class Session;

/// What a new feature begins with.
struct FeatureStart {
  std::vector<FeatureId> inputs;       ///< in the order of the type's inputs
  std::vector<FeatureId> users;        ///< of an edit: the users of its input that go on with what it makes
  Value parameters = Value::object();  ///< faces and edges that were picked
  const InputSpec* missing = nullptr;  ///< the first input that has too few
  std::size_t has = 0;                 ///< number of shapes that the missing input has
};

/// The selected features as inputs of a new feature of a type, as far as it accepts them, and the selected faces, edges or
/// vertices as its parameters; the features of those come first. Where what is selected is accepted by no input, an edit
/// takes what it was made of, and a type that shows the steps of a way takes all of them.
FeatureStart featureStart(const Session&, const FeatureType&, const std::vector<FeatureId>& selected,
                          const std::vector<Pick>& parts);

/// Those selected for which the inputs, which would accept them, have no room; of an edit, which takes one shape as a matter
/// of course, none.
std::vector<FeatureId> leftOut(const Session&, const FeatureType&, const FeatureStart&,
                               const std::vector<FeatureId>& selected);

/// Features that an input accepts beside those taken: the shown ones, or when none of them fits, those that have gone into
/// the results of others.
std::vector<FeatureId> fittingFeatures(const Session&, const InputSpec&, const std::vector<FeatureId>& taken);

/// Hidden ones that it would accept as well, were they shown or selected.
std::vector<FeatureId> hiddenFeatures(const Session&, const InputSpec&, const std::vector<FeatureId>& taken);

/// "Choose a solid to round", or "Choose a solid or region to combine (2 of 2)".
QString questionFor(const FeatureType&, const FeatureStart&);
/// "a solid to round"; of inputs that do not say what they ask for, the names of the kinds that they accept.
QString wantedShape(const InputSpec&);

}  // namespace blossom::ui
