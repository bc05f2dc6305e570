#include "cli/axis_json.h"

namespace blossom {

namespace {

Value placeJson(const Vec2& at) { return {at.x(), at.y()}; }

Value footJson(const BoundaryFoot& foot) {
  return {{"loop", foot.loop}, {"segment", foot.segment}, {"parameter", foot.parameter}, {"at", placeJson(foot.at)}};
}

Value edgeJson(const MedialEdge& edge) {
  Value json{{"from", edge.from}, {"to", edge.to}, {"points", Value::array()}, {"feet", Value::array()}};
  for (const Vec3& point : edge.points) json["points"].push_back({point.x(), point.y(), point.z()});
  for (const MedialFeet& feet : edge.feet) json["feet"].push_back({footJson(feet.left), footJson(feet.right)});
  return json;
}

}  // namespace

Value axisJson(const MedialAxis& axis) {
  Value json{{"vertices", Value::array()}, {"edges", Value::array()}};
  for (const MedialVertex& vertex : axis.vertices)
    json["vertices"].push_back(
        {{"at", placeJson(vertex.at)}, {"clearance", vertex.clearance}, {"certified", vertex.certified}});
  for (const MedialEdge& edge : axis.edges) json["edges"].push_back(edgeJson(edge));
  return json;
}

}  // namespace blossom
