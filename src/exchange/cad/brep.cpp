#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BinTools.hxx>
#include <Geom_Curve.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <fstream>

#include "exchange/cad/brep_export.h"
#include "exchange/cad/brep_import.h"
#include "exchange/cad/occt_io.h"
#include "exchange/cad/xcaf_write.h"
#include "exchange/format/axis_curves.h"

namespace blossom {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void throwDamaged() {
  throw Error(ErrorCode::FormatDamaged, "Its shapes cannot be read: it was cut off, or is not a BREP file.",
              "Fetch or export the file again.");
}

/// "Open CASCADE Topology V3" starts a binary file, "CASCADE Topology V1, (c) Matra-Datavision" a text file.
bool isBinary(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string head(64, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  return head.find("Open CASCADE Topology V") != std::string::npos;
}

/// Numbers of 15 digits let ranges of edges pass the ends of their curves by a rounding, which OCCT's algorithms refuse.
void trimRangesToCurves(const TopoDS_Shape& shape) {
  constexpr double rounding = 1e-7;  // of the curve
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
    TopLoc_Location place;
    double first = 0, last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, place, first, last);
    if (curve.IsNull() || curve->IsPeriodic()) continue;
    const double low = curve->FirstParameter(), high = curve->LastParameter(), within = rounding * (high - low);
    const bool passes = first < low || last > high;
    if (passes && first >= low - within && last <= high + within)
      BRep_Builder().Range(edge, std::max(first, low), std::min(last, high));
  }
}

}  // namespace

void writeBrep(const Brep& brep, const std::string& path, const Value&, const Progress& progress) {
  withOcctErrors(ErrorCode::FileUnwritable, "The shape cannot be written as BREP.", [&] {
    std::ofstream stream(path, std::ios::binary);
    Handle(OcctProgress) watcher = new OcctProgress(progress, "Writing");
    BRepTools::Write(brep.shape(), stream, watcher->Start());
    progress.check();
    stream.close();
    if (!stream)
      throw Error(ErrorCode::FileUnwritable, "The file \"" + path + "\" cannot be written.",
                  "Check the folder and the space left.");
  });
}

BrepImport readBrep(const std::string& path, const Progress& progress) {
  return withOcctErrors(ErrorCode::FormatDamaged, "It cannot be understood as BREP.", [&] {
    TopoDS_Shape shape;
    std::ifstream stream(path, std::ios::binary);
    // When the file ends too soon, OCCT continues with uninitialised counts, for seconds or forever.
    stream.exceptions(std::ios::failbit | std::ios::badbit);
    Handle(OcctProgress) watcher = new OcctProgress(progress, "Reading");
    try {
      if (isBinary(path))
        BinTools::Read(shape, stream, watcher->Start());
      else
        BRepTools::Read(shape, stream, BRep_Builder(), watcher->Start());
    } catch (const std::ios_base::failure&) {
      throwDamaged();
    }
    if (shape.IsNull()) throwDamaged();
    trimRangesToCurves(shape);
    return BrepImport{Brep(shape), Value::object(), {}};
  });
}

Format brepFormat() {
  Format format;
  format.id = "brep";
  format.title = "BREP (Open CASCADE)";
  format.extensions = {"brep", "brp"};
  format.read = [](const fs::path& path, const Value&, const Progress& progress) {
    return importBrep("brep.read", path, progress);
  };
  format.writeOptions.push_back(heightsOption(true));
  format.write = [](const Shape& shape, const fs::path& path, const Value& options, const Progress& progress) {
    exportBrep("brep.write", toBrep(shape, options), path, options, progress);
  };
  format.writes = brepKinds();
  return format;
}

}  // namespace blossom
