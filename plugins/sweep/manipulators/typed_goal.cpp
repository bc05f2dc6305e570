#include "manipulators/typed_goal.h"

#include <QKeyEvent>

#include "core/error.h"

namespace blossom::sweep {

namespace {

constexpr qsizetype coordinates = 3;

[[noreturn]] void refuseNumberOfCoordinates() {
  throw Error(ErrorCode::InvalidParameter,
              GoalEntry::tr("A target has three coordinates: x, y, z. One that is left empty stays, as in \"0, -20,\".")
                  .toStdString());
}

[[noreturn]] void refuseMoreCoordinates(qsizetype typed) {
  throw Error(ErrorCode::InvalidParameter,
              GoalEntry::tr("%1 coordinates were typed; a target has three: x, y, z.").arg(typed).toStdString());
}

/// Between commas, but for those within parentheses; semicolons part as well.
QStringList coordinatesIn(const QString& text) {
  QStringList parts{QString()};
  int depth = 0;
  for (const QChar& each : text) {
    if (each == u'(') ++depth;
    if (each == u')') --depth;
    if (depth <= 0 && (each == u',' || each == u';'))
      parts << QString();
    else
      parts.last() += each;
  }
  return parts;
}

QString shownNumber(double value) {
  constexpr int digits = 6;
  return QString::number(std::abs(value) < 1e-9 ? 0 : value, 'g', digits);
}

}  // namespace

GoalEntry GoalEntry::ofPoint(const ui::ToolHost& host, const Vec3& present) {
  GoalEntry entry;
  entry.present_ = present;
  QStringList all;
  for (Eigen::Index k = 0; k < 3; ++k) all << shownNumber(present[k] / host.lengthUnit().millimetres);
  entry.text_.open(all.join(QStringLiteral(", ")));
  return entry;
}

GoalEntry GoalEntry::ofAngle(double presentDegrees) {
  GoalEntry entry;
  entry.angle_ = true;
  entry.text_.open(shownNumber(presentDegrees));
  return entry;
}

// A present text that is still selected is left with its first coordinate as it is.
ui::TypedKey GoalEntry::key(const QKeyEvent& event) {
  if (event.key() != Qt::Key_Tab && event.key() != Qt::Key_Backtab) return text_.key(event);
  const bool more = text_.selected() || coordinatesIn(text_.text()).size() < coordinates;
  if (event.key() == Qt::Key_Tab && !angle_ && more) {
    if (!text_.selected()) text_.toEnd();
    text_.type(QStringLiteral(", "));
  }
  return ui::TypedKey::Text;  // the focus stays where something is typed
}

GoalEntry::Goal GoalEntry::goal(const ui::ToolHost& host) const {
  if (!angle_ && coordinatesIn(text_.text()).size() < coordinates) refuseNumberOfCoordinates();
  return goalSoFar(host);
}

GoalEntry::Goal GoalEntry::goalSoFar(const ui::ToolHost& host) const {
  if (!angle_) return pointGoal(host);
  ParameterSpec spec = angle();
  spec.name = "angle";
  const Value written = host.typed(spec, text_.text());
  return {Vec3::Zero(), checked(spec, written).get<double>(), written};
}

GoalEntry::Goal GoalEntry::pointGoal(const ui::ToolHost& host) const {
  QString text = text_.text().trimmed();
  const bool relative = text.startsWith(u'@');  // from where the place is
  if (relative) text.remove(0, 1);
  QStringList parts = coordinatesIn(text);
  if (parts.size() > coordinates) refuseMoreCoordinates(parts.size());
  while (parts.size() < coordinates) parts << QString();
  Goal goal{present_, 0, Value::array()};
  for (int k = 0; k < 3; ++k) {
    if (!parts[k].trimmed().isEmpty()) {
      ParameterSpec spec = coordinateOf(point());
      spec.name = std::array{"x", "y", "z"}.at(static_cast<std::size_t>(k));
      goal.written.push_back(host.typed(spec, parts[k].trimmed()));
      goal.point[k] = checked(spec, goal.written.back()).get<double>();
      if (relative) goal.written.back() = goal.point[k] = present_[k] + goal.point[k];
    } else {
      goal.written.push_back(present_[k]);
    }
  }
  return goal;
}

}  // namespace blossom::sweep
