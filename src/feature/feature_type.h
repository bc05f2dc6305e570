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

/// What becomes of the shape of an input once the feature has a result.
enum class InputUse {
  Kept,      ///< it stays beside the result
  Consumed,  ///< it has gone into the result, which is drawn in its place
  Outline,   ///< so has an outline; a solid stays, of which only a face or edges are used
  Control,   ///< a control shape: it stays as a translucent outline under the result
  Edited,    ///< consumed, and changed: a new feature goes between the shape and what is made of it already
  Step       ///< consumed, as a step on the way that edits make: what edits add after it is no part of it
};

/// One input of a feature type, or several consecutive inputs of the same kinds.
struct InputSpec {
  std::string name;  ///< "shape", "motion"
  std::string help;
  std::vector<ShapeKind>
      kinds;  ///< accepted kinds; empty means any. A region input also accepts closed curves, converted by arrangedInputs.
              ///< A sequence is taken frame by frame, unless Sequence is one of them (see frame_by_frame.h).
  std::size_t minimum = 1;
  std::size_t maximum = 1;
  InputUse use = InputUse::Kept;
  bool points = false;    ///< a region input that also takes a single point, as a drawing (single_point.h)
  std::string asks = {};  ///< asked for as: "an outline to extrude"; empty: by the names of the kinds
  /// On the command line a file given for it is imported with these options: {"gcode": {"as": "toolpath"}}.
  Value importedWith = Value::object();
};

inline constexpr std::size_t anyNumber = std::numeric_limits<std::size_t>::max();

/// Result of an evaluation.
struct Evaluated {
  Shape shape;
  Value stats = Value::object();  ///< counts and figures of the computation, for `stats` of `--json` and the result panel
  std::vector<std::string> warnings;  ///< full sentences
  /// Entries of `result` that the feature type adds to the measures of the shape, such as the errors of a fit.
  std::vector<Measure> figures = {};
};

/// Checks that all numbers of the statistics and figures are finite; JSON would print others as null.
/// @throws Error LimitExceeded that names the figure.
void refuseInfiniteFigures(const Evaluated&);

/// Measures of the shape followed by the figures of the result. @throws Error Cancelled.
Measures measured(const Evaluated&, const Progress& = Progress::none());

/// The input shapes of an evaluation, grouped by InputSpec in the order of declaration.
class Inputs {
 public:
  Inputs() = default;
  explicit Inputs(std::vector<std::vector<Shape>> bySpec) : bySpec_(std::move(bySpec)) {}
  [[nodiscard]] std::span<const Shape> of(std::size_t spec) const { return bySpec_.at(spec); }
  /// The value of one input shape. @throws Error InvalidInput when the shape is of another kind.
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

/// Default of a choice parameter that depends on the file extension of the command's first output: a mesh for STL, faces for
/// STEP.
struct ChoiceByOutput {
  std::string parameter;                                          ///< name of the choice parameter; empty: none
  std::vector<std::pair<std::string, std::string>> byExtensions;  ///< {"step iges", "faces"}, ..
};

/// Lets other commands create this feature as one of their inputs by flags alone, when it has no inputs itself and their
/// input accepts its result: `pocket --text Blossom --font "DejaVu Serif" --text.height 20`.
struct InputByFlags {
  std::string asks;                     ///< parameter whose flag creates the input; empty: no such flags
  std::vector<std::string> plain = {};  ///< parameters whose flags have no prefix "ASKS."
};

/// How a feature becomes a sequence that plays.
struct PlayedBy {
  std::string parameter;  ///< a count: how many shapes the sequence has; empty: the feature never makes one
  int frames = 25;        ///< as many as Play asks for
  std::string keys = {};  ///< a list as frameKeys() declares it (frame_keys.h); empty: the timeline shows no keys
  /// A list that says which one shape the feature makes: with anything in it there is no sequence to play.
  std::string excludedBy = {};
};

/// Another word by which users look for a feature type.
struct Keyword {
  std::string word;                ///< in lower case: "subtract", "push pull"
  Value preset = Value::object();  ///< parameters that a feature begins with when it is asked for by this word
};

struct InputImage;

/// A shape that was opened, taken apart into features.
struct TakenApart {
  struct Step {
    std::string type;  ///< id of a feature type with one input
    Value parameters = Value::object();
  };
  Value importedWith = Value::object();  ///< parameters by which the import reads the shape without the steps
  std::vector<Step> steps = {};          ///< each with the one before as its input, the first with the import
};

/// A feature type, declared once. Command, flags, help, dialog, panel, undo text, document format and manual page are
/// derived from it.
struct FeatureType {
  using Evaluate = std::function<Evaluated(const Value& parameters, const Inputs&, const Progress&)>;

