// 64-bit FNV-1a hash.
// Used by hw/machines and sim.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace csgsim {

/// A 64-bit hash of bytes (FNV-1a) that distinguishes contents; not secure against forgery.
class Hash {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) add_byte(static_cast<unsigned char>(byte));
  }

  /// Hashes each word with its low byte first, so the result does not depend on the byte order of the computer.
  void add(std::span<const std::uint32_t> words) {
    for (const std::uint32_t word : words) add_word(word);
  }

  [[nodiscard]] std::uint64_t value() const { return state_; }

  /// The hash as sixteen hexadecimal digits.
  [[nodiscard]] std::string text() const { return fmt::format("{:016x}", state_); }

 private:
  static constexpr std::uint64_t prime = 0x100000001b3ULL;

  void add_byte(unsigned char byte) { state_ = (state_ ^ byte) * prime; }

  /// Same result as four calls of add_byte(), but one multiplication handles all zero bytes at the high end.
  void add_word(std::uint32_t word) {
    constexpr std::uint64_t powers[] = {prime * prime * prime, prime * prime, prime, 1};
    unsigned bytes = 0;
    for (add_byte(word & 0xffU); word >>= 8U; ++bytes) add_byte(word & 0xffU);
    state_ *= powers[bytes];
  }

  std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

}  // namespace csgsim
