#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Eigen/Dense>
#include <QImage>
#include <algorithm>

#include <vtkPolyData.h>

#include "app/picture_format.h"
#include "core/file.h"
#include "geometry/shape/brep.h"
#include "scene/surface_study.h"
#include "support/solids.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

/// z = height + slope x + bend x^2 + twist x^3 + y^2 / 2 over [from, to] x [-1, 1], as one Bézier patch.
Surface patch(double from, double to, double slope, double bend, double twist) {
  Surface surface{3, 2, {from, from, from, from, to, to, to, to}, {-1, -1, -1, 1, 1, 1}, {}};
  for (int i = 0; i <= 3; ++i)
    for (int j = 0; j <= 2; ++j) {
      // The poles are the blossoms of the polynomials at repeated ends.
      const std::array<double, 3> a{i > 0 ? to : from, i > 1 ? to : from, i > 2 ? to : from};
      const std::array<double, 2> b{j > 0 ? 1.0 : -1.0, j > 1 ? 1.0 : -1.0};
      const double x = (a[0] + a[1] + a[2]) / 3, y = (b[0] + b[1]) / 2;
      const double z =
          slope * x + bend * (a[0] * a[1] + a[1] * a[2] + a[2] * a[0]) / 3 + twist * a[0] * a[1] * a[2] + b[0] * b[1] / 2;
      surface.poles.emplace_back(x, y, z, 1);
    }
  return surface;
}

QImage pictureOf(const std::vector<Shape>& shapes, const PictureOptions& options) {
  const TemporaryFolder folder;
  const auto png = folder.path() / "picture.png";
  renderPicture(shapes, png, options);
  return QImage(QString::fromStdString(png.string())).convertToFormat(QImage::Format_RGB32);
}

/// Where a column of the picture changes between dark and light, in parts of a pixel, with the sense of the change.
struct StripeEdge {
  double y;
  bool brighter;
};

std::vector<StripeEdge> stripeEdges(const QImage& picture, int x, int top, int bottom) {
  constexpr double middle = 127;
  std::vector<StripeEdge> edges;
  for (int y = top; y < bottom; ++y) {
    const double before = qGreen(picture.pixel(x, y)) - middle, after = qGreen(picture.pixel(x, y + 1)) - middle;
    if ((before < 0) != (after < 0)) edges.push_back({y + before / (before - after), before < 0});
  }
  return edges;
}

/// Value and slope at `x0` of an edge that is followed from one column to the next, by a parabola through its places; empty
/// when it is lost on the way.
struct StripeRun {
  double y = 0, slope = 0;
  bool brighter = false;
};

std::vector<StripeRun> stripeRuns(const QImage& picture, double x0, int nearest, int farthest, int top, int bottom) {
  const int step = farthest > nearest ? 1 : -1;
  std::vector<StripeRun> runs;
  for (const StripeEdge& begun : stripeEdges(picture, nearest, top, bottom)) {
    std::vector<Vec2> places;
    double y = begun.y;
    bool lost = false;
    for (int x = nearest; x != farthest && !lost; x += step) {
      lost = true;
      for (const StripeEdge& edge : stripeEdges(picture, x, top, bottom))
        if (edge.brighter == begun.brighter && std::abs(edge.y - y) < 3) {
          places.emplace_back(x + 0.5 - x0, edge.y);
          y = edge.y;
          lost = false;
          break;
        }
    }
    if (lost) continue;
    Eigen::MatrixX3d terms(static_cast<Eigen::Index>(places.size()), 3);
    Eigen::VectorXd values(static_cast<Eigen::Index>(places.size()));
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      terms.row(row) << 1, places[i].x(), places[i].x() * places[i].x();
      values[row] = places[i].y();
    }
    const Vec3 fit = terms.colPivHouseholderQr().solve(values);
    runs.push_back({fit[0], fit[1], begun.brighter});
  }
  return runs;
}

int kept = 0;

