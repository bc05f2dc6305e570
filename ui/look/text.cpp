#include "ui/look/text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "parameter/nested_value.h"
#include "ui/look/units.h"

namespace blossom::ui {

namespace {

constexpr QChar thinSpace(0x2009);

QString grouped(QString digits) {
  const qsizetype start = digits.startsWith(u'-') || digits.startsWith(QChar(0x2212)) ? 1 : 0;
  qsizetype end = digits.indexOf(u'.');
  if (end < 0) end = digits.size();
  for (qsizetype i = end - 3; i > start; i -= 3) digits.insert(i, thinSpace);
  return digits;
}

QString unitText(MeasureUnit unit) {
  switch (unit) {
    case MeasureUnit::None:
      return {};
    case MeasureUnit::Length:
      return u' ' + qt(lengthUnit().name);
    case MeasureUnit::Area:
      return u' ' + qt(lengthUnit().name) + u'²';
    case MeasureUnit::Volume:
      return u' ' + qt(lengthUnit().name) + u'³';
    case MeasureUnit::Angle:
      return QStringLiteral("°");
    case MeasureUnit::Time:
      return QStringLiteral(" s");
  }
  return {};
}

// Names of figures may end in their unit.
const std::vector<std::pair<QString, MeasureUnit>>& unitSuffixes() {
  static const std::vector<std::pair<QString, MeasureUnit>> suffixes{{QStringLiteral("_mm2"), MeasureUnit::Area},
                                                                     {QStringLiteral("_mm"), MeasureUnit::Length},
                                                                     {QStringLiteral("_ms"), MeasureUnit::None},
                                                                     {QStringLiteral("_s"), MeasureUnit::Time}};
  return suffixes;
}

MeasureUnit unitOfStat(const std::string& name) {
  for (const char* length : {"deviation", "_place", "_radius"})
    if (qt(name).endsWith(QLatin1String(length))) return MeasureUnit::Length;
  for (const auto& [suffix, unit] : unitSuffixes())
    if (qt(name).endsWith(suffix)) return unit;
  return MeasureUnit::None;
}

const Measure* find(const Measures& measures, std::string_view name) {
  for (const Measure& measure : measures.values)
    if (measure.name == name) return &measure;
  return nullptr;
}

}  // namespace

double inShownUnit(double value, MeasureUnit unit) {
  const int power = unit == MeasureUnit::Length ? 1 : unit == MeasureUnit::Area ? 2 : unit == MeasureUnit::Volume ? 3 : 0;
  return value / std::pow(lengthUnit().millimetres, power);
}

QString saidInFull(std::string_view what, std::string_view remedy) {
  return remedy.empty() ? qt(what) : qt(what) + u' ' + qt(remedy);
}

double withoutNoise(double value, double largest) {
  constexpr double noise = 1e-12;
  return std::abs(value) <= noise * largest ? 0 : value;
}

QString fittingNumber(const QString& text, const std::function<bool(const QString&)>& fits) {
  if (fits(text)) return text;
  static const QRegularExpression pattern(QStringLiteral("^([-+]?[0-9]*\\.?[0-9]+(?:e[-+]?[0-9]+)?)( ?[^-+*/()0-9 ]*)$"));
  const QRegularExpressionMatch match = pattern.match(text);
  if (!match.hasMatch()) return text;
  const double value = match.captured(1).toDouble();
  constexpr int mostDigits = 15;
  for (int digits = mostDigits; digits > 0; --digits)
    if (QString shorter = QString::number(value, 'g', digits) + match.captured(2); fits(shorter)) return shorter;
  return text;
}

QString readable(double value, int digits) {
  if (!std::isfinite(value)) return std::isnan(value) ? QStringLiteral("not a number") : QStringLiteral("∞");
  if (value == 0) return QStringLiteral("0");
  const double size = std::abs(value);
  if (size < 1e-4 || size >= 1e12) return QString::number(value, 'e', 2).replace(u'-', QChar(0x2212));
  const int before = std::max(1, static_cast<int>(std::floor(std::log10(size))) + 1);
  QString text = QString::number(value, 'f', size < 1 ? digits : std::max(0, digits - before));
  if (text.contains(u'.')) {
    while (text.endsWith(u'0')) text.chop(1);
    if (text.endsWith(u'.')) text.chop(1);
  }
  return grouped(text.replace(u'-', QChar(0x2212)));
}

QString readable(std::int64_t value) { return grouped(QString::number(value).replace(u'-', QChar(0x2212))); }

QString readable(const Measure& measure) {
  struct Writer {
    MeasureUnit unit;
    QString operator()(bool value) const {
      return value ? QCoreApplication::translate("blossom::ui::ResultTable", "yes")
                   : QCoreApplication::translate("blossom::ui::ResultTable", "no");
    }
    QString operator()(std::int64_t value) const { return readable(value) + unitText(unit); }
    QString operator()(double value) const { return readable(inShownUnit(value, unit), 6) + unitText(unit); }
    QString operator()(const std::string& value) const { return qt(value); }
  };
  return std::visit(Writer{measure.unit}, measure.value);
}

QString sentenceCase(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

namespace {

QString englishLabel(const std::string& name) {
  static const std::map<std::string, QString> labels{{"min_weight", QStringLiteral("Smallest weight")},
                                                     {"deviation", QStringLiteral("Largest deviation")},
                                                     {"export_deviation", QStringLiteral("Off the motion")},
                                                     {"crosses_itself", QStringLiteral("Crosses itself")},
                                                     {"crossing_depth", QStringLiteral("Depth of the crossing")},
                                                     {"min_weight_place", QStringLiteral("Smallest weight at")},
                                                     {"crossing_place", QStringLiteral("Crosses itself at")},
                                                     {"min_normal", QStringLiteral("Min |xu × xv|")},
                                                     {"min_normal_place", QStringLiteral("Min |xu × xv| at")},
                                                     {"closed_u", QStringLiteral("Closing in u")},
                                                     {"entities", QStringLiteral("In the file")},
                                                     {"caps", QStringLiteral("Ends")},
                                                     {"worker_ms", QStringLiteral("Helper process")},
                                                     {"refinements", QStringLiteral("Knots inserted")},
                                                     {"skipped", QStringLiteral("Left out")}};
  const auto it = labels.find(name);
  if (it != labels.end()) return it->second;
  QString words = qt(name);
  for (const QString& axis : {QStringLiteral("u"), QStringLiteral("v")})
    if (words.endsWith(u'_' + axis)) words = words.chopped(2) + QStringLiteral(" in ") + axis;
  for (const auto& [suffix, unit] : unitSuffixes())
    if (words.endsWith(suffix)) words.chop(suffix.size());
  return sentenceCase(words.replace(u'_', u' '));
}

}  // namespace

// Names of figures come from everywhere: those in resources/translations/features_*.ts are translated.
QString measureLabel(const std::string& name) {
  return QCoreApplication::translate("Figures", englishLabel(name).toUtf8().constData());
}

QString shownShapeKind(const std::string& kind) { return QCoreApplication::translate("Figures", kind.c_str()); }

QString shownWarning(const std::string& warning) { return QCoreApplication::translate("Warnings", warning.c_str()); }

QString statUnit(const std::string& name) {
  return qt(name).endsWith(QLatin1String("_ms")) ? QStringLiteral(" ms") : unitText(unitOfStat(name));
}

namespace {

/// Without what is nothing beside the largest.
Value coordinates(const Value& values, double factor) {
  double largest = 0;
  for (const Value& each : values) largest = std::max(largest, std::abs(each.get<double>()));
  Value shown = Value::array();
  for (const Value& each : values) shown.push_back(factor * withoutNoise(each.get<double>(), largest));
  return shown;
}

}  // namespace

Value shownStat(const std::string& name, const Value& value) {
  const double factor = inShownUnit(1, unitOfStat(name));
  const auto isNumber = [](const Value& each) { return each.is_number(); };
  if (value.is_array() && std::all_of(value.begin(), value.end(), isNumber)) return coordinates(value, factor);
  return factor != 1 && value.is_number() ? Value(factor * value.get<double>()) : value;
}

bool worthReading(const std::string& name, const Value& value) {
  static const std::set<std::string> technical{"min_normal_share",   "min_normal_at", "min_weight_at", "crossing_first_at",
                                               "crossing_second_at", "check_ms",      "sum_ms",        "unite_ms",
                                               "output_ms"};
  const bool nothing = (value.is_structured() && value.empty()) || value.is_null() ||
                       (name == "refinements" && value.is_number() && value.get<double>() == 0);
  return !nothing && !technical.contains(name) && !isNestedData(value);
}

QString counted(const QString& count, const QString& noun) {
  if (count == QLatin1String("1") || noun != noun.toLower())
    return count + u' ' + noun;  // LINE and ARC are names, not words
  if (noun == QLatin1String("vertex")) return count + QStringLiteral(" vertices");
  if (noun.endsWith(u'y')) return count + u' ' + noun.chopped(1) + QStringLiteral("ies");
  const bool hissing = noun.endsWith(QLatin1String("sh")) || noun.endsWith(u'x');
  return count + u' ' + noun + (noun.endsWith(u's') ? QString() : hissing ? QStringLiteral("es") : QStringLiteral("s"));
}

QString stateLine(const Measures& measures) {
  QStringList parts;
  QString head = shownShapeKind(measures.kind);
  const Measure* degreeU = find(measures, "degree_u");
  const Measure* degreeV = find(measures, "degree_v");
  if (degreeU && degreeV) head += QStringLiteral(" %1 × %2").arg(readable(*degreeU), readable(*degreeV));
  parts << head;
  for (const char* name : {"volume", "area", "length", "length_mm"}) {
    const Measure* measure = find(measures, name);
    if (!measure || !std::holds_alternative<double>(measure->value)) continue;
    parts << readable(inShownUnit(std::get<double>(measure->value), measure->unit), 4) + unitText(measure->unit);
    break;
  }
  if (parts.size() == 1)
    for (const char* name : {"faces", "curves", "frames", "loops", "spans"})
      if (const Measure* measure = find(measures, name)) {
        const QString count = readable(*measure);
        const QByteArray noun = QByteArray(name).chopped(count == QLatin1String("1") ? 1 : 0);
        parts << QStringLiteral("%1 %2").arg(count, QCoreApplication::translate("Figures", noun.constData()));
        break;
      }
  return parts.join(QStringLiteral(", "));
}

}  // namespace blossom::ui
