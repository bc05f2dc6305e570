#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/angle.h"
#include "core/error.h"
#include "core/units.h"
#include "exchange/format/cubic_pieces.h"
#include "exchange/format/format.h"
#include "exchange/format/frames.h"
#include "exchange/format/mesh_options.h"
#include "exchange/format/page_sheet.h"
#include "exchange/format/xml_text.h"
#include "exchange/svg/svg_write.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/frame_times.h"

namespace blossom::svg {
namespace {

constexpr double lineWidth = 0.25;  // of what is open, in mm

class PathWriter {
 public:
  PathWriter(double mirror, double tolerance) : mirror_(mirror), tolerance_(tolerance) {}

  std::string data(const Path& path) {
    if (path.segments.empty()) return {};
    out_ = "M" + pair(startPoint(path.segments.front()));
    for (const Segment& s : path.segments) {
      if (const Line2* line = std::get_if<Line2>(&s))
        out_ += "L" + pair(line->to);
      else if (const Arc2* arc = std::get_if<Arc2>(&s))
        addArc(*arc);
      else
        addSpline(std::get<Spline2>(s));
    }
    if (path.closed) out_ += "Z";
    return out_;
  }

 private:
  [[nodiscard]] std::string pair(const Vec2& p) const { return formatNumber(p.x()) + "," + formatNumber(mirror_ - p.y()); }

  void addArc(const Arc2& arc) {
    // Ends that coincide would draw nothing, and near half a turn the flags become unsure: pieces of a third are safe.
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep) / (fullTurn / 3) - 1e-12)));
    for (int i = 1; i <= pieces; ++i) {
      const double angle = arc.start + arc.sweep * i / pieces;
      const Vec2 end =
          i == pieces ? endPoint(Segment(arc)) : Vec2(arc.center + arc.radius * Vec2(std::cos(angle), std::sin(angle)));
      const std::string radius = formatNumber(arc.radius);
      // The page is mirrored, so counter-clockwise is the negative direction of SVG.
      out_ += fmt::format("A{},{} 0 0 {} {}", radius, radius, arc.sweep > 0 ? 0 : 1, pair(end));
    }
  }

  void addSpline(const Spline2& spline) {
    for (const BezierPiece& piece : bezierPieces(spline)) addPiece(piece);
  }

  void addPiece(const BezierPiece& p) {
    const bool polynomial = isPolynomial(p);
    if (polynomial && p.size() == 2)
      out_ += "L" + pair(euclidean(p[1]));
    else if (polynomial && p.size() == 3)
      out_ += "Q" + pair(euclidean(p[1])) + " " + pair(euclidean(p[2]));
    else if (p.size() != 3 || !addConic(p))
      for (const auto& cubic : cubicsOf(p, tolerance_))
        out_ += "C" + pair(cubic[1]) + " " + pair(cubic[2]) + " " + pair(cubic[3]);
  }

  /// A rational quadratic piece of an ellipse is the affine image of an arc of half-angle acos(w) of the unit circle, where
  /// w is the middle weight in standard form (Piegl & Tiller, The NURBS Book, 7.3). False for parabolas and hyperbolas.
  bool addConic(const BezierPiece& p) {
    const double w = p[1].z() / std::sqrt(p[0].z() * p[2].z());
    if (!(w > 1e-6) || !(w < 1 - 1e-9)) return false;
    const Vec2 start = euclidean(p[0]), corner = euclidean(p[1]), end = euclidean(p[2]);
    const double sine = std::sqrt(1 - w * w);
    Eigen::Matrix2d axes;  // conjugate half-diameters
    axes.col(0) = (corner - 0.5 * (start + end)) * w / (sine * sine);
    axes.col(1) = (end - start) / (2 * sine);
    const Eigen::JacobiSVD<Eigen::Matrix2d> svd(axes, Eigen::ComputeFullU);
    const Vec2& radii = svd.singularValues();
    if (!(radii.y() > 1e-9 * radii.x())) return false;
    const double rotation = -toDegrees(std::atan2(svd.matrixU()(1, 0), svd.matrixU()(0, 0)));
    out_ += fmt::format("A{},{} {} 0 {} {}", formatNumber(radii.x()), formatNumber(radii.y()), formatNumber(rotation),
                        axes.determinant() > 0 ? 0 : 1, pair(end));
    return true;
  }

  double mirror_, tolerance_;
  std::string out_;
};

