#include "feature/frame_by_frame.h"

#include <fmt/format.h>

#include "core/frame_progress.h"
#include "feature/acceptance.h"
#include "feature/frame_summary.h"

namespace blossom {
namespace {

/// Calls a function with each sequence that is taken frame by frame.
template <class F>
void forEachSequence(const FeatureType& type, const Inputs& inputs, const F& function) {
  for (std::size_t spec = 0; spec < type.inputs.size(); ++spec)
    for (const Shape& shape : inputs.of(spec))
      if (takenByFrames(type.inputs[spec], shape)) function(*shape.get<Sequence>());
}

Inputs inputsOfFrame(const FeatureType& type, const Inputs& inputs, std::size_t frame) {
  std::vector<std::vector<Shape>> bySpec;
  bySpec.reserve(type.inputs.size());
  for (std::size_t spec = 0; spec < type.inputs.size(); ++spec) {
    auto& shapes = bySpec.emplace_back();
    for (const Shape& shape : inputs.of(spec))
      shapes.push_back(takenByFrames(type.inputs[spec], shape) ? shape.get<Sequence>()->frames.at(frame) : shape);
  }
  return Inputs(std::move(bySpec));
}

[[noreturn]] void throwNested(const FeatureType& type) {
  const std::string& frames = type.playedBy.parameter;
  throw Error(ErrorCode::InvalidInput,
              fmt::format("A sequence of sequences would come out: {} makes a sequence, and its input is one.", type.title),
              frames.empty()
                  ? "Take one frame out of the input with the command \"frame\"."
                  : fmt::format("Set \"{}\" to 0, so that each frame gives one shape, or take one frame out of the "
                                "input with the command \"frame\".",
                                frames));
}

/// What is known before anything is computed.
bool makesSequence(const FeatureType& type, const Value& parameters) {
  if (type.playedBy.parameter.empty() || !parameters.is_object()) return false;
  const auto frames = parameters.find(type.playedBy.parameter);
  return frames != parameters.end() && frames->is_number() && frames->get<double>() > 1;
}

Evaluated evaluatedOnce(const FeatureType& type, const Value& parameters, const Inputs& inputs, const Progress& progress) {
  progress.report(0);
  Evaluated made = type.evaluate(parameters, inputs, progress);
  if (made.shape.kind() == ShapeKind::Sequence) throwNested(type);
  checkResult(type, made.shape);
  refuseInfiniteFigures(made);
  return made;
}

}  // namespace

const Sequence* sequenceTakenByFrames(const FeatureType& type, const Inputs& inputs) {
  const Sequence* first = nullptr;
  forEachSequence(type, inputs, [&](const Sequence& sequence) { first = first ? first : &sequence; });
  return first;
}

void checkFrames(const FeatureType& type, const Inputs& inputs) {
  const Sequence* first = sequenceTakenByFrames(type, inputs);
  if (!first) return;
  if (first->frames.size() > maximumFrames)
    throw Error(ErrorCode::LimitExceeded,
                fmt::format("A sequence of {} frames is too long for {}; at most {} are taken.", first->frames.size(),
                            type.title, maximumFrames),
                "Make it of fewer frames, or bring it down with the command \"sequence-retime\".");
  forEachSequence(type, inputs, [&](const Sequence& sequence) {
    if (sequence.frames.size() == first->frames.size()) return;
    throw Error(
        ErrorCode::InvalidInput,
        fmt::format("{} takes sequences frame by frame, and one has {} frames, another {}.", type.title,
                    first->frames.size(), sequence.frames.size()),
        "Make them of as many frames, or bring one to the number of the other with the command \"sequence-retime\".");
  });
}

std::string frameName(const Sequence& sequence, std::size_t frame) {
  if (sequence.times.size() != sequence.frames.size()) return fmt::format("Frame {}", frame + 1);
  return fmt::format("Frame {} (t = {:.4g})", frame + 1, sequence.times[frame]);
}

void throwInFrame(const Sequence& sequence, std::size_t frame, const Error& error) {
  if (error.code() == ErrorCode::Cancelled) throw error;
  throw Error(error.code(), fmt::format("{}: {}", frameName(sequence, frame), error.message()), error.hint());
}

Evaluated evaluatedFeature(const FeatureType& type, const Value& parameters, const Inputs& inputs,
                           const Progress& progress) {
  const Sequence* leading = sequenceTakenByFrames(type, inputs);
  if (!leading) return type.evaluate(parameters, inputs, progress);
  checkFrames(type, inputs);
  if (makesSequence(type, parameters)) throwNested(type);
  const std::size_t count = leading->frames.size();
  Sequence result;
  result.frames.reserve(count);
  result.times = leading->times;
  FrameSummary summary;
  for (std::size_t k = 0; k < count; ++k) {
    Evaluated made = inFrame(*leading, k, [&] {
      return evaluatedOnce(type, parameters, inputsOfFrame(type, inputs, k), progressOfFrame(progress, k, count));
    });
    result.frames.push_back(std::move(made.shape));
    summary.add(std::move(made));
  }
  Evaluated all = summary.told();
  all.shape = std::move(result);
  return all;
}

}  // namespace blossom
