#include "kernel/solid/loft.h"

#include <fmt/format.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepGProp.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <utility>

#include "core/error.h"
#include "core/tolerance.h"
#include "kernel/parts/crossing_warning.h"
#include "kernel/parts/finished_solid.h"
#include "kernel/parts/guarded.h"
#include "kernel/parts/profile.h"
#include "kernel/parts/shape_parts.h"
#include "kernel/parts/sound_bodies.h"

namespace blossom::modeling {

namespace {

/// One section: an outline with the holes in it, or a point.
struct Section {
  TopoDS_Shape outline;  ///< wire or vertex
  std::vector<TopoDS_Shape> holes;

  [[nodiscard]] bool isPoint() const { return outline.ShapeType() == TopAbs_VERTEX; }
};

[[noreturn]] void throwSection(std::size_t index, const char* why, const char* hint) {
  throw Error(ErrorCode::InvalidInput, fmt::format("Section {} {}.", index + 1, why), hint);
}

Section sectionOf(const TopoDS_Shape& shape, std::size_t index) {
  if (shape.ShapeType() == TopAbs_VERTEX) return {shape, {}};
  const Profile profile = profileOf(shape);
  if (profile.faces.size() + profile.wires.size() != 1)
    throwSection(index, "has several outlines", "A section is one outline, with holes if all sections have them.");
  if (!profile.wires.empty()) return {profile.wires.front(), {}};
  Section section;
  section.outline = BRepTools::OuterWire(profile.faces.front());
  for (const TopoDS_Shape& wire : subShapesOf(profile.faces.front(), TopAbs_WIRE))
    if (!wire.IsSame(section.outline)) section.holes.push_back(wire);
  return section;
}

gp_Pnt centreOf(const TopoDS_Shape& wire) {
  GProp_GProps properties;
  BRepGProp::LinearProperties(wire, properties);
  return properties.CentreOfMass();
}

/// Each hole is connected to the nearest hole of the next section.
void matchHoles(std::vector<Section>& sections) {
  for (std::size_t i = 1; i < sections.size(); ++i)
    for (std::size_t k = 0; k < sections[i].holes.size(); ++k) {
      const gp_Pnt before = centreOf(sections[i - 1].holes[k]);
      const auto nearer = [&](const TopoDS_Shape& a, const TopoDS_Shape& b) {
        return centreOf(a).SquareDistance(before) < centreOf(b).SquareDistance(before);
      };
      const auto from = sections[i].holes.begin() + static_cast<std::ptrdiff_t>(k);
      std::iter_swap(from, std::min_element(from, sections[i].holes.end(), nearer));
    }
}

void checkSections(const std::vector<Section>& sections, bool solid) {
  if (sections.size() < 2)
    throw Error(ErrorCode::InvalidInput, "A loft needs at least two sections.", "Add another outline.");
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const Section& section = sections[i];
    if (section.isPoint() && i > 0 && i + 1 < sections.size())
      throwSection(i, "is a point between outlines", "Only the first and the last section may be a point.");
    if (section.holes.size() != sections.front().holes.size())
      throwSection(i, "has another number of holes than the first one", "Give all sections equally many holes.");
    if (solid && !section.isPoint() && !BRep_Tool::IsClosed(section.outline))
      throwSection(i, "is open, so the loft cannot be a solid", "Close the outline, or turn \"solid\" off.");
    if (i > 0 && !section.isPoint() && !sections[i - 1].isPoint() &&
        BRep_Tool::IsClosed(section.outline) != BRep_Tool::IsClosed(sections[i - 1].outline))
      throwSection(i, "is open where the one before is closed, or the other way round", "Use outlines of one sort.");
  }
  if (sections.size() == 2 && sections[0].isPoint() && sections[1].isPoint())
    throw Error(ErrorCode::InvalidInput, "A loft needs at least one outline; both sections are points.");
}

TopoDS_Shape skin(const std::vector<TopoDS_Shape>& outlines, const LoftOptions& o, const Complaint& complaint) {
  BRepOffsetAPI_ThruSections maker(o.solid, o.ruled, 1e-6);
  for (const TopoDS_Shape& outline : outlines)
    if (outline.ShapeType() == TopAbs_VERTEX)
      maker.AddVertex(TopoDS::Vertex(outline));
    else
      maker.AddWire(TopoDS::Wire(outline));
  maker.CheckCompatibility(Standard_True);
  maker.Build();
  if (!maker.IsDone()) throw Error(ErrorCode::Degenerate, complaint.message, complaint.hint);
  return o.solid ? finishedSolid(maker.Shape(), complaint) : finishedSheet(maker.Shape(), complaint);
}

}  // namespace

LoftResult loft(const std::vector<TopoDS_Shape>& shapes, const LoftOptions& o, const Progress& progress) {
  const Complaint complaint{"No good shape runs through these sections.",
                            "Sections that lie in one plane, cross or turn against each other are the usual cause."};
  std::vector<Section> sections;
  sections.reserve(shapes.size());
  for (const TopoDS_Shape& shape : shapes) sections.push_back(sectionOf(shape, sections.size()));
  checkSections(sections, o.solid);
  if (!o.solid)
    for (Section& section : sections) section.holes.clear();
  matchHoles(sections);
  return guarded(complaint.message, complaint.hint, [&] {
    const auto through = [&](const auto& part) {
      progress.check();
      std::vector<TopoDS_Shape> outlines;
      outlines.reserve(sections.size());
      for (const Section& section : sections) outlines.push_back(part(section));
      return skin(outlines, o, complaint);
    };
    progress.report(0.1, "Lofting");
    TopoDS_Shape body = through([](const Section& s) { return s.outline; });
    for (std::size_t k = 0; k < sections.front().holes.size(); ++k)
      body = BRepAlgoAPI_Cut(body, through([k](const Section& s) { return s.holes[k]; })).Shape();
    if (!o.solid) {
      LoftResult sheet{body, {}};
      warnOfCrossing({body}, complaint.hint, sheet.warnings, progress);
      return sheet;
    }
    if (!sections.front().holes.empty()) body = finishedSolid(body, complaint);
    return LoftResult{soundBodies({body}, complaint, progress), {}};
  });
}

}  // namespace blossom::modeling