std::string attributes(const std::string& layer, const std::optional<Color>& color, bool filled, FillRule rule) {
  // A path without a colour gets the default, black, which is read back as no colour.
  std::string result;
  if (filled && color) result = fmt::format(" fill=\"{}\"", toHex(*color));
  if (!filled)
    result =
        fmt::format(" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\" stroke-linejoin=\"round\"",
                    color ? toHex(*color) : "currentColor", formatNumber(lineWidth));
  if (filled && rule == FillRule::EvenOdd) result += " fill-rule=\"evenodd\"";
  if (!layer.empty()) result = fmt::format(" inkscape:label=\"{}\"", escapedXml(layer)) + result;
  return result;
}

std::string elements(const Curves& curves, PathWriter& writer, const Progress& progress) {
  std::string out;
  for (std::size_t i = 0; i < curves.paths.size();) {
    progress.check();
    // Neighbours of one layer and colour are one element, so that holes are holes.
    const Path& first = curves.paths[i];
    std::string data;
    std::size_t next = i;
    for (; next < curves.paths.size(); ++next) {
      const Path& path = curves.paths[next];
      if (path.layer != first.layer || path.color != first.color || path.closed != first.closed) break;
      data += (data.empty() ? "" : " ") + writer.data(path);
    }
    out += fmt::format("<g{}><path d=\"{}\"/></g>\n", attributes(first.layer, first.color, first.closed, curves.fillRule),
                       data);
    i = next;
  }
  return out;
}

/// A frame that is seen in its own time alone. Programs that know no animation see the first one, and so do readers.
std::string frameElement(const std::string& drawn, double begin, double end, double seconds) {
  std::string values = "inline;none", times = "0;" + formatNumber(end);
  if (begin > 0) {
    values = "none;inline";
    times = "0;" + formatNumber(begin);
    if (end < 1) {
      values += ";none";
      times += ";" + formatNumber(end);
    }
  } else if (end >= 1) {
    return "<g>\n" + drawn + "</g>\n";  // the only one
  }
  return fmt::format(
      "<g display=\"{}\">\n<animate attributeName=\"display\" calcMode=\"discrete\" values=\"{}\" keyTimes=\"{}\" "
      "dur=\"{}s\" repeatCount=\"indefinite\"/>\n{}</g>\n",
      begin > 0 ? "none" : "inline", values, times, formatNumber(seconds), drawn);
}

/// What is drawn of a shape: one drawing, or one for each frame.
std::vector<Curves> drawingsOf(const Shape& shape) {
  const auto* sequence = shape.get<Sequence>();
  const std::vector<Shape> shapes = sequence ? sequence->frames : std::vector<Shape>{shape};
  std::vector<Curves> drawings;
  for (const Shape& each : shapes) {
    std::optional<Curves> drawing = drawingOf(each);
    if (!drawing)
      throw Error(ErrorCode::OutputNotSupported,
                  fmt::format("SVG takes planar drawings; frame {} of the sequence is a {}.", drawings.size() + 1,
                              shapeKindName(each.kind())),
                  "Write the frames as STL or OBJ files.");
    drawings.push_back(std::move(*drawing));
  }
  if (drawings.empty()) throw Error(ErrorCode::OutputNotSupported, "The sequence has no frames.");
  return drawings;
}

/// A page that also holds the width of the lines, which are drawn for paths that are open.
DrawnBox withLineWidth(DrawnBox box, const std::vector<Curves>& drawings) {
  const auto isOpen = [](const Path& path) { return !path.closed; };
  const auto hasLines = [&](const Curves& curves) { return std::any_of(curves.paths.begin(), curves.paths.end(), isOpen); };
  if (std::any_of(drawings.begin(), drawings.end(), hasLines)) {
    box.low.array() -= lineWidth / 2;
    box.high.array() += lineWidth / 2;
  }
  return box;
}