/// How stripes go on over the line in the middle of the picture.
struct Crossing {
  int stripes = 0;
  double largestJump = 0;  ///< pixels
  double largestKink = 0;  ///< difference of slopes
  double smallestKink = 1e9;
};

/// Stripes near the middle run along the line of symmetry, where nothing bends them, and those far from it leave the part of
/// the picture that is looked at: both are left out. BLOSSOM_KEEP_PICTURES is the beginning of files to look at.
Crossing crossingOf(const std::vector<Shape>& shapes) {
  PictureOptions options{.width = 800, .height = 800, .view = "top", .edges = false, .chord = 2e-4};
  options.display = SurfaceDisplay::Zebra;
  options.zebra.stripes = 10;
  const QImage picture = pictureOf(shapes, options);
  if (const char* keep = std::getenv("BLOSSOM_KEEP_PICTURES"))
    picture.save(QString::fromLocal8Bit(keep) + QString::number(++kept) + ".png");
  const double middle = picture.width() / 2.0;
  const int top = 110, bottom = picture.height() - 110;
  const auto left = stripeRuns(picture, middle, 396, 350, top, bottom),
             right = stripeRuns(picture, middle, 403, 449, top, bottom);
  Crossing crossing;
  for (const StripeRun& from : left) {
    const double away = std::abs(from.y - middle);
    if (away < 60 || away > 190) continue;
    const StripeRun* to = nullptr;
    for (const StripeRun& each : right)
      if (each.brighter == from.brighter && (!to || std::abs(each.y - from.y) < std::abs(to->y - from.y))) to = &each;
    if (!to) continue;
    ++crossing.stripes;
    crossing.largestJump = std::max(crossing.largestJump, std::abs(to->y - from.y));
    crossing.largestKink = std::max(crossing.largestKink, std::abs(to->slope - from.slope));
    crossing.smallestKink = std::min(crossing.smallestKink, std::abs(to->slope - from.slope));
  }
  qInfo("%d stripes: jump %g px, kink %g to %g", crossing.stripes, crossing.largestJump, crossing.smallestKink,
        crossing.largestKink);
  return crossing;
}

int distance(QRgb a, const Color& b) {
  const auto off = [](int channel, double wanted) {
    return std::abs(channel - static_cast<int>(std::lround(wanted * 255)));
  };
  return off(qRed(a), b.red) + off(qGreen(a), b.green) + off(qBlue(a), b.blue);
}

}  // namespace

class SurfacePictureTest : public QObject {
  Q_OBJECT
 private slots:
  /// Equal tangent planes and curvatures, another third derivative: stripes go on as they were.
  void stripesRunSmoothlyOverEqualCurvatures() {
    const Crossing crossing = crossingOf({patch(-1, 0, 0.6, 0.35, 0), patch(0, 1, 0.6, 0.35, -0.2)});
    QVERIFY(crossing.stripes >= 3);
    QVERIFY(crossing.largestJump < 0.4);
    QVERIFY(crossing.largestKink < 0.03);
  }

  /// Equal tangent planes alone: stripes meet at an angle.
  void stripesKinkWhereCurvatureJumps() {
    const Crossing crossing = crossingOf({patch(-1, 0, 0.6, 0.35, 0), patch(0, 1, 0.6, -0.35, 0)});
    QVERIFY(crossing.stripes >= 3);
    QVERIFY(crossing.largestJump < 0.4);
    QVERIFY(crossing.smallestKink > 0.1);
  }

  void stripesBreakAtACrease() {
    const Crossing crossing = crossingOf({patch(-1, 0, 0.6, 0.1, 0), patch(0, 1, -0.1, 0.1, 0)});
    QVERIFY(crossing.largestJump > 5);
  }

