#pragma once
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "core/vector.h"
#include "geometry/mesh/mesh.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/shape/shape.h"
#include "geometry/values/box.h"

/// Polyhedra with known measures, and measures computed without any sum.
namespace blossom::test {

inline double volumeOf(const Mesh& mesh) { return signedVolume(triangulated(mesh).first); }
inline double areaOf(const Mesh& mesh) { return area(triangulated(mesh).first); }
inline Bounds boundsOf(const Mesh& mesh) {
  Bounds bounds;
  for (const Vec3& p : mesh.points) bounds.add(p);
  return bounds;
}
/// Of all components together.
inline int genusOf(const Mesh& mesh) {
  int genus = 0;
  for (const MeshComponent& part : meshTopology(mesh).components) genus += part.genus();
  return genus;
}
inline std::size_t componentsOf(const Mesh& mesh) { return meshTopology(mesh).components.size(); }

inline Mesh movedBy(Mesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.points) p += by;
  return mesh;
}
inline Mesh scaledBy(Mesh mesh, double factor) {
  for (Vec3& p : mesh.points) p *= factor;
  return mesh;
}
inline Mesh turnedBy(Mesh mesh, const Eigen::Matrix3d& turn) {
  for (Vec3& p : mesh.points) p = turn * p;
  return mesh;
}
inline Mesh insideOut(const Mesh& mesh) {
  Mesh result;
  result.points = mesh.points;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    std::vector<int> face(mesh.face(f).begin(), mesh.face(f).end());
    std::reverse(face.begin(), face.end());
    result.addFace(face);
  }
  return result;
}
/// -A: points mirrored in the origin, so faces turn round.
inline Mesh reflected(const Mesh& mesh) { return insideOut(scaledBy(mesh, -1)); }
/// Both in one mesh, neither changed.
inline Mesh together(const Mesh& a, const Mesh& b) {
  Mesh result = a;
  for (const Vec3& p : b.points) result.points.push_back(p);
  for (std::size_t f = 0; f < b.faceCount(); ++f) {
    std::vector<int> face(b.face(f).begin(), b.face(f).end());
    for (int& v : face) v += static_cast<int>(a.points.size());
    result.addFace(face);
  }
  return result;
}

/// With what was its z axis along x, y or z: 0, 1 or 2.
inline Mesh along(int axis, Mesh mesh) {
  for (Vec3& p : mesh.points) {
    const Vec3 q = p;
    for (int k = 0; k < 3; ++k) p[(axis + 1 + k) % 3] = q[k];
  }
  return mesh;
}

inline Mesh cuboid(const Vec3& low, const Vec3& high) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.points.emplace_back((i & 1 ? high : low).x(), (i & 2 ? high : low).y(), (i & 4 ? high : low).z());
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& face : faces) mesh.addFace(face);
  return mesh;
}

/// A cube with one corner in the origin and a cube as void in it.
inline Mesh hollowCube(double side, double wall) {
  return together(cuboid({0, 0, 0}, {side, side, side}),
                  insideOut(cuboid(Vec3::Constant(wall), Vec3::Constant(side - wall))));
}

/// Over a polygon (counter-clockwise, convex or not), from z = low to z = high.
inline Mesh prism(const std::vector<Vec2>& polygon, double low, double high) {
  Mesh mesh;
  const int n = static_cast<int>(polygon.size());
  for (const double z : {low, high})
    for (const Vec2& p : polygon) mesh.points.emplace_back(p.x(), p.y(), z);
  std::vector<int> bottom, top;
  for (int k = 0; k < n; ++k) {
    bottom.push_back(n - 1 - k);
    top.push_back(n + k);
    mesh.addFace(std::array{k, (k + 1) % n, n + (k + 1) % n, n + k});
  }
  mesh.addFace(bottom);
  mesh.addFace(top);
  return mesh;
}

inline Mesh tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  Mesh mesh;
  mesh.points = {a, b, c, d};
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  for (const auto& face : faces) mesh.addFace(face);
  return volumeOf(mesh) < 0 ? insideOut(mesh) : mesh;
}
/// The corner of the unit cube at the origin.
inline Mesh cornerTetrahedron() { return tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}); }

/// Arms 4 long and 1 wide along x and y, 2 high.
inline Mesh lBlock() { return prism({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}, 0, 2); }

