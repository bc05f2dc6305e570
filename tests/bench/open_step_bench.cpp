// Opening a STEP file of about 1 MB: Blossom with its child process against OCCT's own reader in this process. "Of the same"
// is the work that must be done in both: the file read and its shapes built.
#include <benchmark/benchmark.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TDocStd_Document.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_DocumentTool.hxx>

#include <cstdlib>

#include "core/file.h"
#include "core/memory.h"
#include "exchange/formats.h"
#include "geometry/occt/occt.h"
#include "support/support.h"
#include "worker/worker.h"

using namespace blossom;

namespace {

/// A bicubic surface of waves, 40 x 40 poles: about 110 KB of STEP.
Surface waves(double phase) {
  Surface surface;
  surface.degreeU = surface.degreeV = 3;
  const int count = 40;
  for (auto* knots : {&surface.knotsU, &surface.knotsV}) {
    knots->assign(4, 0);
    for (int i = 1; i <= count - 4; ++i) knots->push_back(i);
    knots->insert(knots->end(), 4, count - 3);
  }
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j)
      surface.poles.emplace_back(i, j, std::sin(phase + 0.3 * i) * std::cos(0.4 * j) + 3 * phase,
                                 1 + 0.1 * std::sin(i + 2.0 * j));
  return surface;
}

/// linkrods.step (1.8 MB) where the shared data are; else a generated file of about 1 MB.
test::fs::path stepFile() {
  static const TemporaryFolder folder;
  static const test::fs::path file = [] {
    const test::fs::path real = test::sharedData() / "step/linkrods.step";
    if (test::fs::exists(real)) return real;
    BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (int i = 0; i < 10; ++i) builder.Add(compound, toFace(waves(i)));
    const test::fs::path made = folder.path() / "waves.step";
    writeShape(standardFormats(), Brep(compound, "Waves"), made);
    return made;
  }();
  return file;
}

void BM_OpenStepBlossom(benchmark::State& state) {
  const test::fs::path file = stepFile();
  const FormatRegistry formats = standardFormats();
  for (auto _ : state) {
    state.PauseTiming();
    endIdleWorkers();  // the start of a helper process is part of what is measured
    state.ResumeTiming();
    benchmark::DoNotOptimize(readShape(formats, file).shape.kind());
  }
  state.counters["bytes"] = static_cast<double>(test::fs::file_size(file));
}

void BM_OpenStepOcct(benchmark::State& state) {
  const test::fs::path file = stepFile();
  for (auto _ : state) {
    STEPCAFControl_Reader reader;
    if (reader.ReadFile(file.c_str()) != IFSelect_RetDone) state.SkipWithError("OCCT cannot read the file");
    Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
    XCAFDoc_DocumentTool::Set(document->Main(), Standard_False);
    benchmark::DoNotOptimize(reader.Transfer(document));
  }
}

}  // namespace

BENCHMARK(BM_OpenStepBlossom)->Unit(benchmark::kMillisecond)->UseRealTime()->MinTime(3);
BENCHMARK(BM_OpenStepOcct)->Unit(benchmark::kMillisecond)->UseRealTime()->MinTime(3);

int main(int argc, char** argv) {
  blossom::keepFreedMemory();  // as the programs do
  if (!std::getenv("BLOSSOM_WORKER")) ::setenv("BLOSSOM_WORKER", (test::buildFolder() / "bin/blossom-worker").c_str(), 0);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
