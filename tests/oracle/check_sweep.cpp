// check_sweep MOTION.json FILE.step|.igs [COUNT]: compares an exported sweep with M(u,v) p at COUNT random parameters.
// Prints JSON.
#include "sweep_checker.h"

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "check_sweep MOTION.json FILE.step|.igs [COUNT]\n";
    return 2;
  }
  try {
    const sweep_checker::MotionFile motion(argv[1]);
    const auto surface = sweep_checker::readSurface(argv[2]);
    std::mt19937_64 random(20091);
    const double error = sweep_checker::largestError(motion, *surface, argc > 3 ? std::stoi(argv[3]) : 10000, random);
    std::cout << nlohmann::json{{"degree_u", surface->UDegree()},
                                {"degree_v", surface->VDegree()},
                                {"poles_u", surface->NbUPoles()},
                                {"poles_v", surface->NbVPoles()},
                                {"rational", surface->IsURational() || surface->IsVRational()},
                                {"max_error", error}}
              << '\n';
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
