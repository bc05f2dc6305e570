#pragma once
#include <algorithm>
#include <functional>
#include <memory>
#include <numbers>
#include <random>

#include "support/picked_parts.h"
#include "support/random.h"

/// Constructions with a part that is picked in their results, and random edits after which the test knows where it is.
namespace blossom::test {

inline int oneOf(Random& random, int count) { return std::uniform_int_distribution(0, count - 1)(random); }

/// Corners and the sides from one to the next, each with a name of its own that is known to the test alone. A corner keeps
/// its name while it is there: what stands on it stays what it is while one of its sides is divided.
class Corners {
 public:
  explicit Corners(const std::vector<Vec2>& places) {
    for (const Vec2& p : places) {
      corners_.push_back({next_, next_, p});
      ++next_;
    }
  }
  [[nodiscard]] int size() const { return static_cast<int>(corners_.size()); }
  [[nodiscard]] int nameAt(int k) const { return corners_[static_cast<std::size_t>(wrapped(k))].name; }
  [[nodiscard]] int sideAt(int k) const { return corners_[static_cast<std::size_t>(wrapped(k))].side; }
  [[nodiscard]] std::optional<int> placeOf(int name) const {
    for (int k = 0; k < size(); ++k)
      if (nameAt(k) == name) return k;
    return std::nullopt;
  }
  [[nodiscard]] Vec2 at(int k) const { return corners_[static_cast<std::size_t>(wrapped(k))].at; }
  /// The middle of a side; nothing when it is gone.
  [[nodiscard]] std::optional<Vec2> middle(int side) const {
    for (int k = 0; k < size(); ++k)
      if (sideAt(k) == side) return std::optional<Vec2>((at(k) + at(k + 1)) / 2);
    return std::nullopt;
  }
  [[nodiscard]] std::optional<Vec2> corner(int name) const {
    const auto k = placeOf(name);
    return k ? std::optional<Vec2>(at(*k)) : std::nullopt;
  }
  void move(int k, const Vec2& by) { corners_[static_cast<std::size_t>(wrapped(k))].at += by; }
  void moveAll(const Vec2& by) {
    for (auto& corner : corners_) corner.at += by;
  }
  /// A corner in a side, beside its middle: the side is gone, two new ones are there.
  void insert(int k, double bulge) {
    const Vec2 a = at(k), b = at(k + 1), along = b - a;
    corners_[static_cast<std::size_t>(wrapped(k))].side = next_++;
    const Vec2 inserted = (a + b) / 2 + bulge * Vec2(along.y(), -along.x());
    corners_.insert(corners_.begin() + wrapped(k) + 1, {next_, next_, inserted});
    ++next_;
  }
  void erase(int k) {
    corners_[static_cast<std::size_t>(wrapped(k - 1))].side = next_++;
    corners_.erase(corners_.begin() + wrapped(k));
  }
  void beginAt(int k) { std::rotate(corners_.begin(), corners_.begin() + wrapped(k), corners_.end()); }
  [[nodiscard]] Value parameters() const {
    Value segments = Value::array();
    for (int k = 1; k < size(); ++k) segments.push_back({{"kind", "line"}, {"to", {at(k).x(), at(k).y(), 0}}});
    return {{"start", {at(0).x(), at(0).y(), 0}}, {"segments", segments}};
  }

 private:
  struct Corner {
    int name, side;  ///< of itself and of the side that begins at it
    Vec2 at;
  };
  [[nodiscard]] int wrapped(int k) const { return (k % size() + size()) % size(); }
  std::vector<Corner> corners_;
  int next_ = 0;
};

/// A construction with a part that is picked in its result.
class Model {
 public:
  Model() = default;
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;
  virtual ~Model() = default;
  [[nodiscard]] virtual Document construction() const = 0;  ///< its last feature is the one that parts are picked in
  virtual void pick(Random&) = 0;                           ///< chooses a part
  virtual std::string edit(Random&) = 0;
  /// Where the part that was picked lies; nothing when it is gone.
  [[nodiscard]] virtual std::optional<Vec3> place() const = 0;
  [[nodiscard]] virtual SubShapeKind kind() const { return SubShapeKind::Edge; }
};

/// An extruded outline: the edges at its top and bottom, those that stand, and its sides.
class Prism : public Model {
 public:
  [[nodiscard]] Document construction() const override {
    return with(with({}, "outline", "outline", corners_.parameters()), "prism", "extrude", {{"height", height_}},
                {"outline"});
  }
  void pick(Random& random) override {
    const int k = oneOf(random, corners_.size());
    corner_ = corners_.nameAt(k);
    side_ = corners_.sideAt(k);
    role_ = static_cast<Role>(oneOf(random, 4));
  }
  std::string edit(Random& random) override {
    switch (oneOf(random, 6)) {
      case 0:
        height_ = uniform(random, 8, 30);
        return "height";
      case 1:
        corners_.move(oneOf(random, corners_.size()), {uniform(random, -2, 2), uniform(random, -2, 2)});
        return "corner moved";
      case 2:
        corners_.insert(oneOf(random, corners_.size()), 0.1);
        return "corner inserted";
      case 3:
        if (corners_.size() < 5) return "nothing";
        corners_.erase(oneOf(random, corners_.size()));
        return "corner removed";
      case 4:
        corners_.moveAll({uniform(random, -9, 9), uniform(random, -9, 9)});
        return "outline moved";
      default:
        corners_.beginAt(oneOf(random, corners_.size()));
        return "outline begun elsewhere";
    }
  }
  [[nodiscard]] std::optional<Vec3> place() const override {
    const auto at = role_ == Role::Standing ? corners_.corner(corner_) : corners_.middle(side_);
    if (!at) return std::nullopt;
    return Vec3(at->x(), at->y(), role_ == Role::Bottom ? 0 : role_ == Role::Top ? height_ : height_ / 2);
  }
  [[nodiscard]] SubShapeKind kind() const override { return role_ == Role::Side ? SubShapeKind::Face : SubShapeKind::Edge; }