  /// No pixel of a stripe's edge is wider than smoothing makes it: from dark to light within three.
  void stripesAreSharp() {
    PictureOptions options{.width = 600, .height = 600, .view = "top", .edges = false};
    options.display = SurfaceDisplay::Zebra;
    const QImage picture = pictureOf({Brep(BRepPrimAPI_MakeSphere(5).Shape())}, options);
    const int x = 300;
    int edges = 0;
    for (const StripeEdge& edge : stripeEdges(picture, x, 120, 480)) {
      const int above = qGreen(picture.pixel(x, static_cast<int>(edge.y) - 2)),
                below = qGreen(picture.pixel(x, static_cast<int>(edge.y) + 3));
      QVERIFY2(std::abs(above - below) > 150, qPrintable(QStringLiteral("%1: %2 %3").arg(edge.y).arg(above).arg(below)));
      ++edges;
    }
    QVERIFY(edges > 6);
  }

  /// Turned by a right angle, the stripes of a ball are those before, turned.
  void theirDirectionTurns() {
    PictureOptions options{.width = 300, .height = 300, .view = "top", .edges = false, .chord = 1e-3};
    options.display = SurfaceDisplay::Zebra;
    const std::vector<Shape> ball{Brep(BRepPrimAPI_MakeSphere(5).Shape())};
    const QImage level = pictureOf(ball, options);
    options.zebra.angle = 90;
    const QImage upright = pictureOf(ball, options).transformed(QTransform().rotate(90));
    int differ = 0, inside = 0;
    for (int y = 90; y < 210; ++y)
      for (int x = 90; x < 210; ++x, ++inside)
        differ += std::abs(qGreen(level.pixel(x, y)) - qGreen(upright.pixel(x, y))) > 60;
    QVERIFY2(differ < inside / 50, qPrintable(QString::number(differ)));
  }

  void aTorusIsRedOutsideAndBlueInside() {
    PictureOptions options{.width = 500, .height = 500, .view = "top", .edges = false};
    options.display = SurfaceDisplay::Gaussian;
    const double major = 7, minor = 2.5;
    const QImage picture = pictureOf({Brep(BRepPrimAPI_MakeTorus(major, minor).Shape())}, options);
    int left = 0;
    while (left < 250 && qAbs(qRed(picture.pixel(left, 250)) - qRed(picture.pixel(2, 250))) < 30) ++left;
    const double scale = (250 - left) / (major + minor);  // pixels per mm, roughly: the view is in perspective
    const QRgb outside = picture.pixel(static_cast<int>(250 - scale * (major + 0.8 * minor)), 250);
    const QRgb inside = picture.pixel(static_cast<int>(250 - scale * (major - 0.8 * minor)), 250);
    QVERIFY(qRed(outside) > qBlue(outside) + 30);
    QVERIFY(qBlue(inside) > qRed(inside) + 30);
  }

  void theLegendTellsTheRange() {
    const TemporaryFolder folder;
    PictureOptions options{.width = 800, .height = 600};
    const std::vector<Shape> ball{Brep(BRepPrimAPI_MakeSphere(4).Shape())};
    const auto rangeOf = [&](SurfaceDisplay display) {
      options.display = display;
      return renderPicture(ball, folder.path() / "ball.png", options);
    };
    QVERIFY(!rangeOf(SurfaceDisplay::Plain) && !rangeOf(SurfaceDisplay::Zebra) && !rangeOf(SurfaceDisplay::IsoCurves));
    QVERIFY(rangeOf(SurfaceDisplay::Gaussian) == (CurvatureRange{-0.063, 0.063}));  // 1/16, rounded up to two digits
    QVERIFY(rangeOf(SurfaceDisplay::Largest) == (CurvatureRange{0, 0.25}));
    QVERIFY(rangeOf(SurfaceDisplay::Mean) == (CurvatureRange{-0.25, 0.25}));
    const QImage picture(QString::fromStdString((folder.path() / "ball.png").string()));
    // 150 pixels of colours end 20 above the lower edge.
    QVERIFY(distance(picture.pixel(20, 579), curvatureColor(SurfaceDisplay::Mean, 0)) < 4);
    QVERIFY(distance(picture.pixel(20, 430), curvatureColor(SurfaceDisplay::Mean, 1)) < 4);
  }

