#include <fmt/format.h>

#include "core/error.h"
#include "feature_groups.h"
#include "kernel/parts/sequence_times.h"

namespace blossom::modeling {
namespace {

InputSpec sequenceInput(const char* help, const char* asks) {
  return {.name = "sequence", .help = help, .kinds = {ShapeKind::Sequence}, .use = InputUse::Consumed, .asks = asks};
}

struct FrameParameters {
  int number = 1;
  Value time;  ///< null: the frame is told by its number
};

Evaluated takenFrame(const FrameParameters& p, const Inputs& inputs, const Progress& progress) {
  progress.check();
  const auto& sequence = inputs.get<Sequence>();
  const std::size_t count = sequence.frames.size();
  std::size_t index = static_cast<std::size_t>(p.number) - 1;
  std::vector<std::string> warnings;
  const std::vector<double> times = frameTimes(sequence);
  if (!p.time.is_null() && !times.empty()) {
    const double time = p.time.get<double>();
    index = nearestFrame(sequence, time);
    if (time < times.front() || time > times.back())
      warnings.push_back(fmt::format("The time {:g} lies outside of the sequence, whose frames are from {:g} to {:g}.", time,
                                     times.front(), times.back()));
  } else if (index >= count)
    throw Error(
        ErrorCode::InvalidParameter,
        fmt::format("Frame {} is asked for, and the sequence has {} frame{}.", p.number, count, count == 1 ? "" : "s"),
        count == 0 ? "Mend the feature that it comes from." : fmt::format("Give a number from 1 to {}.", count));
  return {sequence.frames[index], {{"frame", index + 1}, {"frame_time", times[index]}}, std::move(warnings)};
}

FeatureType frameFeature() {
  using P = FrameParameters;
  return feature<P>("modeling.frame", "Frame", "One shape out of a sequence.")
      .icon("frame")
      .keywords({"still", "in-between", "snapshot", "take out", "extract frame"})
      .input(sequenceInput("The sequence that the shape is taken out of.", "a sequence to take a frame out of"))
      .parameter("number", &P::number, count(1, static_cast<int>(maximumFrames)), "Which frame, counted from 1.")
      .parameter("time", &P::time, whenNone(optional(number()), "the frame of that number"),
                 "In place of the number: the frame whose time is nearest to this; of two the earlier one.")
      .takesFrame("number")
      .example("blossom frame walk.blossom --number 7 -o seventh.svg")
      .example("blossom frame walk.blossom --time 0.25 -o quarter.step")
      .evaluate(takenFrame);
}

enum class JoinTimes { Even, Lengths };

struct JoinParameters {
  JoinTimes times = JoinTimes::Even;
  bool mergeEnds = false;
};

FeatureType joinFeature() {
  using P = JoinParameters;
  return feature<P>("modeling.sequence-join", "Join sequences", "Sequences and single shapes, one after the other.")
      .icon("sequence-join")
      .keywords({"concatenate", "append", "chain", "film"})
      .input({.name = "parts",
              .help = "Sequences, and single shapes, each of which is one frame.",
              .kinds = {},
              .minimum = 2,
              .maximum = anyNumber,
              .use = InputUse::Consumed,
              .asks = "a sequence or a shape to join"})
      .parameter("times", &P::times, choice({"even", "lengths"}),
                 "Even: the frames are spread evenly from 0 to 1; lengths: each sequence keeps its share of the time.")
      .parameter("merge-ends", &P::mergeEnds, flag(),
                 "Leave out the first frame of each sequence that comes after another part, as it repeats the end of that.")
      .example("blossom sequence-join there.blossom back.blossom --merge-ends -o loop.svg --svg.animate")
      .evaluate([](const P& p, const Inputs& inputs, const Progress& progress) {
        progress.check();
        return Evaluated{joinedInTime(inputs.of(0), {p.times == JoinTimes::Lengths, p.mergeEnds}), Value::object(), {}};
      });
}

struct RetimeParameters {
  bool reverse = false;
  Ease ease = Ease::Linear;
  int frames = 0;
};

FeatureType retimeFeature() {
  using P = RetimeParameters;
  return feature<P>("modeling.sequence-retime", "Retime sequence",
                    "A sequence played backwards, with a slow begin or end, or in another number of frames.")
      .icon("sequence-retime")
      .keywords({"ease", "ease in", "slow in", "smooth", "speed", "resample"}, {{"ease", "in-out"}})
      .keywords({"reverse", "backwards", "rewind"}, {{"reverse", true}})
      .input(sequenceInput("The sequence to play another way.", "a sequence to retime"))
      .parameter("reverse", &P::reverse, flag(), "Play it backwards.")
      .parameter("ease", &P::ease, choice({"linear", "in", "out", "in-out"}),
                 "How it gets going: in begins slowly (s^2), out ends slowly, in-out does both (smoothstep, 3 s^2 - 2 s^3).")
      .parameter(
          "frames", &P::frames, count(0, static_cast<int>(maximumFrames)),
          "Number of frames, at even times, each the nearest one there is: none is computed anew. 0 keeps the frames and "
          "moves their times.")
      .example("blossom sequence-retime walk.blossom --ease in-out --frames 49 -o soft.svg")
      .example("blossom sequence-retime walk.blossom --reverse -o back.svg --svg.animate")
      .evaluate([](const P& p, const Inputs& inputs, const Progress& progress) {
        progress.check();
        return Evaluated{
            retimed(inputs.get<Sequence>(), {p.reverse, p.ease, static_cast<std::size_t>(p.frames)}), Value::object(), {}};
      });
}

}  // namespace

void registerSequenceFeatures(Registry& registry) { registry.addAll(frameFeature(), joinFeature(), retimeFeature()); }

}  // namespace blossom::modeling
