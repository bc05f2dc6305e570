#pragma once
#include <memory>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "geometry/bspline/curve.h"
#include "geometry/bspline/surface.h"
#include "geometry/mesh/mesh.h"
#include "geometry/planar/medial_axis.h"
#include "geometry/planar/region.h"
#include "geometry/shape/brep.h"
#include "geometry/shape/motion.h"
#include "geometry/shape/sequence.h"
#include "geometry/shape/setup.h"
#include "geometry/shape/toolpath.h"

namespace blossom {

enum class ShapeKind { None, Region, Curves, Curve, Surface, Brep, Mesh, Motion, Sequence, MedialAxis, Toolpath, Setup };

/// The name as users read it: "region", "curves", "surface", ..
std::string_view shapeKindName(ShapeKind) noexcept;

/// An immutable value of any kind, passed between features. Copies share the value, so a Shape is cheap to copy and safe to
/// read from any thread.
class Shape {
 public:
  using Value = std::variant<std::monostate, Region, Curves, Curve, Surface, Brep, Mesh, Motion, Sequence, MedialAxis,
                             Toolpath, Setup>;

  Shape() = default;
  template <class T, class = std::enable_if_t<!std::is_same_v<std::decay_t<T>, Shape>>>
  Shape(T value) : value_(std::make_shared<const Value>(std::move(value))) {}

  [[nodiscard]] ShapeKind kind() const noexcept {
    return value_ ? static_cast<ShapeKind>(value_->index()) : ShapeKind::None;
  }
  [[nodiscard]] bool empty() const noexcept { return kind() == ShapeKind::None; }
  /// nullptr when it is of another kind.
  template <class T>
  [[nodiscard]] const T* get() const noexcept {
    return value_ ? std::get_if<T>(value_.get()) : nullptr;
  }
  /// Calls the visitor with the value (std::monostate when empty).
  template <class Visitor>
  decltype(auto) visit(Visitor&& visitor) const {
    static const Value none;
    return std::visit(std::forward<Visitor>(visitor), value_ ? *value_ : none);
  }

 private:
  std::shared_ptr<const Value> value_;
};

/// The planar curves that represent a shape in a drawing: for regions, curves, medial axes and toolpaths; empty for other
/// kinds.
std::optional<Curves> drawingOf(const Shape&);

}  // namespace blossom
