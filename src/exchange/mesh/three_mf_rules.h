#pragma once
#include <map>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/progress.h"

/// Rules of the 3MF Core Specification 1.3 and its Materials Extension that concern a reader of shapes. A file that breaks
/// them can often be read all the same; the fault is then reported as a warning.
namespace blossom::three_mf {

/// Collects faults as sentences; their number is limited.
class Faults {
 public:
  void add(std::string what);
  [[nodiscard]] std::vector<std::string> sentences() const;

 private:
  std::vector<std::string> told_;
  std::size_t more_ = 0;
};

/// Names and texts of a package. Names are case-insensitive; here they are lower case without a leading slash.
struct PackageParts {
  std::set<std::string> names;
  std::map<std::string, std::string, std::less<>> texts;  ///< of models, relationships and content types
};

/// Name of a part in the form used by PackageParts.
std::string partName(std::string_view);
/// Name without the namespace prefix.
std::string_view localName(const pugi::xml_node&);
/// An attribute by its local name; empty when there is none.
std::string_view attribute(const pugi::xml_node&, std::string_view name);

/// Checks relationships and content types. @param model the root part of the package
void checkPackage(const PackageParts&, const std::string& model, Faults&);
/// Checks the text of a part before it is parsed: encoding, document type.
void checkText(std::string_view text, Faults&);
/// Checks elements, attributes and namespaces of a parsed model, and the number of required elements.
void checkMarkup(const pugi::xml_document&, const Progress&, Faults&);
/// Checks ids, references and values of the resources and of the build.
void checkResources(const pugi::xml_node& model, const PackageParts&, const Progress&, Faults&);

}  // namespace blossom::three_mf
