#pragma once
#include <iosfwd>
#include <string>
#include <vector>

#include "geometry/measure/measure.h"
#include "parameter/value.h"

namespace blossom {

/// {"kind": .., measure: value, ..}: what `result` of --json holds.
Value resultJson(const Measures&);

/// One line of a report for people: a name, a value, a unit.
struct ReportRow {
  std::string name;
  std::string value;
  std::string unit;
};

/// Rows of all measures, the kind first. Numbers are written so that they read back as the same double.
std::vector<ReportRow> rowsOf(const Measures&);
/// Rows of `stats` or other JSON; units follow from names such as "kernel_ms".
std::vector<ReportRow> rowsOf(const Value& object);

/// Adds the rows of `more` whose name is not there yet.
void addRows(std::vector<ReportRow>& rows, const Value& more);

/// Columns that align: names to the left, numbers at their decimal point.
void printRows(std::ostream&, const std::vector<ReportRow>&);

/// A table with a line of headings; columns as wide as what they hold.
void printTable(std::ostream&, const std::vector<std::string>& headings, const std::vector<std::vector<std::string>>& lines);

/// Number of columns that a UTF-8 text takes on a screen (every code point counts as one).
std::size_t displayWidth(const std::string&);

}  // namespace blossom
