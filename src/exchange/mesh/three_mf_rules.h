#pragma once
#include <map>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/progress.h"

/// What the 3MF Core Specification 1.3 and its Materials Extension say a file must and must not do, as far as a reader of
/// shapes meets it. A shape can often be read all the same: then the fault is told as a warning.
namespace blossom::three_mf {

/// Faults as sentences; a file full of them does not fill the screen.
class Faults {
 public:
  void add(std::string what);
  [[nodiscard]] std::vector<std::string> sentences() const;

 private:
  std::vector<std::string> told_;
  std::size_t more_ = 0;
};

/// Names and texts of a package. Names are alike in any case; here they are small and begin without a slash.
struct PackageParts {
  std::set<std::string> names;
  std::map<std::string, std::string, std::less<>> texts;  ///< of models, relationships and content types
};

/// Name of a part as PackageParts has it.
std::string partName(std::string_view);
/// Name without the prefix that the file chose for its namespace.
std::string_view localName(const pugi::xml_node&);
/// An attribute by its local name; empty when it is not there.
std::string_view attribute(const pugi::xml_node&, std::string_view name);

/// Relationships and content types. @param model the part that the package begins with
void checkPackage(const PackageParts&, const std::string& model, Faults&);
/// The text of a part before it is parsed: encoding, document type.
void checkText(std::string_view text, Faults&);
/// Elements, attributes and namespaces of a parsed model, and how often what must be there is there.
void checkMarkup(const pugi::xml_document&, const Progress&, Faults&);
/// Ids, references and values of its resources and of what it builds.
void checkResources(const pugi::xml_node& model, const PackageParts&, const Progress&, Faults&);

}  // namespace blossom::three_mf
