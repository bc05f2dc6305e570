#pragma once
#include <BRepCheck_Analyzer.hxx>
#include <initializer_list>
#include <numbers>

#include "app/app.h"
#include "feature/frame_by_frame.h"
#include "geometry/measure/measure.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/bounds.h"
#include "support/support.h"

/// Feature types of the plugin modeling, called as the evaluator calls them.
namespace blossom::test {

inline const App& theApp() {
  static const App app = [] {
    qputenv("BLOSSOM_WORKER", (buildFolder() / "bin/blossom-worker").c_str());
    return loadApp();
  }();
  return app;
}

inline Evaluated made(const char* command, const Value& parameters = Value::object(), const std::vector<Shape>& inputs = {},
                      const Progress& progress = Progress::none()) {
  const auto type = theApp().registry->at(command);
  return evaluatedFeature(*type, completed(type->parameters, parameters), arrangedInputs(*type, inputs), progress);
}

/// The Error that it throws; Internal with an empty message when it throws none.
inline Error refusal(const char* command, const Value& parameters = Value::object(), const std::vector<Shape>& inputs = {}) {
  try {
    made(command, parameters, inputs);
  } catch (const Error& error) {
    return error;
  }
  return Error(ErrorCode::Internal, "");
}

inline double figure(const Shape& shape, const std::string& name) {
  for (const Measure& each : measure(shape).values) {
    if (each.name != name) continue;
    if (const auto* number = std::get_if<double>(&each.value)) return *number;
    if (const auto* number = std::get_if<std::int64_t>(&each.value)) return static_cast<double>(*number);
    if (const auto* yes = std::get_if<bool>(&each.value)) return *yes;
  }
  return std::nan("");
}
inline double volume(const Evaluated& e) { return figure(e.shape, "volume"); }
inline double surfaceArea(const Evaluated& e) { return figure(e.shape, "area"); }

/// A closed solid that BRepCheck likes, looking outward.
inline bool isSound(const Evaluated& e) {
  const Brep* brep = e.shape.get<Brep>();
  return brep && BRepCheck_Analyzer(brep->shape()).IsValid() && measure(e.shape).kind == "solid" &&
         figure(e.shape, "closed") == 1 && volume(e) > 0;
}

inline Path polygon(const std::vector<Vec2>& corners, bool closed = true) {
  Path path;
  path.closed = closed;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) path.segments.emplace_back(Line2{corners[i], corners[i + 1]});
  if (closed) path.segments.emplace_back(Line2{corners.back(), corners.front()});
  return path;
}
inline Path circle(const Vec2& center, double radius, bool hole = false) {
  Path path;
  path.closed = true;
  path.segments.emplace_back(Arc2{center, radius, 0, (hole ? -2 : 2) * std::numbers::pi});
  return path;
}
inline Region rectangle(double x0, double y0, double x1, double y1) {
  return {{polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}})}};
}

}  // namespace blossom::test

/// The feature refuses with this code, and its sentence holds `words`.
#define VERIFY_REFUSED(refused, wanted, words)                                      \
  do {                                                                              \
    const blossom::Error refused_ = (refused);                                      \
    QVERIFY2(refused_.code() == (wanted), refused_.what());                         \
    QVERIFY2(refused_.message().find(words) != std::string::npos, refused_.what()); \
  } while (false)
