#include "kernel/in_order.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

namespace blossom::morphology {

namespace {

std::array<double, 3> keyOf(const Vec3& p) { return {p.x() + 0.0, p.y() + 0.0, p.z() + 0.0}; }

/// For each vertex the number of its place in the order of places.
std::vector<int> ranksOf(const std::vector<Vec3>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keyOf(points[a]) < keyOf(points[b]); });
  std::vector<int> ranks(points.size(), 0);
  for (std::size_t k = 1; k < order.size(); ++k)
    ranks[order[k]] = ranks[order[k - 1]] + (keyOf(points[order[k - 1]]) < keyOf(points[order[k]]) ? 1 : 0);
  return ranks;
}

/// Turns a face so that it begins with its lowest corner; of several, so that what follows is lowest.
void turnToLowest(std::span<int> face, const std::vector<int>& ranks) {
  const std::size_t count = face.size();
  const auto rank = [&](std::size_t k) { return ranks[static_cast<std::size_t>(face[k % count])]; };
  const auto isLower = [&](std::size_t a, std::size_t b) {
    for (std::size_t k = 0; k < count; ++k)
      if (rank(a + k) != rank(b + k)) return rank(a + k) < rank(b + k);
    return false;
  };
  std::size_t best = 0;
  for (std::size_t start = 1; start < count; ++start)
    if (isLower(start, best)) best = start;
  std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(best), face.end());
}

}  // namespace

Mesh inOrder(const Mesh& mesh) {
  const std::vector<int> ranks = ranksOf(mesh.points);
  const auto lower = [&](int a, int b) { return ranks[static_cast<std::size_t>(a)] < ranks[static_cast<std::size_t>(b)]; };
  std::vector<int> corners = mesh.faceVertices;
  std::vector<std::span<int>> faces;
  faces.reserve(mesh.faceCount());
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    faces.push_back(std::span(corners).subspan(static_cast<std::size_t>(mesh.faceStarts[f]), mesh.face(f).size()));
    turnToLowest(faces.back(), ranks);
  }
  std::stable_sort(faces.begin(), faces.end(), [&](const auto& a, const auto& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), lower);
  });
  std::vector<int> used;  // in the order of first use
  std::vector<bool> seen(mesh.points.size(), false);
  for (const auto& face : faces)
    for (const int v : face)
      if (!seen[static_cast<std::size_t>(v)]) {
        seen[static_cast<std::size_t>(v)] = true;
        used.push_back(v);
      }
  std::stable_sort(used.begin(), used.end(), lower);
  std::vector<int> number(mesh.points.size(), -1);
  Mesh result;
  result.name = mesh.name;
  result.color = mesh.color;
  for (const int v : used) {
    number[static_cast<std::size_t>(v)] = static_cast<int>(result.points.size());
    result.points.push_back(mesh.points[static_cast<std::size_t>(v)]);
  }
  for (const auto& face : faces) {
    for (int& v : face) v = number[static_cast<std::size_t>(v)];
    result.addFace(face);
  }
  return result;
}

}  // namespace blossom::morphology
