#include "transport/mesh_transport.h"

#include <fstream>

#include "transport/bulk_file.h"
#include "transport/numbers.h"

namespace blossom {

// Both sides are one build on one machine: numbers travel as they lie in memory.
Value saveMesh(const Mesh& mesh, const std::filesystem::path& folder, const std::string& name) {
  const std::filesystem::path file = folder / (name + ".mesh");
  std::ofstream stream(file, std::ios::binary);
  writeArray(stream, mesh.points);
  writeArray(stream, mesh.faceStarts);
  writeArray(stream, mesh.faceVertices);
  writeArray(stream, mesh.creases);
  writeArray(stream, mesh.corners);
  finishBulkFile(stream, file);
  return {{"file", file.filename().string()},
          {"other_tags", mesh.otherTags},
          {"name", mesh.name},
          {"color", colorValue(mesh.color)},
          {"flat_faces", mesh.flatFaces}};
}

Mesh loadMesh(const Value& value, const std::filesystem::path& folder) {
  std::ifstream stream(folder / value.at("file").get<std::string>(), std::ios::binary);
  Mesh mesh;
  mesh.points = readArray<Vec3>(stream);
  mesh.faceStarts = readArray<int>(stream);
  mesh.faceVertices = readArray<int>(stream);
  mesh.creases = readArray<Crease>(stream);
  mesh.corners = readArray<Corner>(stream);
  mesh.otherTags = value.at("other_tags").get<std::vector<std::string>>();
  mesh.name = value.at("name");
  mesh.color = toColor(value.at("color"));
  mesh.flatFaces = value.at("flat_faces");
  return mesh;
}

}  // namespace blossom
