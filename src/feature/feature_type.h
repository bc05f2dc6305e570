#pragma once
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/progress.h"
#include "geometry/measure/measure.h"
#include "geometry/shape/shape.h"
#include "parameter/binding.h"
#include "parameter/parameter.h"

namespace blossom {

/// One input of a feature type, or a run of inputs of the same sort.
struct InputSpec {
  std::string name;  ///< "shape", "motion"
  std::string help;
  std::vector<ShapeKind>
      kinds;  ///< accepted; empty means any. Region inputs also take closed Curves (converted by the evaluator).
  std::size_t minimum = 1;
  std::size_t most = 1;
};

inline constexpr std::size_t anyNumber = std::numeric_limits<std::size_t>::max();

/// What an evaluation gives.
struct Evaluated {
  Shape shape;
  Value stats = Value::object();      ///< counts and figures of the computation, for `stats` of --json and the result panel
  std::vector<std::string> warnings;  ///< full sentences
  /// What the kind of feature promises in `result` beside the measures of the shape, such as the distances of a fit.
  std::vector<Measure> figures = {};
};

/// A number of the statistics or figures that is none would be told as nothing at all.
/// @throws Error LimitExceeded that names it.
void refuseInfiniteFigures(const Evaluated&);

/// The measures of the shape and the figures beside them. @throws Error Cancelled.
Measures measured(const Evaluated&, const Progress& = Progress::none());

/// All inputs, in order of the specs; `of(k)` are those of spec k.
class Inputs {
 public:
  Inputs() = default;
  explicit Inputs(std::vector<std::vector<Shape>> bySpec) : bySpec_(std::move(bySpec)) {}
  [[nodiscard]] std::span<const Shape> of(std::size_t spec) const { return bySpec_.at(spec); }
  /// The one value of input `spec`. @throws Error InvalidInput when it holds another kind.
  template <class T>
  [[nodiscard]] const T& get(std::size_t spec = 0, std::size_t index = 0) const;

 private:
  std::vector<std::vector<Shape>> bySpec_;
};

[[noreturn]] void throwWrongKind(const Shape&);

template <class T>
const T& Inputs::get(std::size_t spec, std::size_t index) const {
  const Shape& shape = bySpec_.at(spec).at(index);
  if (const T* value = shape.get<T>()) return *value;
  throwWrongKind(shape);
}

/// A choice that the command line makes by the format of the first output when it is not given: a mesh for STL, faces for
/// STEP.
struct ChoiceByOutput {
  std::string parameter;                                          ///< empty: there is none
  std::vector<std::pair<std::string, std::string>> byExtensions;  ///< {"step iges", "faces"}, ..
};

/// How commands whose inputs take what this feature gives, while it needs no input itself, take it as one of theirs by flags
/// alone: `pocket --text Blossom --font "DejaVu Serif" --text.height 20`.
struct InputByFlags {
  std::string asks;                     ///< the parameter whose flag asks for it; empty: there are no such flags
  std::vector<std::string> plain = {};  ///< parameters whose flags need no prefix; those of all others begin with "ASKS."
};

/// A feature type, declared once and present everywhere: command, flags, help, dialog, panel, undo text, file format,
/// manual.
struct FeatureType {
  using Evaluate = std::function<Evaluated(const Value& parameters, const Inputs&, const Progress&)>;

  std::string id;       ///< "sweep.sweep": plugin, dot, name
  std::string command;  ///< "sweep"
  std::string title;    ///< "Sweep"
  std::string summary;  ///< one sentence
  std::string icon;     ///< name of a file in resources/icons; empty: the plugin's
  std::vector<InputSpec> inputs;
  std::vector<ParameterSpec> parameters;
  std::vector<ShapeKind> produces;    ///< kinds of its results, or of the frames of a sequence; empty: any
  std::vector<std::string> examples;  ///< command lines for --help
  ChoiceByOutput byOutput = {};
  InputByFlags inputByFlags = {};
  /// When a file of this kind is opened, a feature of this type with the file as its only input follows; None: never.
  ShapeKind opens = ShapeKind::None;
  Evaluate evaluate;  ///< pure; parameters are complete and checked, inputs have an accepted kind
};

/// The shapes given, in the order of the specs: each spec takes what it accepts until it is full, leaving enough for those
/// after it. Closed curves become a region where only regions are taken.
/// @throws Error InvalidInput such as "The input \"shape\" of Morph takes a region; it got a mesh.", also when there are too
/// few or too many.
Inputs arrangedInputs(const FeatureType&, std::span<const Shape> given);

/// @throws Error Internal when it is empty or of a kind that the feature type does not declare to give.
void checkGiven(const FeatureType&, const Shape& result);

/// Declares a feature type over a plain struct of parameters:
///   feature<SweepParameters>("sweep.sweep", "Sweep", "The exact surface ..")
///     .command("sweep").input({..}).parameter("mode", &P::mode, choice({"exact", "cubic"}), "..")
///     .evaluate([](const P& p, const Inputs& in, const Progress& progress) -> Evaluated { .. });
/// Defaults are those of a default-constructed P.
template <class P>
class FeatureBuilder {
 public:
  FeatureBuilder(std::string id, std::string title, std::string summary) {
    type_.id = std::move(id);
    type_.title = std::move(title);
    type_.summary = std::move(summary);
    type_.command = type_.id.substr(type_.id.rfind('.') + 1);
  }
  FeatureBuilder& command(std::string name) {
    type_.command = std::move(name);
    return *this;
  }
  FeatureBuilder& icon(std::string name) {
    type_.icon = std::move(name);
    return *this;
  }
  FeatureBuilder& example(std::string line) {
    type_.examples.push_back(std::move(line));
    return *this;
  }
  FeatureBuilder& byOutput(ChoiceByOutput choice) {
    type_.byOutput = std::move(choice);
    return *this;
  }
  FeatureBuilder& produces(std::vector<ShapeKind> kinds) {
    type_.produces = std::move(kinds);
    return *this;
  }
  FeatureBuilder& opens(ShapeKind kind) {
    type_.opens = kind;
    return *this;
  }
  FeatureBuilder& inputByFlags(InputByFlags flags) {
    type_.inputByFlags = std::move(flags);
    return *this;
  }
  FeatureBuilder& input(InputSpec spec) {
    type_.inputs.push_back(std::move(spec));
    return *this;
  }

  template <class T>
  FeatureBuilder& parameter(std::string name, T P::*member, ParameterSpec spec, std::string help) {
    spec.name = std::move(name);
    spec.help = std::move(help);
    spec.fallback = toValue(spec, P{}.*member);
    binders_->push_back([spec, member](P& p, const Value& all) {
      if (const auto it = all.find(spec.name); it != all.end() && !it->is_null()) fromValue(spec, *it, p.*member);
    });
    type_.parameters.push_back(std::move(spec));
    return *this;
  }

  template <class F>
  FeatureType evaluate(F function) {
    type_.evaluate = [binders = binders_, function](const Value& values, const Inputs& inputs, const Progress& progress) {
      P parameters{};
      for (const auto& bind : *binders) bind(parameters, values);
      return function(static_cast<const P&>(parameters), inputs, progress);
    };
    return std::move(type_);
  }

 private:
  FeatureType type_;
  std::shared_ptr<std::vector<std::function<void(P&, const Value&)>>> binders_ =
      std::make_shared<std::vector<std::function<void(P&, const Value&)>>>();
};

template <class P>
FeatureBuilder<P> feature(std::string id, std::string title, std::string summary) {
  return FeatureBuilder<P>(std::move(id), std::move(title), std::move(summary));
}

}  // namespace blossom
