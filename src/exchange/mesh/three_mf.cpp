#include <fmt/format.h>

#include "core/units.h"
#include "core/zip_archive.h"
#include "exchange/format/format.h"
#include "exchange/format/mesh_options.h"
#include "exchange/format/xml_text.h"
#include "exchange/mesh/three_mf_read.h"
#include "geometry/mesh/mesh_topology.h"

// 3D Manufacturing Format, for 3D printing: a zip (an OPC package) whose part 3D/3dmodel.model is XML.
// Source: 3MF Core Specification 1.3.
namespace blossom {
namespace {

constexpr std::string_view contentTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
 <Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
 <Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";

constexpr std::string_view relationships =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
 <Relationship Target="/3D/3dmodel.model" Id="model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

std::string modelText(const Mesh& mesh, const std::string& name, const Progress& progress) {
  std::string out = R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
 <metadata name="Application">Blossom</metadata>
 <resources>
)";
  // The type "model" is for closed objects alone (section 4.1).
  out += fmt::format("  <object id=\"1\" type=\"{}\"",
                     meshTopology(mesh, progress.part(0, 0.2)).closed() ? "model" : "surface");
  if (!name.empty()) out += fmt::format(" name=\"{}\"", escapedXml(name));
  out += ">\n   <mesh>\n    <vertices>\n";
  writeEach(mesh.points.size(), progress.part(0.2, 0.5), [&](std::size_t i) {
    const Vec3& p = mesh.points[i];
    out += fmt::format("     <vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n", formatNumber(p.x()), formatNumber(p.y()),
                       formatNumber(p.z()));
  });
  out += "    </vertices>\n    <triangles>\n";
  writeEach(mesh.faceCount(), progress.part(0.5, 1), [&](std::size_t f) {
    const auto face = mesh.face(f);
    out += fmt::format("     <triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n", face[0], face[1], face[2]);
  });
  return out +
         "    </triangles>\n   </mesh>\n  </object>\n </resources>\n <build>\n  <item objectid=\"1\"/>\n "
         "</build>\n</model>\n";
}

void writeThreeMf(const Shape& shape, const std::filesystem::path& path, const Value& options, const Progress& progress) {
  const Mesh mesh = meshOf(shape, tessellationOptions(options), progress.part(0, 0.2));
  const std::string model = modelText(triangulated(mesh, progress.part(0.2, 0.3)).first, mesh.name, progress.part(0.3, 0.7));
  writeZip(path, {{"[Content_Types].xml", contentTypes}, {"_rels/.rels", relationships}, {"3D/3dmodel.model", model}},
           progress.part(0.7, 1));
}

}  // namespace

Format threeMfFormat() {
  Format format;
  format.id = "3mf";
  format.title = "3MF (3D manufacturing)";
  format.extensions = {"3mf"};
  format.writeOptions = {chordOption()};
  format.read = [](const std::filesystem::path& path, const Value&, const Progress& progress) {
    return readThreeMf(path, progress);
  };
  format.write = writeThreeMf;
  format.writes = meshableKinds();
  format.zipped = true;
  return format;
}

}  // namespace blossom
