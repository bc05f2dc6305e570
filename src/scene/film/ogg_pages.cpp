// Pages: RFC 3533. The identification header of Theora: Theora Specification, section 6.2.
#include "scene/film/ogg_pages.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <vector>

#include "core/file.h"

namespace blossom {

namespace {

using Bytes = std::vector<std::uint8_t>;

// Places in the header of a page.
constexpr std::size_t flagsAt = 5, serialAt = 14, numberAt = 18, checksumAt = 22, segmentsAt = 26, headerSize = 27;
constexpr std::uint8_t lastPage = 4;
// Places in the identification header of Theora.
constexpr std::size_t blocksAt = 10, shownSizeAt = 14, shownPlaceAt = 20, identificationSize = 42;
constexpr std::size_t headerPackets = 3;

std::array<std::uint32_t, 256> checksumTable() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    std::uint32_t rest = i << 24;
    for (int bit = 0; bit < 8; ++bit) rest = (rest << 1) ^ ((rest & 0x80000000U) != 0 ? 0x04c11db7U : 0U);
    table[i] = rest;
  }
  return table;
}

std::uint32_t littleEndian(const Bytes& page, std::size_t at) {
  return page[at] | page[at + 1] << 8 | page[at + 2] << 16 | static_cast<std::uint32_t>(page[at + 3]) << 24;
}

void putLittleEndian(Bytes& page, std::size_t at, std::uint32_t value) {
  for (int k = 0; k < 4; ++k) page[at + static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(value >> 8 * k);
}

/// Of a page whose own place for it holds zeros.
std::uint32_t checksum(const Bytes& page) {
  static const std::array<std::uint32_t, 256> table = checksumTable();
  std::uint32_t sum = 0;
  for (const std::uint8_t byte : page) sum = (sum << 8) ^ table[(sum >> 24) ^ byte];
  return sum;
}

class TheoraPages {
 public:
  TheoraPages(const std::filesystem::path& path, const TheoraFilm& film)
      : path_(path), film_(film), file_(path, std::ios::binary | std::ios::in | std::ios::out) {}

  void finish() {
    while (readPage()) {
      check(std::exchange(number_, number_ + 1));
      if (number_ == 1) cropPictures();
      putLittleEndian(page_, serialAt, 1);
      putLittleEndian(page_, checksumAt, 0);
      putLittleEndian(page_, checksumAt, checksum(page_));
      writePage();
    }
    if (!ended_ || packets_ != headerPackets + film_.pictures) incomplete();
    file_.close();
    if (!file_) incomplete();
  }

 private:
  [[noreturn]] void incomplete() const { cannotWrite(path_, "the film came out incomplete"); }

  void readBytes(std::size_t count) {
    const std::size_t before = page_.size();
    page_.resize(before + count);
    file_.read(reinterpret_cast<char*>(page_.data() + before), static_cast<std::streamsize>(count));
    if (!file_) incomplete();
  }

  bool readPage() {
    if (!file_) incomplete();
    if (file_.peek() == std::ifstream::traits_type::eof()) {
      file_.clear();
      return false;
    }
    page_.clear();
    readBytes(headerSize);
    readBytes(page_[segmentsAt]);
    std::size_t content = 0;
    for (std::size_t k = headerSize; k < headerSize + page_[segmentsAt]; ++k) {
      content += page_[k];
      packets_ += page_[k] < 255 ? 1 : 0;  // where a packet ends
    }
    readBytes(content);
    return true;
  }

  void check(std::uint32_t number) {
    const std::uint32_t told = littleEndian(page_, checksumAt);
    putLittleEndian(page_, checksumAt, 0);
    const bool page = std::equal(page_.begin(), page_.begin() + 4, "OggS");
    if (!page || ended_ || checksum(page_) != told || littleEndian(page_, numberAt) != number) incomplete();
    ended_ = (page_[flagsAt] & lastPage) != 0;
  }

  /// The first page holds the identification header alone.
  void cropPictures() {
    const std::size_t header = headerSize + page_[segmentsAt];
    if (page_.size() < header + identificationSize) incomplete();
    std::uint8_t* const it = page_.data() + header;
    const auto put = [&](std::size_t at, int bytes, int value) {
      for (int k = 0; k < bytes; ++k)
        it[at + static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(value >> 8 * (bytes - 1 - k));
    };
    const int storedHeight = 16 * (it[blocksAt + 2] << 8 | it[blocksAt + 3]);
    put(shownSizeAt, 3, film_.width);
    put(shownSizeAt + 3, 3, film_.height);
    put(shownPlaceAt, 1, 0);
    put(shownPlaceAt + 1, 1, storedHeight - film_.height);  // counted from the lower edge
  }

  void writePage() {
    const auto size = static_cast<std::streamoff>(page_.size());
    file_.seekp(file_.tellg() - size);
    file_.write(reinterpret_cast<const char*>(page_.data()), static_cast<std::streamsize>(size));
    file_.seekg(file_.tellp());
  }

  const std::filesystem::path& path_;
  const TheoraFilm& film_;
  std::fstream file_;
  Bytes page_;
  std::uint32_t number_ = 0;
  std::size_t packets_ = 0;
  bool ended_ = false;
};

}  // namespace

void finishTheoraFile(const std::filesystem::path& path, const TheoraFilm& film) { TheoraPages(path, film).finish(); }

}  // namespace blossom
