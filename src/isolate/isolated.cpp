#include "isolate/isolated.h"

#include <unistd.h>

#include <chrono>

#include "core/file.h"
#include "results/evaluated_transport.h"
#include "transport/shape_transport.h"
#include "worker/worker.h"

namespace blossom {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

Value savedInputs(const FeatureType& type, const Inputs& inputs, const fs::path& folder) {
  Value bySpec = Value::array();
  int count = 0;
  for (std::size_t spec = 0; spec < type.inputs.size(); ++spec) {
    Value shapes = Value::array();
    for (const Shape& shape : inputs.of(spec)) shapes.push_back(saveShape(shape, folder, "input" + std::to_string(count++)));
    bySpec.push_back(std::move(shapes));
  }
  return bySpec;
}

Inputs loadedInputs(const Value& bySpec, const fs::path& folder) {
  std::vector<std::vector<Shape>> inputs;
  inputs.reserve(bySpec.size());
  for (const Value& shapes : bySpec) {
    auto& loaded = inputs.emplace_back();
    for (const Value& shape : shapes) loaded.push_back(loadShape(shape, folder));
  }
  return Inputs(std::move(inputs));
}

/// The child's side.
Value serve(const FeatureType::Evaluate& evaluate, const Value& arguments, const fs::path& folder,
            const Progress& progress) {
  const Inputs inputs = loadedInputs(arguments.at("inputs"), folder);
  const auto start = Clock::now();
  const Evaluated made = evaluate(arguments.at("parameters"), inputs, progress);
  const double kernelMs = millisecondsSince(start);
  refuseInfiniteFigures(made);  // on the way they would become null
  return {{"made", saveEvaluated(made, folder, "result")}, {"kernel_ms", kernelMs}};
}

/// Whether nothing in it has a name or a colour.
bool isPlain(const Brep& brep) {
  if (brep.roots().size() != 1 || !brep.roots().front().part) return false;
  const BrepInstance& root = brep.roots().front();
  const BrepPart& part = *root.part;
  return root.name.empty() && !root.color && part.name.empty() && !part.color && part.subShapeColors.empty() &&
         part.children.empty();
}

/// A B-rep that its maker gave neither names nor colours has those of the first B-rep it was made of. Control shapes, such
/// as the target of a deformation, are not what it is made of.
Shape namedLike(const Shape& made, const FeatureType& type, const Inputs& inputs) {
  const Brep* brep = made.get<Brep>();
  if (!brep || !isPlain(*brep)) return made;
  for (std::size_t spec = 0; spec < type.inputs.size(); ++spec) {
    if (type.inputs[spec].use == InputUse::Control) continue;
    for (const Shape& input : inputs.of(spec))
      if (const Brep* first = input.get<Brep>(); first && !first->roots().empty()) {
        const BrepInstance& root = first->roots().front();
        return Brep(brep->shape(), root.name, root.color || !root.part ? root.color : root.part->color);
      }
  }
  return made;
}

/// In one child. The time its kernel took is in the statistics as "kernel_ms".
Evaluated evaluateInWorker(const FeatureType& type, const WorkerOptions& options, const Value& parameters,
                           const Inputs& inputs, const Progress& progress) {
  const TemporaryFolder folder;
  const Value arguments{{"parameters", parameters}, {"inputs", savedInputs(type, inputs, folder.path())}};
  const Value answer = runInWorker(type.id, arguments, folder.path(), progress, options);
  Evaluated made = loadEvaluated(answer.at("made"), folder.path());
  made.shape = namedLike(made.shape, type, inputs);
  made.stats["kernel_ms"] = answer.at("kernel_ms");
  return made;
}

Evaluated evaluateTimed(const FeatureType& type, const IsolationOptions& isolation, const Value& parameters,
                        const Inputs& inputs, const Progress& progress) {
  const auto start = Clock::now();
  const WorkerOptions options{.activity = isolation.activity, .module = isolation.module};
  Evaluated made = evaluateInWorker(type, options, parameters, inputs, progress);
  const double kernelMs = made.stats.at("kernel_ms");
  made.stats.erase("kernel_ms");
  made.stats["worker_ms"] = millisecondsSince(start) - kernelMs;
  return made;
}

}  // namespace

FeatureType isolated(FeatureType type, IsolationOptions options) {
  const auto direct = type.evaluate;
  registerWorkerCall(type.id, [direct](const Value& arguments, const fs::path& folder, const Progress& progress) {
    return serve(direct, arguments, folder, progress);
  });
  FeatureType made = type;
  made.evaluate = [type = std::move(type), options = std::move(options)](const Value& parameters, const Inputs& inputs,
                                                                         const Progress& progress) {
    if (options.when && !options.when(parameters, inputs)) return type.evaluate(parameters, inputs, progress);
    return evaluateTimed(type, options, parameters, inputs, progress);
  };
  return made;
}

}  // namespace blossom
