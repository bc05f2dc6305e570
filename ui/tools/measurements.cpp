#include "ui/tools/measurements.h"

#include <QCoreApplication>
#include <QHash>
#include <algorithm>

#include "ui/look/text.h"
#include "ui/look/theme.h"
#include "ui/tools/view_props.h"

namespace blossom::ui {

namespace {

struct Outcome {
  Measurement figures;
  std::optional<Error> error;
};

Outcome measured(const std::vector<MeasuredPart>& parts, const Progress& progress) {
  try {
    return {parts.size() == 1 ? measureOne(parts[0], progress) : measureBetween(parts[0], parts[1], progress), {}};
  } catch (const Error& error) {
    return {{}, error};
  } catch (const std::exception& problem) {
    return {{}, Error(ErrorCode::Internal, std::string("The parts cannot be measured: ") + problem.what() + ".")};
  }
}

}  // namespace

QString figureName(const std::string& name) {
  static const QHash<QString, const char*> names{
      {QStringLiteral("distance"), QT_TRANSLATE_NOOP("Measurements", "Distance")},
      {QStringLiteral("delta_x"), QT_TRANSLATE_NOOP("Measurements", "Along x")},
      {QStringLiteral("delta_y"), QT_TRANSLATE_NOOP("Measurements", "Along y")},
      {QStringLiteral("delta_z"), QT_TRANSLATE_NOOP("Measurements", "Along z")},
      {QStringLiteral("angle"), QT_TRANSLATE_NOOP("Measurements", "Angle")},
      {QStringLiteral("half_angle"), QT_TRANSLATE_NOOP("Measurements", "Half angle")},
      {QStringLiteral("plane_distance"), QT_TRANSLATE_NOOP("Measurements", "Distance of planes")},
      {QStringLiteral("axis_distance"), QT_TRANSLATE_NOOP("Measurements", "Distance of axes")},
      {QStringLiteral("center_distance"), QT_TRANSLATE_NOOP("Measurements", "Distance of centres")},
      {QStringLiteral("center_x"), QT_TRANSLATE_NOOP("Measurements", "Centre x")},
      {QStringLiteral("center_y"), QT_TRANSLATE_NOOP("Measurements", "Centre y")},
      {QStringLiteral("center_z"), QT_TRANSLATE_NOOP("Measurements", "Centre z")},
      {QStringLiteral("x"), QT_TRANSLATE_NOOP("Measurements", "x")},
      {QStringLiteral("y"), QT_TRANSLATE_NOOP("Measurements", "y")},
      {QStringLiteral("z"), QT_TRANSLATE_NOOP("Measurements", "z")},
      {QStringLiteral("length"), QT_TRANSLATE_NOOP("Measurements", "Length")},
      {QStringLiteral("radius"), QT_TRANSLATE_NOOP("Measurements", "Radius")},
      {QStringLiteral("diameter"), QT_TRANSLATE_NOOP("Measurements", "Diameter")},
      {QStringLiteral("major_radius"), QT_TRANSLATE_NOOP("Measurements", "Major radius")},
      {QStringLiteral("minor_radius"), QT_TRANSLATE_NOOP("Measurements", "Minor radius")},
      {QStringLiteral("area"), QT_TRANSLATE_NOOP("Measurements", "Area")},
      {QStringLiteral("perimeter"), QT_TRANSLATE_NOOP("Measurements", "Perimeter")},
      {QStringLiteral("volume"), QT_TRANSLATE_NOOP("Measurements", "Volume")},
      {QStringLiteral("size_x"), QT_TRANSLATE_NOOP("Measurements", "Size along x")},
      {QStringLiteral("size_y"), QT_TRANSLATE_NOOP("Measurements", "Size along y")},
      {QStringLiteral("size_z"), QT_TRANSLATE_NOOP("Measurements", "Size along z")}};
  const auto it = names.find(qt(name));
  return it == names.end() ? measureLabel(name) : QCoreApplication::translate("Measurements", *it);
}

Measurements::Measurements(ToolHost& host, QObject* parent) : QObject(parent), host_(host) {
  connect(&ThemeManager::instance(), &ThemeManager::changed, this, &Measurements::changed);
}

Measurements::~Measurements() {
  for (const auto& [id, run] : runs_) run.token.cancel();
}

const Measurements::Entry* Measurements::find(int id) const {
  const auto it = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.id == id; });
  return it == entries_.end() ? nullptr : &*it;
}
Measurements::Entry* Measurements::entry(int id) { return const_cast<Entry*>(find(id)); }

int Measurements::add(const PartReference& first, const std::optional<PartReference>& second) {
  Entry added;
  added.id = ++lastId_;
  added.first = first;
  added.second = second;
  entries_.push_back(std::move(added));
  selected_ = lastId_;
  measure(entries_.back());
  emit changed();
  return lastId_;
}

void Measurements::extend(int id, const PartReference& second) {
  Entry* extended = entry(id);
  if (!extended) return;
  extended->second = second;
  extended->figures = {};
  runs_[id].of.clear();
  measure(*extended);
  emit changed();
}

void Measurements::remove(int id) {
  const Entry* gone = find(id);
  if (!gone) return;
  runs_[id].token.cancel();
  runs_.erase(id);
  const auto place = entries_.begin() + (gone - entries_.data());
  const auto next = entries_.erase(place);
  if (selected_ == id) selected_ = entries_.empty() ? 0 : next == entries_.end() ? entries_.back().id : next->id;
  emit changed();
}

