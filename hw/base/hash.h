#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace csgsim {

/// A 64-bit hash of bytes, to tell contents apart (FNV-1a); no defence against forgery.
class Hash {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) add_byte(static_cast<unsigned char>(byte));
  }

  /// Low bytes first, on every machine.
  void add(std::span<const std::uint32_t> words) {
    for (const std::uint32_t word : words) {
      for (unsigned shift = 0; shift < 32; shift += 8) add_byte(static_cast<unsigned char>(word >> shift & 0xffU));
    }
  }

  [[nodiscard]] std::uint64_t value() const { return state_; }

  /// Sixteen hexadecimal digits.
  [[nodiscard]] std::string text() const { return fmt::format("{:016x}", state_); }

 private:
  void add_byte(unsigned char byte) { state_ = (state_ ^ byte) * 0x100000001b3ULL; }

  std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

}  // namespace csgsim
