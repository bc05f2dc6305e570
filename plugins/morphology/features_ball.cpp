#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/units.h"
#include "feature_groups.h"

namespace blossom::morphology {

namespace {

struct BallParameters {
  double radius = 5;
  int subdivisions = 2;
  BallFit fit = BallFit::Inscribed;
};

FeatureType ballFeature() {
  using P = BallParameters;
  return feature<P>("morphology.ball", "Ball", "A ball of triangles about the origin, to add to a solid or to melt it by.")
      .icon("ball")
      .produces({ShapeKind::Mesh})
      .parameter("radius", &P::radius, ballRadius(), "Radius of the ball.")
      .parameter("subdivisions", &P::subdivisions, count(0, maximumSubdivisions),
                 "Fineness: 20 faces, with each subdivision four times as many.")
      .parameter("fit", &P::fit, choice({"inscribed", "circumscribed"}),
                 "Whether the polyhedron lies inside the ball or around it.")
      .example("blossom ball --radius 5 --subdivisions 3 -o ball.stl")
      .example("blossom ball --radius 2 --fit circumscribed -o ball.off --json")
      .evaluate([](const P& p, const Inputs&, const Progress&) {
        BallResult made = ball({p.radius, p.subdivisions, p.fit});
        return Evaluated{std::move(made.mesh), {{"deviation", made.deviation}}, {}};
      });
}

std::vector<std::string_view> between(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(':', from), text.size());
    parts.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return parts;
}

[[noreturn]] void refuse(const LiteralForm& form, const std::string& why) {
  throw Error(ErrorCode::InvalidParameter, fmt::format("This is not a proper {}: {}.", form.name, why),
              fmt::format("Write {}, with lengths in mm.", form.syntax));
}

double measureOf(const LiteralForm& form, std::string_view text) {
  try {
    return parseLength(text);
  } catch (const Error& error) {
    std::string why = error.message();
    if (why.ends_with('.')) why.pop_back();
    refuse(form, why);
  }
}

LiteralForm ballLiteral() {
  LiteralForm form{"ball",
                   "ball:RADIUS[:SUBDIVISIONS]",
                   "A ball about the origin, of 20 faces and four times as many with each subdivision; 1 when left out.",
                   {}};
  form.parse = [declared = form](std::string_view text) -> Shape {
    const auto parts = between(text);
    if (parts.size() > 2) refuse(declared, fmt::format("{} measures are given", parts.size()));
    BallOptions options{.radius = measureOf(declared, parts[0])};
    if (parts.size() == 2) {
      const double subdivisions = measureOf(declared, parts[1]);
      if (subdivisions != std::floor(subdivisions) || subdivisions < 0 || subdivisions > maximumSubdivisions)
        refuse(declared, fmt::format("{} is no whole number from 0 to {}", formatNumber(subdivisions), maximumSubdivisions));
      options.subdivisions = static_cast<int>(subdivisions);
    }
    return ball(options).mesh;
  };
  return form;
}

LiteralForm segmentLiteral() {
  LiteralForm form{"segment", "segment:X:Y:Z", "The straight line from the origin to a point.", {}};
  form.parse = [declared = form](std::string_view text) -> Shape {
    const auto parts = between(text);
    if (parts.size() != 3) refuse(declared, fmt::format("3 coordinates are wanted, {} are given", parts.size()));
    const Vec3 to(measureOf(declared, parts[0]), measureOf(declared, parts[1]), measureOf(declared, parts[2]));
    if (!to.allFinite() || !(to.norm() > 0)) refuse(declared, "it has no length");
    Curve line;
    line.degree = 1;
    line.knots = {0, 0, 1, 1};
    line.poles = {Vec4(0, 0, 0, 1), Vec4(to.x(), to.y(), to.z(), 1)};
    return line;
  };
  return form;
}

}  // namespace

void registerBall(Registry& registry) {
  registry.add(ballFeature());
  registry.add(ballLiteral());
  registry.add(segmentLiteral());
}

}  // namespace blossom::morphology
