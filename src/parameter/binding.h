#pragma once
#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

#include "core/vector.h"
#include "parameter/parameter.h"

namespace blossom {

/// A file given as parameter. `path` can be opened while the feature is evaluated, also when the content comes from the
/// document.
struct FileValue {
  std::filesystem::path path;
  std::string asset;  ///< content hash of the copy kept in the document; empty outside of one
  friend bool operator==(const FileValue&, const FileValue&) = default;
};

/// Between the members of a parameter struct and canonical values. Enums go by the index of their name in `choices`.
template <class T>
void fromValue(const ParameterSpec& spec, const Value& value, T& out) {
  if constexpr (std::is_enum_v<T>) {
    for (std::size_t i = 0; i < spec.choices.size(); ++i)
      if (spec.choices[i] == value.get_ref<const std::string&>()) out = static_cast<T>(i);
  } else if constexpr (std::is_same_v<T, Vec3>) {
    out = Vec3(value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>());
  } else if constexpr (std::is_same_v<T, FileValue>) {
    out.path = value.value("path", std::string());
    out.asset = value.value("asset", std::string());
  } else {
    out = value.get<T>();
  }
}

template <class T>
Value toValue(const ParameterSpec& spec, const T& member) {
  if constexpr (std::is_enum_v<T>) {
    return spec.choices.at(static_cast<std::size_t>(member));
  } else if constexpr (std::is_same_v<T, Vec3>) {
    return Value::array({member.x(), member.y(), member.z()});
  } else if constexpr (std::is_same_v<T, FileValue>) {
    return member.path.empty() && member.asset.empty() ? Value()
                                                       : Value{{"path", member.path.string()}, {"asset", member.asset}};
  } else {
    return member;
  }
}

}  // namespace blossom
