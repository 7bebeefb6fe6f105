#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/engine/engine.h"

namespace csgsim::reference {

/// The low bits of a word.
constexpr std::uint64_t low_bits(unsigned width) { return (std::uint64_t{1} << width) - 1; }

/// A segment's pixels, worked on one after the other, straight from the meanings in hw/isa/opcodes.h: the judge of the
/// other engines. Memory and enable begin as 0.
class ReferenceArray final : public engine::PixelState {
 public:
  ReferenceArray(isa::Region region, std::uint32_t memory_bits);
  explicit ReferenceArray(isa::ArrayShape shape)
      : ReferenceArray(isa::Region{0, 0, shape.width, shape.height}, shape.memory_bits) {}

  /// Carries out one valid instruction at every pixel; what squares say is for the one after them.
  void execute(const isa::Instruction& instruction);

  /// Pixels whose E is 1.
  [[nodiscard]] std::uint64_t enabled_pixels() const;

  /// Over all instructions so far: enabled pixels at which the sum did not fit the width, but had to.
  [[nodiscard]] std::uint64_t overflows() const { return overflows_; }

  [[nodiscard]] bool enabled(std::uint32_t x, std::uint32_t y) const {
    return (enable_[enable_word(x, y)] >> x % bits_a_word & 1U) != 0;
  }
  [[nodiscard]] std::uint32_t read(isa::Field field, std::uint32_t x, std::uint32_t y) const;
  void write(isa::Field field, std::uint32_t x, std::uint32_t y, std::uint32_t value);
  void write_enable(std::uint32_t x, std::uint32_t y, bool value);

  [[nodiscard]] isa::Region region() const override { return region_; }
  void read_field(isa::Field field, std::span<std::uint32_t> values) const override;
  void read_enable(std::span<std::uint64_t> words) const override;

 private:
  static constexpr std::uint32_t bits_a_word = 64;

  [[nodiscard]] std::size_t enable_word(std::uint32_t x, std::uint32_t y) const {
    return y * words_a_row_ + x / bits_a_word;
  }
  [[nodiscard]] std::size_t pixel_at(std::uint32_t x, std::uint32_t y) const {
    return static_cast<std::size_t>(y) * region_.width + x;
  }
  [[nodiscard]] std::int64_t get(std::size_t pixel, isa::Field field) const;
  void put(std::size_t pixel, isa::Field field, std::uint64_t value);
  /// At those whose E is 1, which becomes what `act` returns; with_f: of the sum that the instruction has there too.
  template <class Act>
  void at_enabled(const Act& act);
  template <class Act>
  void at_enabled_with_f(const isa::Instruction& instruction, const Act& act);
  /// Sets E of every pixel from the pixel and what E was.
  template <class Becomes>
  void set_enable(const Becomes& becomes);
  void carry_out(const isa::Instruction& instruction);

  isa::Region region_;
  std::size_t words_a_pixel_;          ///< one more than its bits fill
  std::vector<std::uint64_t> memory_;  ///< bit b of a pixel is bit b % 64 of its word b / 64
  std::size_t words_a_row_;
  std::vector<std::uint64_t> enable_;  ///< pixel x of a row is bit x % 64 of its word x / 64
  isa::Linear squares_;                ///< that the next instruction's sum has besides
  std::uint64_t overflows_ = 0;
};

inline std::int64_t ReferenceArray::get(std::size_t pixel, isa::Field field) const {
  const std::uint64_t* const words = &memory_[pixel * words_a_pixel_ + field.base / bits_a_word];
  const unsigned begin = field.base % bits_a_word;
  std::uint64_t value = words[0] >> begin;
  if (begin + field.width > bits_a_word) value |= words[1] << (bits_a_word - begin);
  return static_cast<std::int64_t>(value & low_bits(field.width));
}

}  // namespace csgsim::reference
