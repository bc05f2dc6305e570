#include "exchange/format/mesh_options.h"

#include <fmt/format.h>

#include <fstream>

#include "core/error.h"

namespace blossom {

ParameterSpec chordOption() {
  ParameterSpec spec = length();
  spec.name = "chord";
  spec.help = "Largest distance between a curved shape and its polygons; 0: a thousandth of its size.";
  spec.fallback = 0.05;
  spec.minimum = 0;
  return spec;
}

ParameterSpec asciiOption() {
  ParameterSpec spec = flag();
  spec.name = "ascii";
  spec.help = "Write text instead of binary.";
  spec.fallback = false;
  return spec;
}

TessellationOptions tessellationOptions(const Value& options) { return {.chord = options.value("chord", 0.05)}; }

std::vector<ShapeKind> meshableKinds() { return {ShapeKind::Mesh, ShapeKind::Brep, ShapeKind::Surface, ShapeKind::Region}; }

Imported importedMesh(Mesh mesh, std::vector<std::string> warnings) {
  if (mesh.faceCount() == 0 && !mesh.points.empty())
    throw Error(ErrorCode::FormatDamaged, fmt::format("It holds {} points, but no face.", mesh.points.size()),
                "A cloud of points is read from a file that ends in xyz; a shape needs faces.");
  if (mesh.faceCount() == 0)
    throw Error(ErrorCode::FormatDamaged, "It holds no face.", "The file is damaged or was not written completely.");
  Imported imported;
  imported.entities = {{"vertex", mesh.points.size()}, {"face", mesh.faceCount()}};
  imported.warnings = std::move(warnings);
  imported.shape = Shape(std::move(mesh));
  return imported;
}

void writeBytes(const std::filesystem::path& path, std::string_view bytes) {
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.flush();
  if (!stream)
    throw Error(ErrorCode::FileUnwritable, fmt::format("\"{}\" cannot be written.", path.string()), "Is the disk full?");
}

}  // namespace blossom
