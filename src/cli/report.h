#pragma once
#include <iosfwd>
#include <string>
#include <vector>

#include "geometry/measure/measure.h"
#include "parameter/value.h"

namespace blossom {

/// {"kind": .., measure: value, ..}: the content of `result` of `--json`.
Value resultJson(const Measures&);

/// One line of a report for people.
struct ReportRow {
  std::string name;
  std::string value;
  std::string unit;
};

/// Rows of all measures, the kind first. Numbers have enough digits to be read back as the same double.
std::vector<ReportRow> rowsOf(const Measures&);
/// Rows of `stats` or other JSON; units are derived from names such as "kernel_ms".
std::vector<ReportRow> rowsOf(const Value& object);

/// Adds the rows of `more` whose names are not in `rows`.
void addRows(std::vector<ReportRow>& rows, const Value& more);

/// Prints aligned columns: names to the left, numbers at the decimal point.
void printRows(std::ostream&, const std::vector<ReportRow>&);

/// Prints a table with a line of headings and columns as wide as their widest cell.
void printTable(std::ostream&, const std::vector<std::string>& headings, const std::vector<std::vector<std::string>>& lines);

/// Number of terminal columns of a UTF-8 text; every code point counts as one.
std::size_t displayWidth(const std::string&);

}  // namespace blossom