  /// The tip of a cone bends without bound; the scale is made for the rest.
  void aTipDoesNotTakeAllTheColours() {
    const TessellationOptions fine{.chord = 0.005, .angle = 0.05, .curvature = true};
    const Tessellation cone = tessellate(Brep(BRepPrimAPI_MakeCone(5, 0, 10).Shape()), fine);
    double largest = 0;
    for (const SurfaceCurvature& c : cone.curvatures) largest = std::max(largest, c.largest());
    const double bound = curvatureBound(cone, SurfaceDisplay::Largest);
    QVERIFY2(largest > 10 * bound && bound > 0.17 && bound < 3, qPrintable(QStringLiteral("%1 %2").arg(largest).arg(bound)));
  }

  void whatIsDrawnAtAPlaceIsTheCurvatureThere() {
    const double major = 7, minor = 2.5;
    const Shape shapes[] = {Brep(BRepPrimAPI_MakeTorus(major, minor).Shape()), torusSurface(major, minor)};
    for (const Shape& shape : shapes) {
      const SurfaceStudy study = studySurfaces(shape, {.chord = 0.005, .angle = 0.1}, 5, Progress::none());
      QVERIFY(study.isoCurves && study.isoCurves->GetNumberOfLines() == 10);
      for (double angle = 0.1; angle < 6; angle += 0.7) {
        const double away = major + minor * std::cos(angle);
        const Vec3 p(away * std::cos(2.1), away * std::sin(2.1), minor * std::sin(angle));
        const auto found = drawnCurvature(study, SurfaceDisplay::Gaussian, 0, p);
        QVERIFY(found.has_value());
        COMPARE_NEAR(*found, std::cos(angle) / (minor * away), 2e-3);
      }
      QVERIFY(!drawnCurvature(study, SurfaceDisplay::Mean, 99, Vec3::Zero()));
    }
  }

  void isoCurvesAreSeenOnTheFaces() {
    PictureOptions options{.width = 400, .height = 400, .edges = false};
    const std::vector<Shape> ball{Brep(BRepPrimAPI_MakeSphere(5).Shape())};
    const QImage plain = pictureOf(ball, options);
    options.display = SurfaceDisplay::IsoCurves;
    const QImage curves = pictureOf(ball, options);
    options.isoCurves = 0;
    QVERIFY(pictureOf(ball, options) == plain);
    int darker = 0;
    for (int y = 0; y < 400; ++y)
      for (int x = 0; x < 400; ++x) darker += qGreen(plain.pixel(x, y)) - qGreen(curves.pixel(x, y)) > 25;
    // Sixteen lines of about two pixels over a ball of some 330: not a few specks, and not half of it.
    QVERIFY2(darker > 2000 && darker < 40'000, qPrintable(QString::number(darker)));
  }

  void theFormatHasTheOptions() {
    const PictureOptions options =
        readPictureOptions(Value{{"display", "zebra"}, {"stripes", 20}, {"stripe-angle", 30}, {"iso-curves", 3}});
    QVERIFY(options.display == SurfaceDisplay::Zebra);
    QCOMPARE(options.zebra.stripes, 20);
    COMPARE_NEAR(options.zebra.angle, 30, 0);
    QCOMPARE(options.isoCurves, 3);
    VERIFY_ERROR(readPictureOptions(Value{{"display", "leopard"}}), ErrorCode::InvalidParameter);
    for (std::size_t i = 0; i < surfaceDisplayNames().size(); ++i)
      QCOMPARE(static_cast<std::size_t>(surfaceDisplayOf(surfaceDisplayNames()[i])), i);
    VERIFY_ERROR(surfaceDisplayOf("leopard"), ErrorCode::InvalidParameter);
  }
};

BLOSSOM_TEST(SurfacePictureTest)
#include "surface_picture_test.moc"
