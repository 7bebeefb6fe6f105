// Byte streams with varint and zigzag numbers.
// Used by hw/isa and sim/checkpoint.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

namespace csgsim::isa {

/// Bytes that end too soon or contain a number out of range.
class MalformedBytes : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Zigzag code: 0, -1, 1, -2, ... become 0, 1, 2, 3, ..., so that numbers of small magnitude need few bytes.
constexpr std::uint64_t zigzag(std::int64_t value) {
  return (static_cast<std::uint64_t>(value) << 1U) ^ static_cast<std::uint64_t>(value >> 63);
}

constexpr std::int64_t unzigzag(std::uint64_t code) {
  return static_cast<std::int64_t>(code >> 1U) ^ -static_cast<std::int64_t>(code & 1U);
}

/// Appends bytes to a vector.
class ByteWriter {
 public:
  /// Reserves address space; memory that is never written is not committed.
  void reserve(std::size_t count) { bytes_.reserve(count); }

  void byte(std::uint8_t value) { bytes_.push_back(std::byte{value}); }

  void block(std::span<const std::uint8_t> values) {
    for (const std::uint8_t value : values) byte(value);
  }

  /// LEB128: seven bits per byte, least significant first.
  void varint(std::uint64_t value) {
    for (; value >= 0x80U; value >>= 7U) byte(static_cast<std::uint8_t>(0x80U | (value & 0x7fU)));
    byte(static_cast<std::uint8_t>(value));
  }

  [[nodiscard]] std::span<const std::byte> written() const { return bytes_; }
  [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

/// Reads the output of a ByteWriter. Throws MalformedBytes.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  [[nodiscard]] std::size_t left() const { return rest_.size(); }

  std::span<const std::byte> block(std::uint64_t size) {
    if (size > rest_.size()) throw MalformedBytes("ends too soon");
    const auto taken = rest_.first(static_cast<std::size_t>(size));
    rest_ = rest_.subspan(taken.size());
    return taken;
  }

  std::uint8_t byte() { return std::to_integer<std::uint8_t>(block(1)[0]); }

  std::uint64_t varint() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
      const std::uint64_t group = byte();
      const std::uint64_t bits = group & 0x7fU;
      if (bits << shift >> shift != bits) break;
      value |= bits << shift;
      if (group == bits) return value;
    }
    throw MalformedBytes("holds a number of more than 64 bits");
  }

  /// Reads a varint. Throws MalformedBytes also if it exceeds `maximum`.
  template <class Unsigned>
  Unsigned varint_at_most(std::uint64_t maximum) {
    const std::uint64_t value = varint();
    if (value > maximum) throw MalformedBytes("holds a number out of range");
    return static_cast<Unsigned>(value);
  }

 private:
  std::span<const std::byte> rest_;
};

}  // namespace csgsim::isa
