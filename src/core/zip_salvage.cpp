#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <optional>

#include "core/error.h"
#include "core/zip_archive.h"

/// Entries of a zip by the headers in front of them (PKWARE, .ZIP File Format Specification, section 4.3.7).
namespace blossom {
namespace {

constexpr std::string_view signature("PK\3\4", 4);
constexpr std::size_t headerSize = 30;

std::uint64_t littleEndian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

struct LocalHeader {
  bool sizesFollow = false;  ///< sizes stand behind the data (bit 3), as programs write that cannot seek
  bool encrypted = false;
  unsigned method = 0;
  std::uint32_t checksum = 0;
  std::uint64_t packedSize = 0;
  std::string_view name;
  std::size_t data = 0;  ///< place of the content
};

std::optional<LocalHeader> headerAt(std::string_view bytes, std::size_t at) {
  if (bytes.size() - at < headerSize) return std::nullopt;
  LocalHeader header;
  const auto flags = littleEndian(bytes, at + 6, 2);
  header.encrypted = (flags & 1) != 0;
  header.sizesFollow = (flags & 8) != 0;
  header.method = static_cast<unsigned>(littleEndian(bytes, at + 8, 2));
  header.checksum = static_cast<std::uint32_t>(littleEndian(bytes, at + 14, 4));
  header.packedSize = littleEndian(bytes, at + 18, 4);
  const auto nameSize = littleEndian(bytes, at + 26, 2);
  header.data = at + headerSize + nameSize + littleEndian(bytes, at + 28, 2);
  if (header.data > bytes.size()) return std::nullopt;
  header.name = bytes.substr(at + headerSize, nameSize);
  return header;
}

class Inflater {
 public:
  Inflater() {
    if (inflateInit2(&stream_, -MAX_WBITS) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// Appends what can be unpacked until `limit`. @returns bytes of input that were used when the end of the stream was found
  std::optional<std::size_t> run(std::string_view packed, std::string& out, std::uint64_t limit) {
    std::array<char, 1 << 16> chunk;
    const std::size_t whole = packed.size();
    int status = Z_OK;
    while (status == Z_OK && out.size() <= limit) {
      if (stream_.avail_in == 0) {  // zlib counts in 32 bits
        const std::size_t part = std::min<std::size_t>(packed.size(), 1u << 30);
        stream_.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(packed.data()));
        stream_.avail_in = static_cast<uInt>(part);
        packed.remove_prefix(part);
      }
      stream_.next_out = reinterpret_cast<Bytef*>(chunk.data());
      stream_.avail_out = static_cast<uInt>(chunk.size());
      status = inflate(&stream_, Z_NO_FLUSH);
      out.append(chunk.data(), chunk.size() - stream_.avail_out);
    }
    if (status != Z_STREAM_END) return std::nullopt;
    return whole - packed.size() - stream_.avail_in;
  }

 private:
  z_stream stream_{};
};

struct Unpacked {
  std::string content;
  bool whole = false;
  std::size_t end = 0;  ///< where to go on
};

Unpacked unpack(std::string_view bytes, const LocalHeader& header, std::uint64_t limit) {
  Unpacked result;
  const std::string_view rest = bytes.substr(header.data);
  const std::string_view packed = header.sizesFollow ? rest : rest.substr(0, header.packedSize);
  result.end = header.data + (header.sizesFollow ? 0 : packed.size());
  bool complete = false;
  if (header.method == 8) {
    const auto used = Inflater().run(packed, result.content, limit);
    complete = used.has_value();
    if (used) result.end = header.data + *used;
  } else if (header.method == 0 && !header.sizesFollow) {
    result.content = packed.substr(0, limit + 1);
    complete = packed.size() == header.packedSize;
  }
  if (!complete) return result;
  if (header.sizesFollow) {
    result.whole = true;  // the checksum stands behind the data; assets carry their own
    return result;
  }
  auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(result.content.data()), result.content.size());
  result.whole = static_cast<std::uint32_t>(sum) == header.checksum;
  return result;
}

}  // namespace

ZipContent salvageZip(const std::string& bytes, const std::function<bool(std::string_view)>& wanted,
                      const ZipLimits& limits) {
  ZipContent result;
  const std::string_view all = bytes;
  std::uint64_t total = 0;
  for (std::size_t at = all.find(signature); at != std::string_view::npos;) {
    std::size_t next = at + signature.size();
    const auto header = headerAt(all, at);
    if (header && !header->encrypted && wanted(header->name)) {
      Unpacked entry = unpack(all, *header, limits.entry);
      const std::string name(header->name);
      total += entry.content.size();
      if (entry.content.size() > limits.entry || total > limits.total)
        throw Error(ErrorCode::LimitExceeded, fmt::format("{} unpacks to more than {} MB.", name, limits.entry >> 20));
      if (!entry.whole) result.damaged.push_back(fmt::format("{} is damaged.", name));
      if (!entry.content.empty()) result.entries.emplace(name, std::move(entry.content));
      next = std::max(next, entry.end);
    }
    at = all.find(signature, next);
  }
  return result;
}

}  // namespace blossom
