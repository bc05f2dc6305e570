// The sizes beside the shape of a DragTool, and their being typed.
#include <QSizeF>
#include <cmath>

#include "core/error.h"
#include "manipulators/drag_tool.h"
#include "manipulators/tool_paint.h"
#include "parameter/written.h"
#include "ui/tools/view_props.h"

namespace blossom::modeling {
namespace {

constexpr QSizeF halfCard(34, 11);  // logical pixels, of a number on its card

QString shownSize(double millimetres, const LengthUnit& unit, int digits) {
  return QStringLiteral("%1 %2").arg(QString::number(millimetres / unit.millimetres, 'g', digits),
                                     QString::fromStdString(unit.name));
}

}  // namespace

// A number stands beside the shape, whatever the zoom: above, below, or half a card to the left or right of its place.
QPointF DragTool::shiftOf(const Dimension& dimension) {
  return {halfCard.width() * dimension.beside.x(), (halfCard.height() + ui::labelGap) * (dimension.beside.y() - 1)};
}

std::optional<std::size_t> DragTool::dimensionUnder(const ui::ToolEvent& event) const {
  if (handleUnder(event)) return std::nullopt;
  const std::vector<Dimension> all = dimensions(parameters_);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto seen = host().onScreen({all[k].at.x(), all[k].at.y(), 0});
    if (!seen) continue;
    const QPointF middle = shiftOf(all[k]) + QPointF(0, ui::labelGap + halfCard.height());
    const double right = event.at.x() - seen->x() - middle.x(), up = seen->y() - event.at.y() - middle.y();
    if (std::abs(right) <= halfCard.width() && std::abs(up) <= halfCard.height()) return k;
  }
  return std::nullopt;
}

ParameterSpec DragTool::specOf(const Dimension& dimension) const {
  for (const ParameterSpec& each : host().registry().at(host().document().at(feature()).type)->parameters)
    if (each.name == dimension.parameter) return each;
  ParameterSpec size = positiveLength();
  size.name = "length";
  return size;
}

std::string DragTool::expressionFor(std::size_t dimension) const {
  const Value& written = host().document().at(feature()).parameters;
  const auto found = written.find(dimensions(parameters_).at(dimension).parameter);
  if (found == written.end()) return {};
  if (isNamedExpression(*found)) return found->at("expression").get<std::string>();
  return found->is_string() ? found->get<std::string>() : std::string();
}

Value DragTool::written(Value kept, const Value& /*next*/, std::size_t dimension, const Value& typed) const {
  kept[dimensions(parameters_).at(dimension).parameter] = typed;
  return kept;
}

// As it was typed, where that still comes to the size in the present unit.
QString DragTool::presentSize(std::size_t dimension) const {
  const Dimension size = dimensions(parameters_).at(dimension);
  QString expression = QString::fromStdString(expressionFor(dimension));
  try {
    const ParameterSpec spec = specOf(size);
    const double comesTo = expression.isEmpty() ? NAN : checked(spec, host().typed(spec, expression)).get<double>();
    if (std::abs(comesTo - size.value) <= 1e-9 * (1 + size.value)) return expression;
  } catch (const Error&) {
    // not with the names and units of now
  }
  return shownSize(size.value, host().lengthUnit(), 10);
}

bool DragTool::doubleClick(const ui::ToolEvent& event) {
  noteScale(event);
  const auto under = event.button == Qt::LeftButton ? dimensionUnder(event) : std::nullopt;
  if (!under) return false;
  typing_ = under;
  entry_.open(presentSize(*under));
  refusal_.clear();
  emit changed();
  return true;
}

void DragTool::stopTyping() {
  typing_.reset();
  refusal_.clear();
}

bool DragTool::typingKey(const QKeyEvent& event) {
  const ui::TypedKey key = entry_.key(event);
  if (key == ui::TypedKey::Other) return false;
  refusal_.clear();
  if (key == ui::TypedKey::Leave) stopTyping();
  if (key == ui::TypedKey::Take) takeTyped();
  emit changed();
  return true;
}

// What was typed is kept as such: as the parameter that it is, or in the points that it moves.
void DragTool::takeTyped() {
  if (entry_.unchanged()) return stopTyping();
  const std::size_t index = *typing_;
  const Dimension dimension = dimensions(parameters_).at(index);
  try {
    const ParameterSpec spec = specOf(dimension);
    const Value typed = host().typed(spec, entry_.text());
    const auto next = resized(parameters_, index, checked(spec, typed).get<double>());
    if (!next) {
      refusal_ = tr("The outline cannot have this size.");
      return;
    }
    Feature changed = with(*next).at(feature());
    changed.parameters = written(changed.parameters, *next, index, typed);
    const Document document = base_.with(std::move(changed));
    stopTyping();
    HandleTool::commit(document, tr("Change %1").arg(dimension.what));
  } catch (const Error& error) {
    refusal_ = QString::fromStdString(error.message());
  }
}

/// Where a dimension stands; by the last event where there is no view.
double DragTool::pixelsPerMm(const Dimension& dimension) const {
  const Vec2 next = dimension.at + dimension.beside;
  const auto here = host().onScreen({dimension.at.x(), dimension.at.y(), 0});
  const auto there = host().onScreen({next.x(), next.y(), 0});
  if (!here || !there) return 1 / millimetresPerPixel();
  return std::hypot(there->x() - here->x(), there->y() - here->y());
}

void DragTool::paintDimensions(ToolPaint& painter) const {
  constexpr std::size_t mostNumbers = 12;  // more would cover the shape
  constexpr double leastPixels = 36;       // of a side with a number
  const std::vector<Dimension> all = dimensions(parameters_);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (k == typing_) {
      painter.entry(all[k].at, entry_, shiftOf(all[k]));
      continue;
    }
    const bool lit = k == pointed_;
    if (!lit && (all.size() > mostNumbers || all[k].value * pixelsPerMm(all[k]) < leastPixels)) continue;
    const QString shown = shownSize(all[k].value, host().lengthUnit(), 6);
    painter.label(all[k].at, all[k].radius ? QStringLiteral("R ") + shown : shown,
                  lit ? painter.look().made : painter.look().control, shiftOf(all[k]));
  }
}

}  // namespace blossom::modeling
