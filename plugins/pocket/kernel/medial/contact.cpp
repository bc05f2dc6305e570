#include "kernel/medial/contact.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

#include "kernel/stroke/stroke.h"

namespace blossom::pocket {

namespace {

constexpr int newtonSteps = 30;

struct Pull {
  double distance = 0;
  Vec2 direction = Vec2::Zero();  ///< gradient of the distance
};

Pull pullOf(Contact& contact, const Vec2& x) {
  const Vec2 from = x - footOn(contact, x);
  const double distance = from.norm();
  return {distance, distance > 0 ? Vec2(from / distance) : Vec2(Vec2::Zero())};
}

double settled(const Vec2& x) { return 1e-13 * (1 + x.norm()); }

}  // namespace

Contact contactOf(const Boundary& boundary, const Site& site, const Vec2& x) {
  const auto& pieces = boundary.pieces();
  const Piece& piece = pieces[site.piece];
  const TrueCurve& curve = boundary.curves()[piece.curve];
  const double margin = 4 * boundary.chord() / curve.lengthBound();
  if (site.isPoint) {
    if (pieces[piece.previous].end == Joint::Corner) return {nullptr, 0, piece.from, 0};
    return {&curve, piece.t0, piece.from, margin};
  }
  const double share = nearestShare(piece.from, piece.to, x);
  return {&curve, piece.t0 + share * (piece.t1 - piece.t0), piece.from + share * piece.along(), margin};
}

Vec2 footOn(Contact& contact, const Vec2& x) {
  if (!contact.curve) return contact.point;
  contact.parameter = contact.curve->foot(x, contact.parameter, contact.margin);
  return contact.curve->point(contact.parameter);
}

std::optional<Vec2> pointAtDistance(Contact a, Contact b, double d, const Vec2& guess, double reach) {
  Vec2 x = guess;
  for (int step = 0; step < newtonSteps; ++step) {
    const Pull pa = pullOf(a, x);
    const Pull pb = pullOf(b, x);
    const double determinant = cross(pa.direction, pb.direction);
    if (std::abs(determinant) < 1e-5) return std::nullopt;
    const Vec2 residual(d - pa.distance, d - pb.distance);
    const Vec2 move(cross(residual, Vec2(pa.direction.y(), pb.direction.y())) / determinant,
                    cross(Vec2(pa.direction.x(), pb.direction.x()), residual) / determinant);
    x += move;
    if (!((x - guess).norm() <= reach)) return std::nullopt;
    if (move.norm() <= settled(x)) return x;
  }
  return std::nullopt;
}

std::optional<Vec2> pointBetween(Contact a, Contact b, const Vec2& guess, double reach) {
  Vec2 x = guess;
  for (int step = 0; step < newtonSteps; ++step) {
    const Pull pa = pullOf(a, x);
    const Pull pb = pullOf(b, x);
    const Vec2 across = pa.direction - pb.direction;
    if (across.squaredNorm() < 1e-4) return std::nullopt;
    const Vec2 move = (pb.distance - pa.distance) / across.squaredNorm() * across;
    x += move;
    if (!((x - guess).norm() <= reach)) return std::nullopt;
    if (move.norm() <= settled(x)) return x;
  }
  return std::nullopt;
}

std::optional<Disc> discTouching(std::vector<Contact> contacts, const Disc& guess, double reach) {
  Vec2 x = guess.center;
  double r = guess.radius;
  const auto count = static_cast<Eigen::Index>(contacts.size());
  if (count < 3) return std::nullopt;
  for (int step = 0; step < newtonSteps; ++step) {
    Eigen::MatrixX3d rows(count, 3);
    Eigen::VectorXd residual(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Pull pull = pullOf(contacts[static_cast<std::size_t>(i)], x);
      rows.row(i) << pull.direction.x(), pull.direction.y(), -1.0;
      residual[i] = r - pull.distance;
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixX3d> solver(rows);
    if (std::abs(solver.matrixR()(2, 2)) < 1e-4) return std::nullopt;
    const Vec3 move = solver.solve(residual);
    x += move.head<2>();
    r += move.z();
    if (!((x - guess.center).norm() <= reach)) return std::nullopt;
    if (move.norm() <= settled(x)) {
      if (residual.lpNorm<Eigen::Infinity>() > 1e-9 * (1 + r)) return std::nullopt;
      return Disc{x, r};
    }
  }
  return std::nullopt;
}

}  // namespace blossom::pocket
