// Drawings as a page of PDF or PostScript, drawn by Cairo.
#include <cairo-pdf.h>
#include <cairo-ps.h>

#include <cmath>
#include <functional>
#include <memory>

#include "core/error.h"
#include "exchange/format/cubic_pieces.h"
#include "exchange/format/drawn_box.h"
#include "exchange/format/frames.h"
#include "exchange/format/mesh_options.h"
#include "exchange/format/page_sheet.h"
#include "geometry/planar/planar.h"

namespace blossom {
namespace {

constexpr double pointsPerMm = 72 / 25.4;
constexpr double lineWidth = 0.25;  // mm
constexpr double margin = 1;        // mm, so that no line at the edge is cut

struct SurfaceDeleter {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct ContextDeleter {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, SurfaceDeleter>;
using Context = std::unique_ptr<cairo_t, ContextDeleter>;

cairo_status_t append(void* closure, const unsigned char* bytes, unsigned int length) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(bytes), length);
  return CAIRO_STATUS_SUCCESS;
}

void addSegment(cairo_t* page, const Segment& segment, double tolerance) {
  if (const auto* line = std::get_if<Line2>(&segment)) {
    cairo_line_to(page, line->to.x(), line->to.y());
  } else if (const auto* arc = std::get_if<Arc2>(&segment)) {
    const auto add = arc->sweep > 0 ? cairo_arc : cairo_arc_negative;
    add(page, arc->center.x(), arc->center.y(), arc->radius, arc->start, arc->start + arc->sweep);
  } else {
    for (const BezierPiece& piece : bezierPieces(std::get<Spline2>(segment)))
      for (const auto& [from, b, c, to] : cubicsOf(piece, tolerance))
        cairo_curve_to(page, b.x(), b.y(), c.x(), c.y(), to.x(), to.y());
  }
}

void addPath(cairo_t* page, const Path& path, double tolerance) {
  if (path.segments.empty()) return;
  const Vec2 start = startPoint(path.segments.front());
  cairo_move_to(page, start.x(), start.y());
  for (const Segment& segment : path.segments) addSegment(page, segment, tolerance);
  if (path.closed) cairo_close_path(page);
}

/// Neighbours of one layer and colour are one path, so that holes are holes. Closed ones are filled.
void drawCurves(cairo_t* page, const Curves& curves, double tolerance, const Progress& progress) {
  cairo_set_line_width(page, lineWidth);
  cairo_set_line_join(page, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(page, CAIRO_LINE_CAP_ROUND);  // so that a point is seen
  cairo_set_fill_rule(page, curves.fillRule == FillRule::EvenOdd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
  for (std::size_t i = 0; i < curves.paths.size();) {
    progress.check();
    const Path& first = curves.paths[i];
    const auto belongs = [&](const Path& path) {
      return path.layer == first.layer && path.color == first.color && path.closed == first.closed;
    };
    for (; i < curves.paths.size() && belongs(curves.paths[i]); ++i) addPath(page, curves.paths[i], tolerance);
    const Color color = first.color.value_or(Color{0, 0, 0});
    cairo_set_source_rgb(page, color.red, color.green, color.blue);
    (first.closed ? cairo_fill : cairo_stroke)(page);
  }
}

Curves planar(const Shape& shape) {
  std::optional<Curves> drawing = drawingOf(shape);
  if (!drawing) throw Error(ErrorCode::OutputNotSupported, "A page takes planar drawings.");
  return std::move(*drawing);
}

using MakeSurface = cairo_surface_t* (*)(cairo_write_func_t, void*, double, double);

void refuseFailed(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  // Cairo keeps the pages of PostScript in a temporary file until they are complete.
  const bool onDisk = status == CAIRO_STATUS_WRITE_ERROR || status == CAIRO_STATUS_TEMP_FILE_ERROR;
  throw Error(onDisk ? ErrorCode::FileUnwritable : ErrorCode::OutputNotSupported,
              std::string("The page cannot be drawn: ") + cairo_status_to_string(status) + ".",
              onDisk ? "Make room on the disk of the temporary folder." : "Write it as SVG or DXF.");
}

/// Cairo tells PostScript the box of what is painted, to which programs that place the page in another crop it: the frames
/// of a sequence would lose the place that they share.
void giveWholePage(std::string& postScript, const Vec2& size) {
  const std::string whole = " 0 0 " + std::to_string(std::lround(size.x())) + " " + std::to_string(std::lround(size.y()));
  for (const std::string comment : {"\n%%BoundingBox:", "\n%%PageBoundingBox:"})
    for (std::size_t at = 0; (at = postScript.find(comment, at)) != std::string::npos;) {
      at += comment.size();
      postScript.replace(at, postScript.find('\n', at) - at, whole);
    }
}

/// A page around a box, on which `draw` draws in mm, y upwards.
void writePage(MakeSurface make, const DrawnBox& box, double tolerance, const std::filesystem::path& file,
               const std::function<void(cairo_t*)>& draw) {
  const Vec2 low = box.low - Vec2(margin, margin), high = box.high + Vec2(margin, margin);
  const Vec2 size = ((high - low) * pointsPerMm).array().ceil();  // PostScript knows whole points only
  std::string content;
  const Surface surface(make(append, &content, size.x(), size.y()));
  {
    const Context page(cairo_create(surface.get()));
    cairo_set_tolerance(page.get(), tolerance * pointsPerMm);
    cairo_translate(page.get(), 0, size.y());
    cairo_scale(page.get(), pointsPerMm, -pointsPerMm);
    cairo_translate(page.get(), -low.x(), -low.y());
    draw(page.get());
    cairo_show_page(page.get());
    refuseFailed(cairo_status(page.get()));
  }
  cairo_surface_finish(surface.get());
  refuseFailed(cairo_surface_status(surface.get()));
  if (content.starts_with("%!PS")) giveWholePage(content, size);
  writeBytes(file, content);
}

void writeDrawing(MakeSurface make, const Shape& shape, const DrawnBox* shared, const std::filesystem::path& file,
                  const Value& options, const Progress& progress) {
  const Curves drawing = planar(shape);
  const double tolerance = options.value("tolerance", 1e-2);
  writePage(make, shared ? *shared : drawnBox({drawing}, tolerance), tolerance, file,
            [&](cairo_t* page) { drawCurves(page, drawing, tolerance, progress); });
}

void drawLabel(cairo_t* page, const Vec2& place, double height, const std::string& text) {
  cairo_save(page);
  cairo_translate(page, place.x(), place.y());
  cairo_scale(page, 1, -1);
  cairo_select_font_face(page, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(page, height);
  cairo_set_source_rgb(page, 0, 0, 0);
  cairo_move_to(page, 0, 0);
  cairo_show_text(page, text.c_str());
  cairo_restore(page);
}

void writeSheet(MakeSurface make, const Sequence& sequence, const std::filesystem::path& file, const Value& options,
                const Progress& progress) {
  const double tolerance = options.value("tolerance", 1e-2);
  const PageSheet sheet = pageSheet(sequence, drawnBox(sequence, tolerance, progress), sheetCells(options));
  writePage(make, {{0, 0}, sheet.size}, tolerance, file, [&](cairo_t* page) {
    for (const PageSheet::Cell& cell : sheet.cells) {
      cairo_save(page);
      cairo_translate(page, cell.shift.x(), cell.shift.y());
      drawCurves(page, planar(sequence.frames[cell.frame]), tolerance, progress);
      cairo_restore(page);
      drawLabel(page, cell.label, sheet.letterHeight, cell.text);
    }
  });
}

Format pageFormat(std::string id, std::string title, MakeSurface make) {
  ParameterSpec tolerance = positiveLength();
  tolerance.name = "tolerance";
  tolerance.help = "Largest distance between a curve and the cubic pieces that stand for it; places are kept to 0.002 mm.";
  tolerance.fallback = 1e-2;

  Format format;
  format.extensions = {id};
  format.id = std::move(id);
  format.title = std::move(title);
  format.writeOptions = {tolerance, sheetOption()};
  format.write = [make](const Shape& shape, const std::filesystem::path& file, const Value& options,
                        const Progress& progress) {
    const auto* sequence = shape.get<Sequence>();
    if (sequence)
      writeSheet(make, *sequence, file, options, progress);
    else
      writeDrawing(make, shape, nullptr, file, options, progress);
  };
  format.frameWriter = [make](const Sequence& sequence, const Value& given, const Progress& looking) -> Format::Write {
    const DrawnBox shared = drawnBox(sequence, given.value("tolerance", 1e-2), looking);
    return [make, shared](const Shape& frame, const std::filesystem::path& file, const Value& options,
                          const Progress& progress) { writeDrawing(make, frame, &shared, file, options, progress); };
  };
  format.inOneFile = [](const Value& options) { return sheetCells(options) > 0; };
  format.writes = {ShapeKind::Curves, ShapeKind::Region, ShapeKind::MedialAxis, ShapeKind::Toolpath, ShapeKind::Sequence};
  return format;
}

cairo_surface_t* pdfSurface(cairo_write_func_t write, void* closure, double width, double height) {
  cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(write, closure, width, height);
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "");  // the same drawing makes the same file
  return surface;
}

}  // namespace

Format pdfFormat() { return pageFormat("pdf", "PDF (a page around the drawing, in its size)", pdfSurface); }

Format psFormat() {
  return pageFormat("ps", "PostScript (a page around the drawing, in its size)", cairo_ps_surface_create_for_stream);
}

}  // namespace blossom
