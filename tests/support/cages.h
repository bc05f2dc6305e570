#pragma once
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/mesh/mesh.h"

/// Cages for the tests of subdivision.
namespace blossom::test {

inline void addPolygon(Mesh& mesh, std::vector<int> vertices) { mesh.addFace(vertices); }

/// Two polygons with n corners and the quads between them.
inline Mesh prism(int n) {
  Mesh mesh;
  for (int z = 0; z < 2; ++z)
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      mesh.points.emplace_back(std::cos(angle), std::sin(angle), 2.0 * z - 1);
    }
  std::vector<int> low, high;
  for (int i = 0; i < n; ++i) {
    low.push_back(n - 1 - i);
    high.push_back(n + i);
    addPolygon(mesh, {i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  mesh.addFace(low);
  mesh.addFace(high);
  return mesh;
}

inline Mesh cubeCage() {
  Mesh mesh = prism(4);
  for (Vec3& p : mesh.points) p = {p.x() - p.y(), p.x() + p.y(), p.z()};
  return mesh;
}

/// columns x rows quads in the plane z = 0, one unit each.
inline Mesh gridCage(int columns, int rows) {
  Mesh mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) mesh.points.emplace_back(i, j, 0);
  const int row = columns + 1;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int at = j * row + i;
      addPolygon(mesh, {at, at + 1, at + row + 1, at + row});
    }
  return mesh;
}

/// n x m quads, closed both ways.
inline Mesh torusCage(int n, int m) {
  Mesh mesh;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double u = 2 * std::numbers::pi * i / n, v = 2 * std::numbers::pi * j / m;
      mesh.points.emplace_back((3 + std::cos(v)) * std::cos(u), (3 + std::cos(v)) * std::sin(u), std::sin(v));
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const int right = (i + 1) % n, up = (j + 1) % m;
      addPolygon(mesh, {i * m + j, right * m + j, right * m + up, i * m + up});
    }
  return mesh;
}

inline Mesh octahedron() {
  Mesh mesh;
  mesh.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const auto& [a, b] : {std::pair(0, 2), std::pair(2, 1), std::pair(1, 3), std::pair(3, 0)}) {
    addPolygon(mesh, {a, b, 4});
    addPolygon(mesh, {b, a, 5});
  }
  return mesh;
}

inline Mesh jittered(Mesh mesh, std::mt19937_64& random, double size) {
  std::uniform_real_distribution<double> offset(-size, size);
  for (Vec3& p : mesh.points) p += Vec3(offset(random), offset(random), offset(random));
  return mesh;
}

inline Mesh withoutFace(const Mesh& mesh, std::size_t gone) {
  Mesh result = mesh;
  result.faceStarts = {0};
  result.faceVertices.clear();
  for (std::size_t f = 0; f < mesh.faceCount(); ++f)
    if (f != gone) result.addFace(mesh.face(f));
  return result;
}

}  // namespace blossom::test
