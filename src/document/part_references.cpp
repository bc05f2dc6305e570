#include "document/part_references.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/error.h"
#include "parameter/wording.h"

namespace blossom {

namespace {

/// Calls a function with each sub-shape in a parameter.
template <class F>
void forEachPart(const ParameterSpec& spec, Value& value, const F& function) {
  if (value.is_null()) return;
  if (spec.kind == ParameterKind::SubShape) {
    function(value);
  } else if (spec.kind == ParameterKind::List) {
    for (Value& item : value) forEachPart(spec.fields.at(0), item, function);
  } else if (spec.kind == ParameterKind::Record) {
    for (const ParameterSpec& field : spec.fields)
      if (const auto it = value.find(field.name); it != value.end()) forEachPart(field, *it, function);
  }
}

template <class F>
void forEachPart(const std::vector<ParameterSpec>& specs, Value& parameters, const F& function) {
  for (const ParameterSpec& spec : specs)
    if (const auto it = parameters.find(spec.name); it != parameters.end()) forEachPart(spec, *it, function);
}

/// The input whose parts a name refers to: the first shape of the input declared by that name.
std::optional<FeatureId> sourceOf(const Feature& feature, const FeatureType& type, const Inputs& arranged,
                                  const std::string& name) {
  std::size_t first = 0;
  for (std::size_t k = 0; k < type.inputs.size(); first += arranged.of(k++).size())
    if ((name.empty() || type.inputs[k].name == name) && !arranged.of(k).empty() && first < feature.inputs.size())
      return feature.inputs[first];
  return std::nullopt;
}

/// The first shape of the input that a part is named after; nullptr: there is none.
const Shape* shapeOfPart(const FeatureType& type, const Inputs& arranged, const std::string& name) {
  for (std::size_t k = 0; k < type.inputs.size(); ++k)
    if ((name.empty() || type.inputs[k].name == name) && !arranged.of(k).empty()) return &arranged.of(k).front();
  return nullptr;
}

class Finder {
 public:
  Finder(Construction& construction, const Progress& progress) : construction_(construction), progress_(progress) {}

  /// The number that a part of a feature has now; nothing when it is lost.
  std::optional<int> find(const FeatureId& source, const Value& part) const {
    const SubShapeKind kind = kindOf(part);
    const int index = part.at("index").get<int>();
    const auto signature = part.find("signature");
    if (signature == part.end()) return index;
    try {
      return foundPart(construction_, source, kind, index, *signature, progress_);
    } catch (const Value::exception&) {
      return std::nullopt;  // a signature that somebody damaged tells nothing
    }
  }

  /// A part without a signature where there is none with its number: the feature tells that better.
  void sign(const FeatureId& source, Value& part) const {
    try {
      part["signature"] = signatureOf(construction_, source, kindOf(part), part.at("index").get<int>(), progress_);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::NotFound) throw;
      part.erase("signature");
    }
  }

 private:
  static SubShapeKind kindOf(const Value& part) { return subShapeKindOf(part.at("kind").get<std::string>()); }

  Construction& construction_;
  const Progress& progress_;
};

}  // namespace

bool namesParts(const std::vector<ParameterSpec>& specs, const Value& parameters) {
  bool found = false;
  Value copy = parameters;
  forEachPart(specs, copy, [&](const Value&) { found = true; });
  return found;
}

void refusePartsOfSequences(const FeatureType& type, const Value& parameters, const Inputs& arranged) {
  Value copy = parameters;
  forEachPart(type.parameters, copy, [&](const Value& part) {
    const Shape* shape = part.is_object() ? shapeOfPart(type, arranged, part.value("input", std::string())) : nullptr;
    if (!shape || shape->kind() != ShapeKind::Sequence) return;
    const std::string kind = part.value("kind", std::string("part"));
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{} names {} {} of a sequence, and each of its frames has its own.", type.title, kind,
                            part.value("index", 0)),
                fmt::format("Take one frame out with the command \"frame\" and pick the {} there.", kind));
  });
}

FoundParts foundParts(const Feature& feature, const FeatureType& type, const Value& parameters, const Inputs& arranged,
                      Construction& construction, const Progress& progress) {
  const Finder finder(construction, progress);
  FoundParts found;
  Value kept = parameters;
  forEachPart(type.parameters, kept, [&](Value& part) {
    const auto source = sourceOf(feature, type, arranged, part.value("input", std::string()));
    const std::optional<int> number = source ? finder.find(*source, part) : std::nullopt;
    if (number) {
      part["index"] = *number;
      finder.sign(*source, part);
    } else if (source) {
      found.lost.push_back(part);
    } else {
      part.erase("signature");
    }
  });
  found.now = kept;
  forEachPart(type.parameters, found.now, [](Value& part) { part.erase("signature"); });
  for (const ParameterSpec& spec : type.parameters)
    if (kept.at(spec.name) != found.now.at(spec.name)) found.kept[spec.name] = kept.at(spec.name);
  return found;
}

Error lostError(const Value& part) {
  const std::string kind = part.at("kind").get<std::string>();
  std::string first = kind;
  first.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(kind.front())));
  return Error(ErrorCode::InvalidInput,
               fmt::format("{} lost: an edit before this step removed {} {}, or left several it could be.", first, kind,
                           part.at("index").get<int>()),
               fmt::format("Pick the {} again.", kind));
}

namespace {

/// The shapes of a feature's inputs; nothing while one is not known.
std::optional<Inputs> shownInputs(const Feature& feature, const FeatureType& type, const ShapeOf& shapeOf) {
  std::vector<Shape> shapes;
  for (const FeatureId& id : feature.inputs) {
    const Shape* shape = shapeOf(id);
    if (!shape || shape->empty()) return std::nullopt;
    shapes.push_back(*shape);
  }
  try {
    return arrangedInputs(type, shapes);
  } catch (const Error&) {
    return std::nullopt;  // the feature tells it
  }
}

void addAppearance(Value& part, const Shape& shape) {
  try {
    part["signature"] = appearanceOf(shape, subShapeKindOf(part.at("kind").get<std::string>()), part.at("index").get<int>());
  } catch (const std::exception&) {
    part.erase("signature");  // there is no such part, which the feature tells
  }
}

}  // namespace

Document withAppearances(Document document, const Document& before, const Registry& registry, const ShapeOf& shapeOf) {
  const auto span = document.features();
  const std::vector<std::shared_ptr<const Feature>> all(span.begin(), span.end());
  for (const auto& each : all) {
    if (before.contains(each->id) && &before.at(each->id) == each.get()) continue;
    const auto type = registry.find(each->type);
    if (!type || !namesParts(type->parameters, each->parameters)) continue;
    const auto inputs = shownInputs(*each, *type, shapeOf);
    if (!inputs) continue;
    Feature changed = *each;
    forEachPart(type->parameters, changed.parameters, [&](Value& part) {
      if (!part.is_object() || part.contains("signature") || !part.contains("index") || !part.contains("kind")) return;
      const auto source = sourceOf(changed, *type, *inputs, part.value("input", std::string()));
      const Shape* shape = source ? shapeOf(*source) : nullptr;
      if (shape) addAppearance(part, *shape);
    });
    if (changed.parameters != each->parameters) document = document.with(std::move(changed));
  }
  return document;
}

Document withKeptParts(const Document& document, const FeatureId& id, const Value& kept) {
  Feature feature = document.at(id);
  bool differs = false;
  for (const auto& [name, value] : kept.items()) {
    differs = differs || feature.parameters.value(name, Value()) != value;
    feature.parameters[name] = value;
  }
  return differs ? document.with(feature) : document;
}

}  // namespace blossom