  std::string id;       ///< "sweep.sweep": plugin, dot, name
  std::string command;  ///< "sweep"
  std::string title;    ///< "Sweep"
  std::string summary;  ///< one sentence
  std::string icon;     ///< name of a file in resources/icons; empty: the icon of the plugin
  std::vector<InputSpec> inputs;
  std::vector<ParameterSpec> parameters;
  std::vector<ShapeKind> produces;    ///< kinds of the result, or of its frames when it is a sequence; empty: any
  std::vector<std::string> examples;  ///< command lines for --help
  ChoiceByOutput byOutput = {};
  InputByFlags inputByFlags = {};
  PlayedBy playedBy = {};
  /// A count: cells along the largest side of a preview that is shown while something is dragged, 0 for the exact result;
  /// empty: the feature has no previews.
  std::string previewedBy = {};
  /// A count from 1, the number of a frame of the first input: where a sequence is seen, that of the frame which is shown is
  /// what the feature begins with; empty: it takes no frame.
  std::string takesFrame = {};
  /// When a file of this kind is opened, a feature of this type with the file as its only input follows; None: never.
  ShapeKind opens = ShapeKind::None;
  /// What goes between the import and the feature that opens the shape; not set: nothing. Only where `opens` is set.
  std::function<TakenApart(const Shape&)> takesApart = {};
  /// Pure; parameters are complete and checked, inputs have an accepted kind, sequences only where that is declared. Called
  /// through evaluatedFeature, by which sequences are taken frame by frame.
  Evaluate evaluate;
  /// Where the inputs lie in the result, by which its faces are traced back to theirs (see input_image.h); not set: each
  /// input where it is.
  std::function<std::vector<InputImage>(const Value& parameters, const Inputs&)> images = {};
  /// What the result depends on beside parameters and inputs, as a text that changes with it, such as the state of a font
  /// file; not set: nothing.
  std::function<std::string(const Value& parameters)> dependsOn = {};
  std::vector<Keyword> keywords = {};
};

/// Assigns the shapes to the inputs in the order of declaration: each input receives the shapes it accepts until it is full,
/// while enough are left for the inputs after it. Closed curves are converted to a region where only regions are accepted.
/// A sequence stands for its frames where the input takes no sequences as they are: evaluatedFeature evaluates those.
/// @throws Error InvalidInput such as "The input \"shape\" of Morph takes a region; it got a mesh.", also for too few or too
/// many shapes, and for sequences that do not go together frame by frame.
Inputs arrangedInputs(const FeatureType&, std::span<const Shape> given);

/// @throws Error Internal when the result is empty or of a kind that the feature type does not declare in `produces`.
void checkResult(const FeatureType&, const Shape& result);

/// Declares a feature type over a plain struct of parameters:
///   feature<SweepParameters>("sweep.sweep", "Sweep", "The exact surface ..")
///     .command("sweep").input({..}).parameter("mode", &P::mode, choice({"exact", "cubic"}), "..")
///     .evaluate([](const P& p, const Inputs& in, const Progress& progress) -> Evaluated { .. });
/// Defaults of the parameters are those of a default-constructed P.
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
  FeatureBuilder& keywords(std::vector<std::string> words, const Value& preset = Value::object()) {
    for (std::string& word : words) type_.keywords.push_back({std::move(word), preset});
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
  FeatureBuilder& takesApart(std::function<TakenApart(const Shape&)> function) {
    type_.takesApart = std::move(function);
    return *this;
  }
  FeatureBuilder& inputByFlags(InputByFlags flags) {
    type_.inputByFlags = std::move(flags);
    return *this;
  }
  FeatureBuilder& playedBy(PlayedBy played) {
    type_.playedBy = std::move(played);
    return *this;
  }
  FeatureBuilder& previewedBy(std::string parameter) {
    type_.previewedBy = std::move(parameter);
    return *this;
  }
  FeatureBuilder& takesFrame(std::string parameter) {
    type_.takesFrame = std::move(parameter);
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
  FeatureBuilder& images(F function) {
    type_.images = [binders = binders_, function](const Value& values, const Inputs& inputs) {
      return function(bound(*binders, values), inputs);
    };
    return *this;
  }

  template <class F>
  FeatureBuilder& dependsOn(F function) {
    type_.dependsOn = [binders = binders_, function](const Value& values) { return function(bound(*binders, values)); };
    return *this;
  }

  template <class F>
  FeatureType evaluate(F function) {
    type_.evaluate = [binders = binders_, function](const Value& values, const Inputs& inputs, const Progress& progress) {
      return function(bound(*binders, values), inputs, progress);
    };
    return std::move(type_);
  }

 private:
  using Binders = std::vector<std::function<void(P&, const Value&)>>;
  static P bound(const Binders& binders, const Value& values) {
    P parameters{};
    for (const auto& bind : binders) bind(parameters, values);
    return parameters;
  }

  FeatureType type_;
  std::shared_ptr<Binders> binders_ = std::make_shared<Binders>();
};

template <class P>
FeatureBuilder<P> feature(std::string id, std::string title, std::string summary) {
  return FeatureBuilder<P>(std::move(id), std::move(title), std::move(summary));
}

}  // namespace blossom
