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
#include "exchange/format/drawn_box.h"
#include "exchange/format/format.h"
#include "exchange/format/mesh_options.h"
#include "exchange/format/xml_text.h"
#include "exchange/svg/svg_write.h"
#include "geometry/planar/planar.h"

namespace blossom::svg {
namespace {

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
    result = fmt::format(" fill=\"none\" stroke=\"{}\" stroke-width=\"0.25\"", color ? toHex(*color) : "currentColor");
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

/// When each frame begins, as a share of one run. The last frame stays for as long as the others do on average.
std::vector<double> beginnings(const Sequence& sequence) {
  const std::size_t count = sequence.frames.size();
  const bool timed = sequence.times.size() == count && sequence.times.back() > sequence.times.front();
  const double span = timed ? sequence.times.back() - sequence.times.front() : static_cast<double>(count) - 1;
  const double whole = count > 1 ? span * static_cast<double>(count) / (static_cast<double>(count) - 1) : 1;
  std::vector<double> begins;
  for (std::size_t k = 0; k < count; ++k)
    begins.push_back((timed ? sequence.times[k] - sequence.times.front() : static_cast<double>(k)) / whole);
  return begins;
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

}  // namespace

void writeDocument(const Shape& shape, const std::filesystem::path& file, const Value& options, const Progress& progress) {
  const std::vector<Curves> drawings = drawingsOf(shape);
  const double tolerance = options.value("tolerance", 1e-3);
  const DrawnBox page = drawnBox(drawings, std::max(tolerance, 1e-2));
  const Vec2 size = (page.high - page.low).cwiseMax(Vec2(1e-3, 1e-3));
  PathWriter writer(page.low.y() + page.low.y() + size.y(), tolerance);

  const std::string width = formatNumber(size.x()), height = formatNumber(size.y());
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
      "width=\"{}mm\" height=\"{}mm\" viewBox=\"{} {} {} {}\">\n",
      width, height, formatNumber(page.low.x()), formatNumber(page.low.y()), width, height);
  if (const auto* sequence = shape.get<Sequence>()) {
    const std::vector<double> begins = beginnings(*sequence);
    for (std::size_t k = 0; k < drawings.size(); ++k)
      out += frameElement(elements(drawings[k], writer, progress), begins[k], k + 1 < begins.size() ? begins[k + 1] : 1,
                          options.value("seconds", 2.0));
  } else {
    out += elements(drawings.front(), writer, progress);
  }
  writeBytes(file, out + "</svg>\n");
}

}  // namespace blossom::svg