 protected:
  enum class Role { Top, Bottom, Standing, Side };
  Corners corners_{{{0, 0}, {60, 0}, {62, 20}, {30, 24}, {31, 45}, {-2, 40}}};
  double height_ = 20;
  int corner_ = 0, side_ = 0;
  Role role_ = Role::Top;
};

/// A prism with holes: their rims and what is left of the prism.
class Drilled final : public Prism {
 public:
  [[nodiscard]] Document construction() const override {
    Document document = Prism::construction();
    std::vector<FeatureId> inputs{"prism"};
    for (const Hole& hole : holes_) {
      inputs.push_back("hole-" + std::to_string(hole.name));
      document = with(document, inputs.back().c_str(), "cylinder",
                      {{"radius", hole.radius}, {"height", 80}, {"position", {hole.at.x(), hole.at.y(), -20}}});
    }
    return with(document, "drilled", "boolean", {{"operation", "difference"}}, inputs);
  }
  void pick(Random& random) override {
    Prism::pick(random);
    hole_ =
        oneOf(random, 2) == 0 ? -1 : holes_[static_cast<std::size_t>(oneOf(random, static_cast<int>(holes_.size())))].name;
  }
  std::string edit(Random& random) override {
    switch (oneOf(random, 5)) {
      case 0: {
        Hole& hole = holes_[static_cast<std::size_t>(oneOf(random, static_cast<int>(holes_.size())))];
        hole.radius = uniform(random, 1, 2.5);
        hole.at += Vec2(uniform(random, -0.5, 0.5), uniform(random, -0.5, 0.5));
        return "hole changed";
      }
      case 1:
        holes_.push_back({next_++, {uniform(random, 38, 50), uniform(random, 8, 12)}, 1});
        return "hole added";
      case 2:
        if (holes_.size() < 2) return "nothing";
        holes_.erase(holes_.begin() + oneOf(random, static_cast<int>(holes_.size())));
        return "hole removed";
      case 3:
        height_ = uniform(random, 8, 30);
        return "height";
      default:
        corners_.insert(oneOf(random, corners_.size()), 0.05);
        return "corner inserted";
    }
  }
  [[nodiscard]] std::optional<Vec3> place() const override {
    if (hole_ < 0) return Prism::place();
    const auto found = std::find_if(holes_.begin(), holes_.end(), [&](const Hole& hole) { return hole.name == hole_; });
    if (found == holes_.end()) return std::nullopt;
    return Vec3(found->at.x() - found->radius, found->at.y(), role_ == Role::Bottom ? 0 : height_);
  }
  [[nodiscard]] SubShapeKind kind() const override { return hole_ < 0 ? Prism::kind() : SubShapeKind::Edge; }

 private:
  struct Hole {
    int name;
    Vec2 at;
    double radius;
  };
  std::vector<Hole> holes_{{0, {10, 10}, 2}, {1, {20, 12}, 1.5}, {2, {12, 25}, 2.2}};
  int next_ = 3, hole_ = -1;
};

/// An outline turned about the y axis: its rings.
class Turned final : public Model {
 public:
  [[nodiscard]] Document construction() const override {
    return with(with({}, "profile", "outline", corners_.parameters()), "turned", "revolve", {{"angle", angle_}},
                {"profile"});
  }
  void pick(Random& random) override { name_ = corners_.nameAt(oneOf(random, corners_.size())); }
  std::string edit(Random& random) override {
    const int k = oneOf(random, corners_.size());
    switch (oneOf(random, 4)) {
      case 0:
        angle_ = uniform(random, 40, 320);
        return "angle";
      case 1:
        corners_.move(k, {uniform(random, -1, 1), uniform(random, -1, 1)});
        return "corner moved";
      case 2:
        corners_.insert(k, 0.1);
        return "corner inserted";
      default:
        if (corners_.size() < 5) return "nothing";
        corners_.erase(k);
        return "corner removed";
    }
  }
  [[nodiscard]] std::optional<Vec3> place() const override {
    const auto corner = corners_.corner(name_);
    const double half = angle_ * std::numbers::pi / 360;
    if (!corner) return std::nullopt;
    return Vec3(corner->x() * std::cos(half), corner->y(), -corner->x() * std::sin(half));
  }

