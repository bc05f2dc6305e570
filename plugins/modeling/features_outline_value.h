#pragma once
#include "kernel/outline/outline_drawn.h"
#include "parameter/parameter.h"

/// Drawn outlines as the parameters of the feature type `modeling.outline`, for its declaration and for the drawing tool.
namespace blossom::modeling {

inline const char* drawnKindName(DrawnKind kind) {
  return kind == DrawnKind::Line ? "line" : kind == DrawnKind::Arc ? "arc" : "spline";
}

inline Value pointValue(const Vec2& p) { return Value::array({p.x(), p.y(), 0.0}); }
inline Vec2 pointOf(const Value& value) { return {value.at(0).get<double>(), value.at(1).get<double>()}; }

/// A segment from a record of the parameter "segments".
inline DrawnSegment drawnSegmentOf(const Value& record) {
  DrawnSegment segment;
  const std::string kind = record.value("kind", "line");
  segment.kind = kind == "arc" ? DrawnKind::Arc : kind == "spline" ? DrawnKind::Spline : DrawnKind::Line;
  segment.to = pointOf(record.at("to"));
  segment.tangent = record.value("tangent", false);
  if (const auto through = record.find("through"); through != record.end() && through->is_array())
    for (const Value& point : *through) segment.through.push_back(pointOf(point));
  return segment;
}

inline Value valueOf(const DrawnSegment& segment) {
  Value through = Value::array();
  for (const Vec2& p : segment.through) through.push_back(pointValue(p));
  return {{"kind", drawnKindName(segment.kind)},
          {"to", pointValue(segment.to)},
          {"through", std::move(through)},
          {"tangent", segment.tangent}};
}

/// An outline from the canonical parameters of the feature; absent ones have their defaults.
inline DrawnOutline drawnOutlineOf(const Value& parameters) {
  DrawnOutline outline;
  if (const auto start = parameters.find("start"); start != parameters.end()) outline.start = pointOf(*start);
  if (const auto segments = parameters.find("segments"); segments != parameters.end())
    for (const Value& record : *segments) outline.segments.push_back(drawnSegmentOf(record));
  outline.closed = parameters.value("closed", true);
  return outline;
}

inline Value parametersOf(const DrawnOutline& outline) {
  Value segments = Value::array();
  for (const DrawnSegment& segment : outline.segments) segments.push_back(valueOf(segment));
  return {{"start", pointValue(outline.start)}, {"segments", std::move(segments)}, {"closed", outline.closed}};
}

}  // namespace blossom::modeling
