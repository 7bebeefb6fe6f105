#include "host/solids/unzip.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>

#include "hw/base/error.h"
#include "hw/base/text.h"

namespace csgsim::solids {

namespace {

// Signatures and fixed lengths of the records in APPNOTE.TXT, the ZIP file format specification.
constexpr std::string_view local_header = "PK\x03\x04";
constexpr std::size_t local_bytes = 30;
constexpr std::string_view directory_header = "PK\x01\x02";
constexpr std::size_t directory_bytes = 46;
constexpr std::string_view end_record = "PK\x05\x06";
constexpr std::size_t end_bytes = 22;
constexpr std::string_view end_locator_64 = "PK\x06\x07";
constexpr std::size_t locator_bytes = 20;
constexpr std::string_view end_record_64 = "PK\x06\x06";

/// Marks a number that is stored with 64 bits in the extra field.
constexpr std::uint64_t in_extra_field = 0xffffffffU;
constexpr std::uint64_t extra_field_64 = 1;

struct Entry {
  std::string_view name;
  std::uint64_t flags = 0;
  std::uint64_t method = 0;
  std::uint64_t crc = 0;
  std::uint64_t packed_size = 0;
  std::uint64_t size = 0;
  std::uint64_t at = 0;
};

class Archive {
 public:
  Archive(std::string_view bytes, std::string_view name) : bytes_(bytes), name_(name) {}

  [[nodiscard]] std::string part(const std::string& wanted) const {
    for (std::uint64_t at = directory_at(); starts(at, directory_header);) {
      const Entry entry = entry_at(at);
      if (wanted.empty() || entry.name == wanted) return decompress_entry(entry);
    }
    fail(fmt::format("the archive has no {}", wanted.empty() ? "part" : wanted));
  }

 private:
  [[noreturn]] void fail(std::string_view message) const {
    throw InputError(fmt::format("{}: {}; export it again", name_, message));
  }

  [[noreturn]] void fail_damaged() const { fail("the zip archive is damaged"); }

  [[nodiscard]] std::string_view piece(std::uint64_t at, std::uint64_t size) const {
    if (at > bytes_.size() || size > bytes_.size() - at) fail_damaged();
    return bytes_.substr(static_cast<std::size_t>(at), static_cast<std::size_t>(size));
  }

  [[nodiscard]] bool starts(std::uint64_t at, std::string_view header) const {
    return at <= bytes_.size() && bytes_.substr(static_cast<std::size_t>(at)).starts_with(header);
  }

  /// Reads a little-endian number.
  [[nodiscard]] std::uint64_t number(std::uint64_t at, std::size_t size) const {
    const std::string_view digits = piece(at, size);
    std::uint64_t value = 0;
    for (std::size_t i = size; i-- > 0;) value = value << 8U | static_cast<unsigned char>(digits[i]);
    return value;
  }

  [[nodiscard]] std::uint64_t directory_at() const {
    const std::size_t end = bytes_.rfind(end_record);
    if (end == std::string_view::npos || bytes_.size() - end < end_bytes) fail_damaged();
    const std::uint64_t at = number(end + 16, 4);
    if (at != in_extra_field) return at;
    if (end < locator_bytes || !starts(end - locator_bytes, end_locator_64)) fail_damaged();
    const std::uint64_t end_64 = number(end - locator_bytes + 8, 8);
    if (!starts(end_64, end_record_64)) fail_damaged();
    return number(end_64 + 48, 8);
  }

  /// The directory entry at `at`. Advances `at` to the next entry.
  Entry entry_at(std::uint64_t& at) const {
    const std::uint64_t name_size = number(at + 28, 2);
    const std::uint64_t extra_size = number(at + 30, 2);
    Entry entry{piece(at + directory_bytes, name_size),
                number(at + 8, 2),
                number(at + 10, 2),
                number(at + 16, 4),
                number(at + 20, 4),
                number(at + 24, 4),
                number(at + 42, 4)};
    read_extra(entry, at + directory_bytes + name_size, extra_size);
    at += directory_bytes + name_size + extra_size + number(at + 32, 2);
    return entry;
  }

  /// Reads, as 64-bit numbers, the sizes and positions that did not fit 32 bits; they are stored in this order.
  void read_extra(Entry& entry, std::uint64_t at, std::uint64_t size) const {
    const std::uint64_t end = at + piece(at, size).size();
    while (at + 4 <= end) {
      const std::uint64_t kind = number(at, 2);
      const std::uint64_t length = number(at + 2, 2);
      std::uint64_t field = at + 4;
      at = field + length;
      if (kind != extra_field_64) continue;
      for (std::uint64_t* value : {&entry.size, &entry.packed_size, &entry.at}) {
        if (*value != in_extra_field) continue;
        *value = number(field, 8);
        field += 8;
      }
    }
  }

  [[nodiscard]] std::string decompress_entry(const Entry& entry) const {
    constexpr std::uint64_t encrypted = 1;
    if ((entry.flags & encrypted) != 0) fail("the zip archive is encrypted");
    if (!starts(entry.at, local_header)) fail_damaged();
    const std::uint64_t begin = entry.at + local_bytes + number(entry.at + 26, 2) + number(entry.at + 28, 2);
    const std::string_view packed = piece(begin, entry.packed_size);
    if (entry.size > max_unzipped_bytes) fail_too_long();
    std::string part;
    if (entry.method == 0) {
      part = packed;
    } else if (entry.method == Z_DEFLATED) {
      part = inflate_data(packed);
    } else {
      fail("the zip archive uses an unknown compression method");
    }
    const std::uint64_t crc = ::crc32_z(0, reinterpret_cast<const Bytef*>(part.data()), part.size());
    if (part.size() != entry.size || crc != entry.crc) fail("a part of the zip archive is damaged");
    return part;
  }

  [[noreturn]] void fail_too_long() const {
    throw InputError(fmt::format("{}: larger than {} after unzipping; make the mesh coarser", name_,
                                 binary_size(max_unzipped_bytes)));
  }

  /// Decompresses a member, without relying on the size stated in the archive.
  [[nodiscard]] std::string inflate_data(std::string_view packed) const {
    z_stream stream{};
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw InputError("not enough memory to unzip a file");
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));  // NOLINT: zlib does not write there
    stream.avail_in = static_cast<uInt>(packed.size());
    std::string part;
    std::string chunk(std::size_t{1} << 16U, '\0');
    int result = Z_OK;
    while (result == Z_OK && part.size() <= max_unzipped_bytes) {
      stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
      stream.avail_out = static_cast<uInt>(chunk.size());
      result = ::inflate(&stream, Z_NO_FLUSH);
      part.append(chunk, 0, chunk.size() - stream.avail_out);
    }
    inflateEnd(&stream);
    if (part.size() > max_unzipped_bytes) fail_too_long();
    if (result != Z_STREAM_END) fail("a part of the zip archive is damaged");
    return part;
  }

  std::string_view bytes_;
  std::string_view name_;
};

}  // namespace

bool is_zip(std::string_view bytes) { return bytes.starts_with(local_header); }

std::string unzip(std::string_view archive, std::string_view archive_name, const std::string& member_name) {
  return Archive(archive, archive_name).part(member_name);
}

}  // namespace csgsim::solids
