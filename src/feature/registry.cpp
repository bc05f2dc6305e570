#include "feature/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.h"
#include "feature/declaration.h"

namespace blossom {

using declaration::broken;

void Registry::add(FeatureType type) {
  declaration::check(type);
  for (const auto& other : types_) {
    if (other->id == type.id) broken(fmt::format("The feature type \"{}\"", type.id), "exists already");
    if (other->command == type.command)
      broken(fmt::format("The command \"{}\" of {}", type.command, type.id), fmt::format("is taken by {}", other->id));
  }
  types_.push_back(std::make_shared<const FeatureType>(std::move(type)));
}

void Registry::add(LiteralForm form) {
  const std::string what = fmt::format("The literal form \"{}\"", form.name);
  if (!declaration::isName(form.name)) broken(what, "has no proper name");
  if (!form.parse) broken(what, "cannot be read");
  for (const auto& other : literals_)
    if (other.name == form.name) broken(what, "exists already");
  literals_.push_back(std::move(form));
}

void Registry::add(Format format) {
  declaration::check(format);
  const std::string what = fmt::format("The format \"{}\"", format.id);
  if (formats_.find(format.id)) broken(what, "exists already");
  for (const std::string& extension : format.extensions)
    if (const Format* other = formats_.find(extension))
      broken(what, fmt::format("has the extension \"{}\", which belongs to {}", extension, other->id));
  formats_.add(std::move(format));
}

void Registry::replace(FeatureType type) {
  declaration::check(type);
  const auto found = std::find_if(types_.begin(), types_.end(), [&](const auto& each) { return each->id == type.id; });
  if (found == types_.end() || (*found)->command != type.command)
    broken(fmt::format("The feature type \"{}\"", type.id), "does not exist under this command");
  *found = std::make_shared<const FeatureType>(std::move(type));
}

void Registry::merge(const Registry& other) {
  Registry all = *this;
  for (const auto& type : other.types_) all.add(*type);
  for (const auto& form : other.literals_) all.add(form);
  for (const auto& format : other.formats_.formats()) all.add(format);
  *this = std::move(all);
}

std::shared_ptr<const FeatureType> Registry::find(std::string_view commandOrId) const {
  for (const auto& type : types_)
    if (type->id == commandOrId || type->command == commandOrId) return type;
  return nullptr;
}

std::shared_ptr<const FeatureType> Registry::at(std::string_view commandOrId) const {
  if (auto type = find(commandOrId)) return type;
  std::vector<std::string> known;
  for (const auto& type : types_) known.insert(known.end(), {type->command, type->id});
  const std::string near = nearestName(commandOrId, known);
  throw Error(ErrorCode::NotFound, fmt::format("There is no feature \"{}\".", commandOrId),
              near.empty() ? "\"blossom features\" lists all that there are." : fmt::format("Did you mean {}?", near));
}

std::shared_ptr<const FeatureType> Registry::opening(ShapeKind kind) const {
  for (const auto& type : types_)
    if (kind != ShapeKind::None && type->opens == kind) return type;
  return nullptr;
}

Shape Registry::literal(std::string_view text) const {
  const auto colon = text.find(':');
  const std::string_view name = text.substr(0, colon);
  for (const auto& form : literals_)
    if (form.name == name) return form.parse(colon == std::string_view::npos ? std::string_view() : text.substr(colon + 1));
  return {};
}

}  // namespace blossom
