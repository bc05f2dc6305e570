#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <gp_Ax2.hxx>

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "feature_groups.h"
#include "geometry/shape/bounds.h"
#include "geometry/shape/setup.h"
#include "geometry/tessellate/tessellate.h"
#include "moved_shape.h"
#include "part_input.h"
#include "shape_triangles.h"
#include "work_zero.h"

namespace blossom::pocket {

namespace {

enum class StockForm { Box, Cylinder };

struct SetupParameters {
  SubShapeValue up;
  StockForm stockForm = StockForm::Box;
  double stockMargin = 5, stockAbove = 0, stockBelow = 0;
  Zero zero = Zero::Corner;
  ZeroHeight zeroHeight = ZeroHeight::Top;
  std::vector<Value> clamps;
  Vec3 travel = Vec3::Zero(), zeroAt = Vec3::Zero();
};

/// From the part as drawn to a place where the face that is to look up does so.
gp_Trsf turnedUp(const Shape& part, const SubShapeValue& up) {
  if (up.index < 0) return {};
  if (!part.get<Brep>())
    throw Error(ErrorCode::InvalidInput, "Only a solid has faces that can look up.", "Leave the face out (up).");
  return partOf(part, up).placing.Inverted();
}

Bounds stockBox(const SetupParameters& p, const Bounds& part) {
  Bounds box;
  box.add(Vec3(part.low - Vec3(p.stockMargin, p.stockMargin, p.stockBelow)));
  box.add(Vec3(part.high + Vec3(p.stockMargin, p.stockMargin, p.stockAbove)));
  if ((box.high - box.low).minCoeff() > 0) return box;
  throw Error(ErrorCode::InvalidInput, "The stock would have no thickness: the part is flat.",
              "Say how far the stock reaches below the part (stock below).");
}

/// The largest distance of anything of a shape from an upright axis, for a round stock.
double reachFrom(const Vec2& axis, const Shape& shape) {
  const Tessellation drawn = tessellate(shape, {.chord = chordOf(shape)});
  double most = 0;
  const auto consider = [&](const Vec3& p) { most = std::max(most, (p.head<2>() - axis).norm()); };
  for (const Vec3& p : drawn.points) consider(p);
  for (const auto& edge : drawn.edges)
    for (const Vec3& p : edge) consider(p);
  return most;
}

Shape stockOf(const SetupParameters& p, const Shape& shape) {
  const Bounds part = bounds(shape);
  const Bounds box = stockBox(p, part);
  const Vec3 size = box.high - box.low;
  if (p.stockForm == StockForm::Box)
    return Brep(BRepPrimAPI_MakeBox(gp_Pnt(box.low.x(), box.low.y(), box.low.z()), size.x(), size.y(), size.z()).Shape(),
                "Stock");
  const Vec3 middle = box.center();
  const double radius = reachFrom(middle.head<2>(), shape) + p.stockMargin;
  const gp_Ax2 axis(gp_Pnt(middle.x(), middle.y(), box.low.z()), gp::DZ());
  return Brep(BRepPrimAPI_MakeCylinder(axis, radius, size.z()).Shape(), "Stock");
}

Vec3 placeIn(const Value& list) {
  return Vec3(list.at(0).get<double>(), list.at(1).get<double>(), list.at(2).get<double>());
}

Vec3 movedPlace(const Vec3& at, const gp_Trsf& by) {
  const gp_Pnt there = gp_Pnt(at.x(), at.y(), at.z()).Transformed(by);
  return {there.X(), there.Y(), there.Z()};
}

/// A box as drawn, where the part is turned: its sides must stay upright or level.
Bounds turnedBox(const Bounds& box, const gp_Trsf& turn, std::size_t number) {
  Bounds turned;
  for (int i = 0; i < 8; ++i)
    turned.add(movedPlace(Vec3((i & 1) != 0 ? box.high.x() : box.low.x(), (i & 2) != 0 ? box.high.y() : box.low.y(),
                               (i & 4) != 0 ? box.high.z() : box.low.z()),
                          turn));
  const double before = (box.high - box.low).prod(), after = (turned.high - turned.low).prod();
  if (after > before * (1 + 1e-6))
    throw Error(ErrorCode::InvalidInput, fmt::format("Clamp {} would stand aslant where that face looks up.", number),
                "Draw the part so that the face that looks up and the clamps are square to each other.");
  return turned;
}

std::vector<Bounds> clampsOf(const SetupParameters& p, const gp_Trsf& turn) {
  std::vector<Bounds> clamps;
  for (const Value& record : p.clamps) {
    const Vec3 corner = placeIn(record.at("corner")), size = placeIn(record.at("size"));
    if (!(size.minCoeff() > 0))
      throw Error(ErrorCode::InvalidParameter, fmt::format("Clamp {} has no extent.", clamps.size() + 1),
                  "Give its size along x, y and z, each above 0.");
    Bounds drawn;
    drawn.add(corner);
    drawn.add(Vec3(corner + size));
    clamps.push_back(turnedBox(drawn, turn, clamps.size() + 1));
  }
  return clamps;
}

/// Where the tip can go, from the work's zero.
Bounds travelOf(const SetupParameters& p) {
  Bounds travel;
  if (p.travel.isZero()) return travel;
  if (!(p.travel.minCoeff() > 0))
    throw Error(ErrorCode::InvalidParameter, "The machine does not travel along all three axes.",
                "Give three lengths above 0, or 0,0,0 when they are not known.");
  travel.add(Vec3(-p.zeroAt));
  travel.add(Vec3(p.travel - p.zeroAt));
  return travel;
}

void warnOfClamps(const Setup& setup, std::vector<std::string>& warnings) {
  Bounds stock;
  for (const Shape& each : setup.stock) stock.add(bounds(each));
  for (std::size_t i = 0; i < setup.clamps.size(); ++i) {
    const Bounds& clamp = setup.clamps[i];
    const Vec3 overlap = clamp.high.cwiseMin(stock.high) - clamp.low.cwiseMax(stock.low);
    if (overlap.minCoeff() > 1e-6) warnings.push_back(fmt::format("Clamp {} reaches into the box around the stock.", i + 1));
  }
}

Evaluated setupOf(const SetupParameters& p, const Inputs& inputs, const Progress& progress) {
  const Shape& part = inputs.of(0)[0];
  const gp_Trsf turn = turnedUp(part, p.up);
  const Shape turned = movedShape(part, turn);
  const bool given = !inputs.of(1).empty();
  const Shape stock = given ? movedShape(inputs.of(1)[0], turn) : stockOf(p, turned);
  progress.check();
  const Vec3 zero = zeroOf(p.zero, p.zeroHeight, bounds(stock), movedPlace(Vec3::Zero(), turn));
  const gp_Trsf toZero = movedBy(-zero);
  Setup setup;
  if (part.kind() == ShapeKind::Brep || part.kind() == ShapeKind::Mesh) setup.part.push_back(movedShape(turned, toZero));
  setup.stock.push_back(movedShape(stock, toZero));
  for (Bounds clamp : clampsOf(p, turn)) {
    clamp.low -= zero;
    clamp.high -= zero;
    setup.clamps.push_back(clamp);
  }
  setup.travel = travelOf(p);
  setup.drawing = (toZero * turn).Inverted();
  Evaluated out;
  warnOfClamps(setup, out.warnings);
  out.shape = std::move(setup);
  return out;
}

ParameterSpec named(const char* name, ParameterSpec spec, const char* help, Value fallback) {
  spec.name = name;
  spec.help = help;
  spec.fallback = std::move(fallback);
  return spec;
}

ParameterSpec clampRecord() {
  return record({named("corner", point(), "Its lowest corner, as the part is drawn.", Value::array({0, 0, 0})),
                 named("size", displacement(), "Its size along x, y and z.", Value::array({20, 20, 20}))});
}

}  // namespace

FeatureType setupFeature() {
  using P = SetupParameters;
  return feature<P>("pocket.setup", "Setup", "A part in its stock on the machine, with clamps and the work's zero.")
      .icon("setup")
      .keywords({"stock", "clamp", "fixture", "machine", "zero", "travel", "job"})
      .produces({ShapeKind::Setup})
      .input({.name = "part",
              .help = "The solid that is to be made, or its outline.",
              .kinds = {ShapeKind::Region, ShapeKind::Curves, ShapeKind::Brep, ShapeKind::Mesh},
              .use = InputUse::Consumed,
              .asks = "a part to set up"})
      .input({.name = "stock",
              .help = "A solid that the part is cut from, drawn around it; without one it is a box or a cylinder.",
              .kinds = {ShapeKind::Brep, ShapeKind::Mesh},
              .minimum = 0,
              .use = InputUse::Consumed,
              .asks = "a solid that the part is cut from"})
      .parameter("up", &P::up, whenNone(optional(subShape("face")), "z is up, as drawn"), "The flat face that looks up.")
      .parameter("stock-form", &P::stockForm, onlyWithout(choice({"box", "cylinder"}), "stock"), "The form of the stock.")
      .parameter("stock-margin", &P::stockMargin, onlyWithout(lengthFromZero(), "stock"),
                 "How far the stock reaches beside the part.")
      .parameter("stock-above", &P::stockAbove, onlyWithout(lengthFromZero(), "stock"),
                 "How far the stock reaches above the part.")
      .parameter("stock-below", &P::stockBelow, onlyWithout(lengthFromZero(), "stock"),
                 "How far the stock reaches below the part.")
      .parameter("clamps", &P::clamps, list(clampRecord()), "Boxes that hold the stock; no part of the tool may touch them.")
      .parameter("zero", &P::zero, choice({"drawing", "corner", "center"}),
                 "The work's zero: that of the drawing, or the stock's lower left corner or centre.")
      .parameter("zero-height", &P::zeroHeight, choice({"top", "bottom", "drawing"}),
                 "The height of zero: the stock's top or bottom, or that of the drawing.")
      .parameter("travel", &P::travel, displacement(), "How far the machine moves the tool's tip; 0,0,0: not known.")
      .parameter("zero-at", &P::zeroAt, point(), "Where the work's zero lies in the travel, from its lowest corner.")
      .example("blossom setup bracket.step --stock-margin 5 --stock-above 1 --zero corner -o setup.png")
      .example(
          "blossom setup cover.step --clamps '[{\"corner\": [-20, 10, 0], \"size\": [25, 15, 12]}]' --travel 400,300,100 "
          "--zero-at 100,80,60 --json")
      .evaluate(setupOf);
}

}  // namespace blossom::pocket
