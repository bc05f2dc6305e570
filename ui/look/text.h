#pragma once
#include <QString>
#include <functional>
#include <string>
#include <string_view>

#include "core/error.h"
#include "geometry/measure/measure.h"
#include "parameter/value.h"

namespace blossom::ui {

inline QString qt(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())); }

/// What happened, and what to do about it where that is known, in one line.
QString saidInFull(std::string_view what, std::string_view remedy);
inline QString saidInFull(const Error& error) { return saidInFull(error.message(), error.hint()); }

/// 0 where a value is no more than the rounding of others that are as large as `largest`: 1e-12 of it.
double withoutNoise(double value, double largest);
/// A number, perhaps with its unit, "-31.534218 mm", with as many digits as fit. What is no number, as an expression, stays,
/// and so does what fits in no way.
QString fittingNumber(const QString& text, const std::function<bool(const QString&)>& fits);
/// "1 842.6": at most `digits` significant digits after the integer part has been kept whole, thin spaces between thousands.
QString readable(double value, int digits = 5);
QString readable(std::int64_t value);
/// A measure with its unit: "128.3 mm²".
QString readable(const Measure&);
/// A length, area or volume (mm) in the unit of length that the user prefers.
double inShownUnit(double value, MeasureUnit);
/// "Smallest weight" for "min_weight", in the language of the window.
QString measureLabel(const std::string& name);
/// "surface", a kind of shape, in the language of the window.
QString shownShapeKind(const std::string& kind);
/// A warning in the language of the window, where its words are always the same; else as it was given.
QString shownWarning(const std::string& warning);
/// " mm" where the name of a figure says it; lengths and areas in the unit that the user prefers, as shownStat gives them.
QString statUnit(const std::string& name);
/// A figure in the unit that statUnit names; what is no number stays as it is.
Value shownStat(const std::string& name, const Value&);
/// False for figures that only tell a programmer something, or that say that nothing happened.
bool worthReading(const std::string& name, const Value&);
/// "5 solids", "1 vertex", "84 vertices"; names in capitals stay as they are.
QString counted(const QString& count, const QString& noun);
/// "surface 9 × 12, 128 mm²": what the tree says under a name.
QString stateLine(const Measures&);
/// First letter in upper case.
QString sentenceCase(QString);

}  // namespace blossom::ui
