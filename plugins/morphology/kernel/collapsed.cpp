#include "kernel/collapsed.h"

#include <algorithm>
#include <map>
#include <vector>

#include "geometry/numeric/point_merge.h"
#include "kernel/welded.h"

namespace blossom::morphology {

namespace {

/// Without corners that repeat the one before, and without ways there and back again.
std::vector<int> withoutSpikes(std::vector<int> face) {
  for (std::size_t k = 0; k < face.size() && face.size() > 2;) {
    const std::size_t n = face.size(), next = (k + 1) % n, after = (k + 2) % n;
    if (face[k] == face[next]) {
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(next));
      k = 0;
    } else if (face[k] == face[after]) {
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(std::max(next, after)));
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(std::min(next, after)));
      k = 0;
    } else {
      ++k;
    }
  }
  return face;
}

}  // namespace

Mesh collapsed(const Mesh& mesh, const Progress& progress) {
  Mesh shared;
  shared.points = mesh.points;
  const std::vector<int> first = mergeEqualPoints(mesh.points, progress);
  std::map<std::vector<int>, int> balance;  // how often a face turns one way more than the other
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    if (f % 4096 == 0) progress.check();
    std::vector<int> face;
    for (const int v : mesh.face(f)) face.push_back(first[static_cast<std::size_t>(v)]);
    face = withoutSpikes(std::move(face));
    if (face.size() < 3) continue;
    std::vector<int> one = fromLowest(face), other = fromLowest({face.rbegin(), face.rend()});
    if (one <= other)
      ++balance[std::move(one)];
    else
      --balance[std::move(other)];
  }
  for (const auto& [face, times] : balance) {
    for (int k = 0; k < times; ++k) shared.addFace(face);
    for (int k = 0; k < -times; ++k) shared.addFace(std::vector<int>(face.rbegin(), face.rend()));
  }
  return shared;
}

}  // namespace blossom::morphology
