#pragma once
#include <algorithm>
#include <random>
#include <vector>

#include "geometry/bspline/curve.h"
#include "geometry/bspline/surface.h"
#include "support/random.h"

/// Random B-splines: any degree, knots of any multiplicity, clamped and unclamped.
namespace blossom::test {

struct KnotChoice {
  int spans = 6;                  ///< at most
  bool clamped = false;           ///< else clamped or not by chance
  int highest = 0;                ///< multiplicity of inner knots; 0 means the degree
  double from = 0, to = 1;        ///< domain
  std::vector<double> pool = {};  ///< inner knots are taken from here with probability 1/2
};

inline std::vector<double> randomKnots(Random& random, int degree, const KnotChoice& choice = {}) {
  const double length = choice.to - choice.from;
  const int highest = choice.highest ? choice.highest : degree;
  std::vector<double> inner;
  for (int i = uniformInt(random, 1, choice.spans); i > 1; --i) {
    const bool shared = !choice.pool.empty() && uniformInt(random, 0, 1) == 1;
    const int last = static_cast<int>(choice.pool.size()) - 1;
    inner.push_back(shared ? choice.pool[static_cast<std::size_t>(uniformInt(random, 0, last))]
                           : choice.from + length * uniform(random, 0.02, 0.98));
  }
  std::sort(inner.begin(), inner.end());
  inner.erase(std::unique(inner.begin(), inner.end()), inner.end());

  const bool clamped = choice.clamped || uniformInt(random, 0, 1) == 1;
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, choice.from);
  for (const double at : inner) knots.insert(knots.end(), static_cast<std::size_t>(uniformInt(random, 1, highest)), at);
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, choice.to);
  if (clamped) return knots;
  // outer knots wander off, some of them multiple
  const auto step = [&] { return uniformInt(random, 0, 3) == 0 ? 0.0 : length * uniform(random, 0.05, 0.3); };
  for (int i = degree - 1; i >= 0; --i) knots[static_cast<std::size_t>(i)] = knots[static_cast<std::size_t>(i) + 1] - step();
  for (std::size_t i = knots.size() - static_cast<std::size_t>(degree); i < knots.size(); ++i)
    knots[i] = knots[i - 1] + step();
  return knots;
}

/// Homogeneous pole of a point in a cube of half size `size` with a weight of 1/2 to 2.
inline Vec4 randomPole(Random& random, double size) {
  const double w = uniform(random, 0.5, 2);
  const double x = uniform(random, -size, size), y = uniform(random, -size, size), z = uniform(random, -size, size);
  return {w * x, w * y, w * z, w};
}

inline Curve randomCurve(Random& random, int degree, const KnotChoice& choice = {}, double size = 10) {
  Curve curve{degree, randomKnots(random, degree, choice), {}};
  while (curve.poles.size() + static_cast<std::size_t>(degree) + 1 < curve.knots.size())
    curve.poles.push_back(randomPole(random, size));
  return curve;
}

inline Surface randomSurface(Random& random, int degreeU, int degreeV, const KnotChoice& u = {}, const KnotChoice& v = {},
                             double size = 10) {
  Surface surface{degreeU, degreeV, randomKnots(random, degreeU, u), randomKnots(random, degreeV, v), {}};
  for (std::size_t i = surface.countU() * surface.countV(); i > 0; --i) surface.poles.push_back(randomPole(random, size));
  return surface;
}

/// A parameter of the domain; its ends now and then.
inline double randomParameter(Random& random, std::pair<double, double> domain) {
  const int choice = uniformInt(random, 0, 9);
  return choice == 0 ? domain.first : choice == 1 ? domain.second : uniform(random, domain.first, domain.second);
}

/// Largest component of the poles.
inline double magnitude(const std::vector<Vec4>& poles) {
  double largest = 0;
  for (const Vec4& pole : poles) largest = std::max(largest, pole.cwiseAbs().maxCoeff());
  return largest;
}

}  // namespace blossom::test
