#include "cli/report.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <ostream>
#include <utility>

#include "core/error.h"
#include "core/units.h"
#include "parameter/nested_value.h"

namespace blossom {
namespace {

std::string readable(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string unitText(MeasureUnit unit) {
  switch (unit) {
    case MeasureUnit::Length:
      return "mm";
    case MeasureUnit::Area:
      return "mm²";
    case MeasureUnit::Volume:
      return "mm³";
    case MeasureUnit::Angle:
      return "°";
    case MeasureUnit::Time:
      return "s";
    case MeasureUnit::None:
      break;
  }
  return "";
}

std::string valueText(const Value& value) {
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return formatNumber(value.get<double>());
  if (value.is_array()) {
    std::string all;
    for (const auto& each : value) all += (all.empty() ? "" : ", ") + valueText(each);
    return all;
  }
  if (value.is_object()) {
    std::string all;
    for (const auto& [key, each] : value.items()) all += (all.empty() ? "" : ", ") + valueText(each) + " " + key;
    return all;
  }
  return value.dump(-1, ' ', false, Value::error_handler_t::replace);
}

/// "kernel_ms" -> {"kernel", "ms"}
std::pair<std::string, std::string> splitUnit(const std::string& name) {
  constexpr std::array<std::pair<std::string_view, const char*>, 4> units{
      {{"_ms", "ms"}, {"_mm", "mm"}, {"_mm2", "mm²"}, {"_s", "s"}}};
  for (const auto& [ending, unit] : units)
    if (name.size() > ending.size() && name.ends_with(ending)) return {name.substr(0, name.size() - ending.size()), unit};
  return {name, ""};
}

bool isNumber(const std::string& text) {
  return !text.empty() && (std::isdigit(static_cast<unsigned char>(text.back())) != 0) &&
         text.find_first_not_of("0123456789.eE+-") == std::string::npos;
}

/// Columns in front of the decimal point.
std::size_t wholeWidth(const std::string& text) {
  return isNumber(text) ? std::min(text.find_first_of(".e"), text.size()) : 0;
}

void pad(std::ostream& out, const std::string& text, std::size_t width) {
  out << text;
  for (std::size_t i = displayWidth(text); i < width; ++i) out << ' ';
}

}  // namespace

std::size_t displayWidth(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

Value resultJson(const Measures& measures) {
  Value result{{"kind", measures.kind}};
  for (const Measure& each : measures.values)
    if (const double* value = std::get_if<double>(&each.value); value && !std::isfinite(*value))
      throw Error(ErrorCode::LimitExceeded, "The figure \"" + readable(each.name) + "\" is beyond all numbers.",
                  "The shapes may be too large or too small for it.");
  for (const Measure& each : measures.values) std::visit([&](const auto& value) { result[each.name] = value; }, each.value);
  return result;
}

std::vector<ReportRow> rowsOf(const Measures& measures) {
  std::vector<ReportRow> rows{{"kind", measures.kind, ""}};
  const Value values = resultJson(measures);
  for (const Measure& each : measures.values) {
    const std::string name =
        each.unit == MeasureUnit::None ? each.name : splitUnit(each.name).first;  // the unit is printed once
    rows.push_back({readable(name), valueText(values[each.name]), unitText(each.unit)});
  }
  return rows;
}

std::vector<ReportRow> rowsOf(const Value& object) {
  std::vector<ReportRow> rows;
  for (const auto& [key, value] : object.items()) {
    if (value.is_null() || ((value.is_object() || value.is_array()) && value.empty())) continue;
    if (isNestedData(value)) continue;
    const auto [name, unit] = splitUnit(key);
    rows.push_back({readable(name), valueText(value), unit});
  }
  return rows;
}

void addRows(std::vector<ReportRow>& rows, const Value& more) {
  for (ReportRow& row : rowsOf(more))
    if (std::none_of(rows.begin(), rows.end(), [&](const ReportRow& each) { return each.name == row.name; }))
      rows.push_back(std::move(row));
}

void printRows(std::ostream& out, const std::vector<ReportRow>& rows) {
  std::size_t names = 0, whole = 0;
  for (const ReportRow& row : rows) {
    names = std::max(names, displayWidth(row.name));
    whole = std::max(whole, wholeWidth(row.value));
  }
  for (const ReportRow& row : rows) {
    out << "  ";
    pad(out, row.name, names + 2);
    if (isNumber(row.value)) out << std::string(whole - wholeWidth(row.value), ' ');
    out << row.value << (row.unit.empty() ? "" : " ") << row.unit << '\n';
  }
}

void printTable(std::ostream& out, const std::vector<std::string>& headings,
                const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths(headings.size());
  const auto widen = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size() && i < widths.size(); ++i)
      widths[i] = std::max(widths[i], displayWidth(cells[i]));
  };
  widen(headings);
  for (const auto& line : lines) widen(line);
  const auto print = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (i + 1 < cells.size())
        pad(out, cells[i], widths[i] + 2);
      else
        out << cells[i];
    out << '\n';
  };
  if (std::any_of(headings.begin(), headings.end(), [](const auto& heading) { return !heading.empty(); })) print(headings);
  for (const auto& line : lines) print(line);
}

}  // namespace blossom
