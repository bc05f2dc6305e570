#include <fmt/format.h>

#include <filesystem>

#include "core/error.h"
#include "exchange/formats.h"
#include "samples.h"

/// make_sweep_samples FOLDER: writes the sample motions as JSON files.
int main(int argc, char** argv) {
  using namespace blossom;
  if (argc != 2) {
    fmt::print(stderr, "make_sweep_samples FOLDER\n");
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[1];
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
  } catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.message());
    return 1;
  }
  return 0;
}