/// A square plate with a square hole through it (genus 1), about the z axis.
inline Mesh frameBlock(double outer, double inner, double low, double high) {
  Mesh mesh;
  for (const double z : {low, high})
    for (const double r : {outer, inner})
      for (const Vec2& p : {Vec2(-r, -r), Vec2(r, -r), Vec2(r, r), Vec2(-r, r)}) mesh.points.emplace_back(p.x(), p.y(), z);
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    mesh.addFace(std::array{k, next, 8 + next, 8 + k});            // outside
    mesh.addFace(std::array{4 + next, 4 + k, 12 + k, 12 + next});  // round the hole
    mesh.addFace(std::array{8 + k, 8 + next, 12 + next, 12 + k});  // above
    mesh.addFace(std::array{next, k, 4 + k, 4 + next});            // below
  }
  return mesh;
}

inline Eigen::Matrix3d randomTurn(std::mt19937_64& random) {
  std::normal_distribution<double> any;
  Eigen::Quaterniond q(any(random), any(random), any(random), any(random));
  return q.normalized().toRotationMatrix();
}

/// Eight corners at random distances in the directions of a cube's, joined by triangles: seen as a whole from its middle,
/// rarely convex.
inline Mesh spikyCube(std::mt19937_64& random, double reach) {
  std::uniform_real_distribution<double> distance(0.3, 1);
  Mesh mesh = triangulated(cuboid({-1, -1, -1}, {1, 1, 1})).first;
  for (Vec3& p : mesh.points) p *= reach * distance(random) / std::numbers::sqrt3;
  return mesh;
}

/// A triangulated ring with a triangular tube of random places: genus 1.
inline Mesh spikyRing(std::mt19937_64& random, double major, double minor, int around) {
  std::uniform_real_distribution<double> share(0.6, 1);
  Mesh mesh;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < 3; ++j) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / 3, r = minor * share(random);
      mesh.points.emplace_back((major + r * std::cos(v)) * std::cos(u), (major + r * std::cos(v)) * std::sin(u),
                               r * std::sin(v));
    }
  const auto at = [&](int i, int j) { return (i % around) * 3 + j % 3; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < 3; ++j) {
      mesh.addFace(std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.addFace(std::array{at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

/// Whether a point lies in a closed solid, by the solid angle that its triangles fill; not for points of the surface.
inline bool contains(const Mesh& triangles, const Vec3& p) {
  double angle = 0;
  for (std::size_t f = 0; f < triangles.faceCount(); ++f) {
    const auto corners = facePoints(triangles, f);
    const Vec3 a = corners[0] - p, b = corners[1] - p, c = corners[2] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle > 2 * std::numbers::pi;
}

inline Vec3 randomPoint(std::mt19937_64& random, const Bounds& box) {
  std::uniform_real_distribution<double> share(0, 1);
  const Vec3 at(share(random), share(random), share(random));
  return box.low + at.cwiseProduct(box.high - box.low);
}

/// Area of the shadow of a convex solid along a direction: half of what its faces throw.
inline double shadowOf(const Mesh& convex, const Vec3& direction) {
  double sum = 0;
  for (std::size_t f = 0; f < convex.faceCount(); ++f)
    sum += std::abs(vectorArea(facePoints(convex, f)).dot(direction.normalized())) / 2;
  return sum;
}

/// The volume of a convex solid and a cuboid of these sides added up: Steiner's formula for cuboids.
inline double volumeWithCuboid(const Mesh& convex, const Vec3& sides) {
  const Bounds box = boundsOf(convex);
  const Vec3 extent = box.high - box.low;
  double volume = volumeOf(convex) + sides.prod();
  for (int k = 0; k < 3; ++k) {
    volume += sides[k] * shadowOf(convex, Vec3::Unit(k));
    volume += sides[(k + 1) % 3] * sides[(k + 2) % 3] * extent[k];
  }
  return volume;
}

/// Two rings with a rough surface, whose sum takes seconds.
inline std::vector<Shape> secondsOfWork() {
  std::mt19937_64 random(7);
  return {spikyRing(random, 6, 1.5, 240), spikyRing(random, 5, 1, 240)};
}

}  // namespace blossom::test
