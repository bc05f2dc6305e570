#include "exchange/plain/motion_edits.h"

#include <type_traits>

namespace blossom {

namespace {

constexpr int largestFold = 360;
constexpr double fullTurn = 360;

/// One entry or a list of such entries: [u, v] or [[u, v], ..].
template <int N, class Entry>
std::vector<Entry> oneOrMany(const MotionNode& node, const char* what, Entry (*of)(const Eigen::Matrix<double, N, 1>&)) {
  if (node.value.is_array() && !node.value.empty() && node.value.front().is_number()) return {of(node.numbers<N>(what))};
  if (node.value.is_array() && node.value.empty()) node.fail(fmt::format("is empty; it must hold {} or several", what));
  std::vector<Entry> all;
  const std::size_t count = node.arraySize(what);
  for (std::size_t i = 0; i < count; ++i) all.push_back(of(node[i].numbers<N>(what)));
  return all;
}

std::vector<MotionPlace> readPlaces(const MotionNode& node) {
  return oneOrMany<2, MotionPlace>(node, "a place [u, v]", [](const Vec2& uv) { return MotionPlace{uv.x(), uv.y()}; });
}

std::vector<Vec3> readTargets(const MotionNode& node) {
  return oneOrMany<3, Vec3>(node, "a point [x, y, z]", [](const Vec3& p) { return p; });
}

Vec3 readAxis(const MotionNode& node) {
  Vec3 axis = node.numbers<3>("a direction [x, y, z]");
  if (axis.isZero(0)) node.fail("must have a length");
  return axis;
}

/// Shares that are left out are 0 beside others.
PullWeights readWeights(const MotionNode& node) {
  node.requireObject({"translate", "rotate", "scale"});
  const auto share = [&](const char* key) { return node.has(key) ? node.at(key).numberWithin(0, 1) : 0.0; };
  const PullWeights weights{share("translate"), share("rotate"), share("scale")};
  if (weights == PullWeights{0, 0, 0}) node.fail("must give translate, rotate or scale a share above 0");
  return weights;
}

EditSymmetry readSymmetry(const MotionNode& node) {
  node.requireObject({"fold", "mirror"});
  EditSymmetry symmetry;
  if (node.has("fold")) symmetry.fold = node.at("fold").wholeNumberWithin(1, largestFold);
  if (node.has("mirror")) symmetry.mirror = node.at("mirror").yesOrNo();
  return symmetry;
}

template <class Edit>
Edit withCommonKeys(const MotionNode& node) {
  Edit edit;
  edit.at = readPlaces(node.at("at"));
  if (node.has("pins")) edit.pins = node.at("pins").value.empty() ? edit.pins : readPlaces(node.at("pins"));
  if (node.has("symmetry")) edit.symmetry = readSymmetry(node.at("symmetry"));
  if (node.has("level")) edit.level = node.at("level").wholeNumberWithin(coarsestLevel, finestLevel);
  return edit;
}

MotionEdit readPull(const MotionNode& node) {
  node.requireObject({"at", "to", "weights", "axis", "pins", "symmetry", "level"});
  MotionPull pull = withCommonKeys<MotionPull>(node);  // places first: they say how many targets there must be
  pull.to = readTargets(node.at("to"));
  if (node.has("weights")) pull.weights = readWeights(node.at("weights"));
  if (node.has("axis")) pull.axis = readAxis(node.at("axis"));
  const std::size_t places = pull.at.size();
  if (pull.to.size() != places)
    node.at("to").fail(
        fmt::format("must hold one point for each of the {} places of \"at\"; it holds {}", places, pull.to.size()));
  return pull;
}

MotionEdit readTwist(const MotionNode& node) {
  node.requireObject({"at", "twist", "pins", "symmetry", "level"});
  const MotionNode given = node.at("twist");
  given.requireObject({"axis", "angle"});
  MotionTwist twist = withCommonKeys<MotionTwist>(node);
  twist.axis = readAxis(given.at("axis"));
  twist.angle = given.at("angle").numberWithin(-fullTurn, fullTurn);
  return twist;
}

MotionEdit readEdit(const MotionNode& node) {
  if (!node.value.is_object()) node.fail("must be an object");
  if (node.has("twist") == node.has("to"))
    node.fail("must have either \"to\", where the places go, or \"twist\", how they are turned");
  return node.has("twist") ? readTwist(node) : readPull(node);
}

Value json(const MotionPlace& place) { return Value::array({place.u, place.v}); }
Value json(const Vec3& p) { return Value::array({p.x(), p.y(), p.z()}); }

template <class Entry>
Value oneOrManyJson(const std::vector<Entry>& entries) {
  if (entries.size() == 1) return json(entries.front());
  Value all = Value::array();
  for (const Entry& each : entries) all.push_back(json(each));
  return all;
}

Value editJson(const MotionPull& pull) {
  Value edit{
      {"at", oneOrManyJson(pull.at)},
      {"to", oneOrManyJson(pull.to)},
      {"weights", {{"translate", pull.weights.translate}, {"rotate", pull.weights.rotate}, {"scale", pull.weights.scale}}}};
  if (!pull.axis.isZero(0)) edit["axis"] = json(pull.axis);
  return edit;
}

Value editJson(const MotionTwist& twist) {
  return {{"at", oneOrManyJson(twist.at)}, {"twist", {{"axis", json(twist.axis)}, {"angle", twist.angle}}}};
}

}  // namespace

std::vector<MotionEdit> readEdits(const MotionNode& edits) {
  if (!edits.value.is_array()) edits.fail("must be a list");
  std::vector<MotionEdit> all;
  if (edits.value.empty()) return all;
  const std::size_t count = edits.arraySize("edits");
  for (std::size_t i = 0; i < count; ++i) all.push_back(readEdit(edits[i]));
  return all;
}

Value editsJson(const std::vector<MotionEdit>& edits) {
  Value all = Value::array();
  for (const MotionEdit& each : edits)
    all.push_back(std::visit(
        [](const auto& edit) {
          Value written = editJson(edit);
          if (!edit.pins.empty()) written["pins"] = oneOrManyJson(edit.pins);
          if (!(edit.symmetry == EditSymmetry{}))
            written["symmetry"] = {{"fold", edit.symmetry.fold}, {"mirror", edit.symmetry.mirror}};
          if (edit.level != 0) written["level"] = edit.level;
          return written;
        },
        each));
  return all;
}

}  // namespace blossom
