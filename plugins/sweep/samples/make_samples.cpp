#include <filesystem>

#include "app/sample_maker.h"
#include "documents.h"
#include "exchange/formats.h"
#include "samples.h"

/// make_sweep_samples FOLDER: writes the sample motions as JSON files, and the documents whose trees hold edits.
int main(int argc, char** argv) {
  using namespace blossom;
  return samples::run(argc, argv, [](const App& app, const std::filesystem::path& folder) {
    const Format format = motionFormat();
    const auto write = [&](const Motion& motion, const char* name) {
      format.write(motion, folder / name, Value::object(), Progress::none());
    };
    write(sweep::samples::cylinder(), "cylinder.json");
    write(sweep::samples::torus(), "torus.json");
    write(sweep::samples::helicoid(), "helicoid.json");
    write(sweep::samples::twistedTube(), "twisted-tube.json");
    write(sweep::samples::horn(), "horn.json");
    write(sweep::samples::propeller(), "propeller.json");
    write(sweep::samples::sweptPoint(), "swept-point.json");
    sweep::samples::writeFigureSeven(app, folder);
    sweep::samples::writeFigures(app, folder);
    sweep::samples::writeThings(app, folder);
  });
}
