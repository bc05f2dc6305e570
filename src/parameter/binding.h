#pragma once
#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

#include "core/vector.h"
#include "parameter/parameter.h"

namespace blossom {

/// Value of a File parameter. `path` can be opened while the feature is evaluated, also when the content is stored in the
/// document.
struct FileValue {
  std::filesystem::path path;
  std::string asset;  ///< content hash of the copy stored in the document; empty when there is none
  friend bool operator==(const FileValue&, const FileValue&) = default;
};

/// Value of a SubShape parameter: a face, edge or vertex of an input.
struct SubShapeValue {
  std::string input;  ///< name of the InputSpec
  int index = -1;     ///< see geometry/occt/sub_shape.h; -1: none
  friend bool operator==(const SubShapeValue&, const SubShapeValue&) = default;
};

template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};

/// Conversion between members of a parameter struct and canonical values. An enum corresponds to the index of its name in
/// `choices`, a list to a vector; a record is bound to a member of type Value.
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
  } else if constexpr (std::is_same_v<T, SubShapeValue>) {
    out.input = value.value("input", std::string());
    out.index = value.value("index", -1);
  } else if constexpr (std::is_same_v<T, Value>) {
    out = value;
  } else if constexpr (IsVector<T>::value) {
    out.clear();
    for (const Value& item : value) fromValue(spec.fields.at(0), item, out.emplace_back());
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
  } else if constexpr (std::is_same_v<T, SubShapeValue>) {
    return member.index < 0 ? Value()
                            : Value{{"input", member.input}, {"kind", spec.choices.at(0)}, {"index", member.index}};
  } else if constexpr (IsVector<T>::value) {
    Value items = Value::array();
    for (const auto& item : member) items.push_back(toValue(spec.fields.at(0), item));
    return items;
  } else {
    return member;
  }
}

}  // namespace blossom