 private:
  Corners corners_{{{10, 0}, {30, 2}, {28, 12}, {20, 14}, {22, 30}, {9, 33}}};
  double angle_ = 200;
  int name_ = 0;
};

/// A prism with one rounded corner that stays: the edges that the rounding leaves alone.
class Rounded final : public Prism {
 public:
  [[nodiscard]] Document construction() const override {
    const Document prism = Prism::construction();
    return with(prism, "rounded", "fillet", {{"radius", radius_}, {"edges", edges_}}, {"prism"});
  }
  void pick(Random& random) override {
    do Prism::pick(random);
    while (!isApart() || role_ == Role::Side);
  }
  std::string edit(Random& random) override {
    if (oneOf(random, 3) == 0) {
      radius_ = uniform(random, 1, 3);
      return "radius";
    }
    const int k = 2 + oneOf(random, corners_.size() - 3);
    if (oneOf(random, 2) == 0) {
      corners_.move(k, {uniform(random, -2, 2), uniform(random, -2, 2)});
      return "corner moved";
    }
    corners_.insert(k, 0.08);
    return "corner inserted";
  }
  Value edges_ = Value::array();
  static constexpr int roundedCorner = 0;
  [[nodiscard]] Vec3 roundedAt() const { return {corners_.at(0).x(), corners_.at(0).y(), height_ / 2}; }

 private:
  [[nodiscard]] bool isApart() const {
    const int k = *corners_.placeOf(corner_);
    return k != 0 && k != corners_.size() - 1;
  }
  double radius_ = 2;
};

/// A half and its mirror image as one body: edges of the image.
class Mirrored final : public Model {
 public:
  [[nodiscard]] Document construction() const override {
    Document document = with({}, "half", "outline", corners_.parameters());
    document = with(document, "solid", "extrude", {{"height", height_}}, {"half"});
    return with(document, "whole", "mirror", {{"normal", {1, 0, 0}}, {"keep", true}, {"join", true}}, {"solid"});
  }
  void pick(Random& random) override {
    side_ = corners_.sideAt(oneOf(random, corners_.size() - 1));
    top_ = oneOf(random, 2) == 0;
    image_ = oneOf(random, 2) == 0;
  }
  // The first corner and the last lie on the mirror, and stay there.
  std::string edit(Random& random) override {
    const int k = 1 + oneOf(random, corners_.size() - 2);
    switch (oneOf(random, 3)) {
      case 0:
        height_ = uniform(random, 5, 25);
        return "height";
      case 1:
        corners_.move(k, {uniform(random, -1, 1), uniform(random, -1, 1)});
        return "corner moved";
      default:
        if (k + 1 >= corners_.size() - 1) return "nothing";
        corners_.insert(k, 0.1);
        return "corner inserted";
    }
  }
  [[nodiscard]] std::optional<Vec3> place() const override {
    const auto middle = corners_.middle(side_);
    if (!middle) return std::nullopt;
    return Vec3(image_ ? -middle->x() : middle->x(), middle->y(), top_ ? height_ : 0);
  }

 private:
  Corners corners_{{{0, 0}, {20, 3}, {24, 15}, {12, 18}, {14, 30}, {0, 33}}};
  double height_ = 12;
  int side_ = 0;
  bool top_ = true, image_ = false;
};

/// A row of holes in a plate: their rims.
class Row final : public Model {
 public:
  [[nodiscard]] Document construction() const override {
    Document document = with({}, "plate", "box", {{"width", width_}, {"depth", 30}, {"height", height_}});
    document = with(document, "drill", "cylinder", {{"radius", radius_}, {"height", 90}, {"position", {8, 15, -30}}});
    document = with(document, "row", "pattern", {{"count", count_}, {"step", {step_, 0, 0}}}, {"drill"});
    return with(document, "holes", "boolean", {{"operation", "difference"}}, {"plate", "row"});
  }
  void pick(Random& random) override {
    copy_ = oneOf(random, count_);
    top_ = oneOf(random, 2) == 0;
  }
  std::string edit(Random& random) override {
    switch (oneOf(random, 5)) {
      case 0:
        count_ = 2 + oneOf(random, 6);
        return "count";
      case 1:
        step_ = oneOf(random, 3) == 0 ? 2 * step_ : uniform(random, 8, 12);
        step_ = step_ > 13 ? 10 : step_;
        return "step";
      case 2:
        radius_ = uniform(random, 1, 3);
        return "radius";
      case 3:
        width_ = uniform(random, 110, 150);
        return "width";
      default:
        height_ = uniform(random, 4, 20);
        return "height";
    }
  }
  [[nodiscard]] std::optional<Vec3> place() const override {
    if (copy_ >= count_) return std::nullopt;
    return Vec3(8 + copy_ * step_ - radius_, 15, top_ ? height_ : 0);
  }

 private:
  int count_ = 5, copy_ = 0;
  double step_ = 10, radius_ = 2, width_ = 120, height_ = 10;
  bool top_ = true;
};

}  // namespace blossom::test