double toleranceOf(const Value& options) { return options.value("tolerance", 1e-3); }
double chordOfPage(const Value& options) { return std::max(toleranceOf(options), 1e-2); }

/// Coordinates of drawings are kept: only y is mirrored, within the page.
class Page {
 public:
  Page(const DrawnBox& box, double tolerance)
      : low_(box.low), size_(box.size().cwiseMax(Vec2(1e-3, 1e-3))), writer_(mirror(), tolerance) {}

  [[nodiscard]] double mirror() const { return low_.y() + low_.y() + size_.y(); }
  [[nodiscard]] PathWriter& writer() { return writer_; }
  [[nodiscard]] std::string document(const std::string& content) const {
    const std::string width = formatNumber(size_.x()), height = formatNumber(size_.y());
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
        "width=\"{}mm\" height=\"{}mm\" viewBox=\"{} {} {} {}\">\n{}</svg>\n",
        width, height, formatNumber(low_.x()), formatNumber(low_.y()), width, height, content);
  }

 private:
  Vec2 low_, size_;
  PathWriter writer_;
};

std::string animation(const Sequence& sequence, const std::vector<Curves>& drawings, Page& page, double seconds,
                      const Progress& progress) {
  const std::vector<double> begins = frameBeginnings(sequence);
  std::string out;
  for (std::size_t k = 0; k < drawings.size(); ++k)
    out += frameElement(elements(drawings[k], page.writer(), progress), begins[k], k + 1 < begins.size() ? begins[k + 1] : 1,
                        seconds);
  return out;
}

std::string contactSheet(const PageSheet& sheet, const std::vector<Curves>& drawings, Page& page, const Progress& progress) {
  std::string out;
  for (const PageSheet::Cell& cell : sheet.cells) {
    out += fmt::format("<g transform=\"translate({},{})\">\n{}</g>\n", formatNumber(cell.shift.x()),
                       formatNumber(-cell.shift.y()), elements(drawings[cell.frame], page.writer(), progress));
    out += fmt::format("<text x=\"{}\" y=\"{}\" font-family=\"sans-serif\" font-size=\"{}\">{}</text>\n",
                       formatNumber(cell.label.x()), formatNumber(page.mirror() - cell.label.y()),
                       formatNumber(sheet.letterHeight), cell.text);
  }
  return out;
}

}  // namespace

DrawnBox sharedPage(const Sequence& sequence, const Value& options, const Progress& progress) {
  return withLineWidth(drawnBox(sequence, chordOfPage(options), progress), drawingsOf(Shape(sequence)));
}

void writeDocument(const Shape& shape, const std::filesystem::path& file, const Value& options, const Progress& progress,
                   const DrawnBox* given) {
  const std::vector<Curves> drawings = drawingsOf(shape);
  const double tolerance = toleranceOf(options);
  const DrawnBox box = given ? *given : withLineWidth(drawnBox(drawings, chordOfPage(options)), drawings);
  const auto* sequence = shape.get<Sequence>();
  if (sequence && sheetCells(options) > 0) {
    if (options.value("animate", false))
      throw Error(ErrorCode::InvalidParameter, "A contact sheet shows frames side by side and does not play.",
                  "Ask for a sheet or for an animation, not for both.");
    const PageSheet sheet = pageSheet(*sequence, box, sheetCells(options));
    Page page({{0, 0}, sheet.size}, tolerance);
    return writeBytes(file, page.document(contactSheet(sheet, drawings, page, progress)));
  }
  Page page(box, tolerance);
  writeBytes(file, page.document(sequence ? animation(*sequence, drawings, page, options.value("seconds", 2.0), progress)
                                          : elements(drawings.front(), page.writer(), progress)));
}

}  // namespace blossom::svg
