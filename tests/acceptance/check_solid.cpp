// check_solid SOLID.step MESH.stl DEFLECTION: is the solid closed and valid by OCCT's own check, and does the mesh enclose
// its volume? Prints JSON.
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace {

using Corner = std::array<float, 3>;

/// Volume by the divergence theorem, and whether every directed edge has its opposite (points compared bit by bit).
std::pair<double, bool> binaryStl(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  std::uint32_t count = 0;
  if (bytes.size() < 84) return {0, false};
  std::memcpy(&count, bytes.data() + 80, 4);
  if (bytes.size() != 84 + 50ull * count) return {0, false};
  double six = 0;
  std::map<std::pair<Corner, Corner>, int> edges;
  for (std::uint32_t t = 0; t < count; ++t) {
    std::array<Corner, 3> c;
    std::memcpy(c.data(), bytes.data() + 84 + 50ull * t + 12, 36);
    const auto [a, b, d] = c;
    six += double(a[0]) * (double(b[1]) * d[2] - double(b[2]) * d[1]) +
           double(a[1]) * (double(b[2]) * d[0] - double(b[0]) * d[2]) +
           double(a[2]) * (double(b[0]) * d[1] - double(b[1]) * d[0]);
    for (int k = 0; k < 3; ++k) {
      ++edges[{c[k], c[(k + 1) % 3]}];
      --edges[{c[(k + 1) % 3], c[k]}];
    }
  }
  bool closed = count > 0;
  for (const auto& [edge, balance] : edges) closed = closed && balance == 0;
  return {six / 6, closed};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "check_solid SOLID.step MESH.stl DEFLECTION\n";
    return 2;
  }
  std::cout.setstate(std::ios::failbit);  // OCCT talks on stdout
  STEPControl_Reader reader;
  const bool read = reader.ReadFile(argv[1]) == IFSelect_RetDone && reader.TransferRoots() > 0;
  std::cout.clear();
  if (!read) {
    std::cout << nlohmann::json{{"error", "cannot read STEP"}} << '\n';
    return 1;
  }
  const TopoDS_Shape shape = reader.OneShape();
  GProp_GProps volume, area;
  BRepGProp::VolumePropertiesGK(shape, volume, 1e-6, true);
  BRepGProp::SurfaceProperties(shape, area, 1e-6);
  int solids = 0;
  bool closed = true;
  for (TopExp_Explorer e(shape, TopAbs_SOLID); e.More(); e.Next(), ++solids)
    for (TopExp_Explorer s(e.Current(), TopAbs_SHELL); s.More(); s.Next())
      closed = closed && BRep_Tool::IsClosed(s.Current());
  const auto [meshVolume, meshClosed] = binaryStl(argv[2]);
  const double bound = area.Mass() * std::stod(argv[3]);
  std::cout << nlohmann::json{{"solids", solids},
                              {"valid", solids > 0 && closed && volume.Mass() > 0 && BRepCheck_Analyzer(shape).IsValid()},
                              {"volume", volume.Mass()},
                              {"mesh_volume", meshVolume},
                              {"mesh_closed", meshClosed},
                              {"volume_ratio", meshClosed ? std::abs(volume.Mass() - meshVolume) / bound : 1e9}}
            << '\n';
  return 0;
}