void Measurements::clear() {
  for (const auto& [id, run] : runs_) run.token.cancel();
  runs_.clear();
  entries_.clear();
  selected_ = 0;
  emit changed();
}

void Measurements::select(int id) {
  if (selected_ == id) return;
  selected_ = id;
  emit changed();
}

std::vector<std::shared_ptr<const FeatureResult>> Measurements::resultsOf(const Entry& of, QString& missing) const {
  std::vector<std::shared_ptr<const FeatureResult>> results;
  for (const PartReference* part : {&of.first, of.second ? &*of.second : nullptr}) {
    if (!part) continue;
    if (!host_.document().contains(part->feature)) {
      missing = tr("What was measured is no longer in the document.");
      return {};
    }
    const Feature& feature = host_.document().at(part->feature);
    auto result = feature.suppressed ? nullptr : host_.result(part->feature);
    if (!result || result->error) {
      missing = tr("%1 has no shape at present.").arg(qt(feature.name));
      return {};
    }
    results.push_back(std::move(result));
  }
  return results;
}

void Measurements::documentChanged() {
  if (entries_.empty()) return;
  for (Entry& each : entries_) measure(each);
  emit changed();
}

void Measurements::measure(Entry& of) {
  Run& run = runs_[of.id];
  QString missing;
  auto results = resultsOf(of, missing);
  if (results == run.of && !results.empty()) return;
  run.token.cancel();
  run.token = CancelToken();
  run.of = results;
  of.problem = missing;
  of.state = results.empty() ? State::Lost : State::Computing;
  if (results.empty()) return;
  std::vector<MeasuredPart> parts{{results[0]->evaluated.shape, of.first.kind, of.first.index}};
  if (of.second) parts.push_back({results[1]->evaluated.shape, of.second->kind, of.second->index});
  thread_.start([this, id = of.id, token = run.token, parts] {
    if (token.cancelled()) return;
    here_.post([=, this, outcome = measured(parts, Progress(token))] { finish(id, token, outcome.figures, outcome.error); });
  });
}

void Measurements::finish(int id, const CancelToken& token, const Measurement& figures, const std::optional<Error>& error) {
  Entry* done = entry(id);
  if (!done || token.cancelled()) return;
  done->state = error ? State::Lost : State::Ready;
  done->problem = error ? qt(error->message()) : QString();
  if (!error) done->figures = figures;
  emit changed();
}

QString Measurements::partName(const PartReference& part) const {
  QString feature = host_.document().contains(part.feature) ? qt(host_.document().at(part.feature).name) : qt(part.feature);
  switch (part.kind) {
    case SubShapeKind::Face:
      return tr("%1, face %2").arg(feature).arg(part.index);
    case SubShapeKind::Edge:
      return tr("%1, edge %2").arg(feature).arg(part.index);
    case SubShapeKind::Vertex:
      return tr("%1, point %2").arg(feature).arg(part.index);
    case SubShapeKind::Whole:
      break;
  }
  return feature;
}

QString Measurements::headline(const Entry& of) const {
  if (of.state == State::Lost) return tr("Lost");
  const Measurement& figures = of.figures;
  if (figures.values.empty()) return tr("Measuring");
  if (figures.kind != "x") return readable(figures.values.front());
  QStringList coordinates;
  for (const Measure& value : figures.values)
    coordinates << readable(inShownUnit(std::get<double>(value.value), MeasureUnit::Length));
  return coordinates.join(QStringLiteral(" · "));
}

QString Measurements::text(const Entry& of) const {
  QString text = partName(of.first);
  if (of.second) text = tr("%1 to %2").arg(text, partName(*of.second));
  if (of.state == State::Lost) return text + u'\n' + of.problem;
  // Without the thin spaces between thousands, so that other programs read the numbers.
  for (const Measure& value : of.figures.values)
    text += u'\n' + figureName(value.name) + u'\t' + readable(value).remove(QChar(0x2009)).replace(QChar(0x2212), u'-');
  return text;
}

bool Measurements::isShown(const Entry& of) const {
  const auto visible = [&](const PartReference& part) {
    return host_.document().contains(part.feature) && host_.document().at(part.feature).visible;
  };
  return of.state != State::Lost && !of.figures.values.empty() && visible(of.first) && (!of.second || visible(*of.second));
}

std::vector<vtkSmartPointer<vtkProp>> Measurements::props() const {
  std::vector<vtkSmartPointer<vtkProp>> props;
  const double scale = host_.pixelRatio();
  for (const Entry& each : entries_) {
    if (!isShown(each)) continue;
    const Color color = each.id == selected_ ? host_.look().made : host_.look().control;
    const Measurement& figures = each.figures;
    if (!figures.lines.empty()) {
      props.push_back(linesProp(figures.lines, color, 1.8 * scale));
      if (figures.kind != "angle")
        props.push_back(pointsProp({figures.lines[0].front(), figures.lines[0].back()}, color, 7 * scale));
    } else {
      props.push_back(pointsProp({figures.label}, color, 7 * scale));
    }
    const Theme& colors = theme();
    const QColor border = each.id == selected_ ? colors.color("made") : colors.color("control");
    props.push_back(labelProp(headline(each), figures.label, {colors.color("text"), colors.color("panel"), border, scale}));
  }
  return props;
}

}  // namespace blossom::ui
