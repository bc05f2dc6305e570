#include "kernel/welded.h"

#include <algorithm>
#include <bit>
#include <unordered_map>
#include <vector>

#include "geometry/numeric/point_merge.h"

namespace blossom::morphology {

namespace {

struct NumbersHash {
  template <class Numbers>
  std::size_t operator()(const Numbers& numbers) const {
    std::size_t sum = 0;
    for (const auto number : numbers)
      sum = (std::rotl(sum, 5) ^ std::hash<typename Numbers::value_type>()(number)) * 0x9E3779B97F4A7C15ULL;
    return sum;
  }
};

}  // namespace

std::vector<int> fromLowest(std::vector<int> face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

Mesh withSharedPoints(const Mesh& mesh, const Progress& progress) {
  const std::vector<int> first = mergeEqualPoints(mesh.points, progress);
  Mesh result;
  result.points = mesh.points;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    std::vector<int> face;
    for (const int v : mesh.face(f)) {
      const int vertex = first[static_cast<std::size_t>(v)];
      if (face.empty() || face.back() != vertex) face.push_back(vertex);
    }
    while (face.size() > 1 && face.front() == face.back()) face.pop_back();
    if (face.size() > 2) result.addFace(face);
  }
  return result;
}

Mesh withoutInnerWalls(const Mesh& mesh, const Progress& progress) {
  std::unordered_map<std::vector<int>, std::vector<std::size_t>, NumbersHash> waiting;  // for their counterparts
  waiting.reserve(mesh.faceCount());
  std::vector<bool> inner(mesh.faceCount());
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    if (f % 4096 == 0) progress.check();
    const std::vector<int> face(mesh.face(f).begin(), mesh.face(f).end());
    const auto back = waiting.find(fromLowest({face.rbegin(), face.rend()}));
    if (back == waiting.end() || back->second.empty()) {
      waiting[fromLowest(face)].push_back(f);
      continue;
    }
    inner[f] = inner[back->second.back()] = true;
    back->second.pop_back();
  }
  Mesh result;
  result.points = mesh.points;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f)
    if (!inner[f]) result.addFace(mesh.face(f));
  return result;
}

}  // namespace blossom::morphology
