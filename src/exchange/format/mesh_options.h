#pragma once
#include <vector>

#include "core/progress.h"
#include "exchange/format/format.h"
#include "geometry/mesh/mesh.h"
#include "geometry/tessellate/tessellate.h"
#include "parameter/parameter.h"

/// What the readers and writers of polygon meshes share. OBJ, OFF, PLY and STL are read by hand because VTK's readers keep
/// coordinates in single precision and no creases.
namespace blossom {

/// `chord`: how near the polygons come to a curved shape.
ParameterSpec chordOption();
/// `ascii`: text in place of binary.
ParameterSpec asciiOption();
TessellationOptions tessellationOptions(const Value& options);
/// Kinds that become polygons.
std::vector<ShapeKind> meshableKinds();
/// @throws Error FormatDamaged when the mesh has no face.
Imported importedMesh(Mesh, std::vector<std::string> warnings = {});
/// Calls `write(i)` for every i below `count`, telling how far it is. @throws Error Cancelled.
template <class Write>
void writeEach(std::size_t count, const Progress& progress, Write&& write) {
  for (std::size_t i = 0; i < count; ++i) {
    progress.report(static_cast<double>(i) / static_cast<double>(count));
    write(i);
  }
}
/// Text or bytes to a file that the caller made room for. @throws Error FileUnwritable.
void writeBytes(const std::filesystem::path&, std::string_view);

}  // namespace blossom
