#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The header of a PLY file: its elements, their properties and the encoding.
namespace blossom {

enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;
  std::optional<PlyType> countType;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { Text, Little, Big };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Text;
  std::vector<PlyElement> elements;
  std::size_t lines = 0;
  std::size_t bytes = 0;
};

/// Size in bytes of one value in a binary file.
std::size_t byteSize(PlyType);

/// Checks counts against the size of the content. @throws Error FormatDamaged with the line.
PlyHeader readPlyHeader(std::string_view content);

}  // namespace blossom
