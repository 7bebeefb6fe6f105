// A pixel-by-pixel interpreter of instructions, the reference for the other engines.
// Used by the reference engine, sim/story and tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/engine/engine.h"

namespace csgsim::reference {

/// A mask of the low `width` bits.
constexpr std::uint64_t low_bits(unsigned width) { return (std::uint64_t{1} << width) - 1; }

/// The pixels of a segment, processed one after the other, directly by the definitions in hw/isa/opcodes.h. Tests
/// compare the other engines with it. Memory and enable bits start as 0.
class ReferenceArray final : public engine::PixelState {
 public:
  ReferenceArray(isa::Region region, std::uint32_t memory_bits);
  explicit ReferenceArray(isa::ArrayShape shape)
      : ReferenceArray(isa::Region{0, 0, shape.width, shape.height}, shape.memory_bits) {}

  /// Executes a valid instruction at every pixel; the coefficients of `squares` apply to the next instruction.
  void execute(const isa::Instruction& instruction);

  /// Number of pixels whose E is 1.
  [[nodiscard]] std::uint64_t enabled_pixels() const;

  /// Number of enabled pixels, over all instructions executed, at which the sum exceeded its width.
  [[nodiscard]] std::uint64_t overflows() const { return overflows_; }

  [[nodiscard]] bool is_enabled(std::uint32_t x, std::uint32_t y) const {
    return (enable_[enable_word(x, y)] >> x % bits_per_word & 1U) != 0;
  }
  [[nodiscard]] std::uint32_t read(isa::Field field, std::uint32_t x, std::uint32_t y) const;
  void write(isa::Field field, std::uint32_t x, std::uint32_t y, std::uint32_t value);
  void write_enable(std::uint32_t x, std::uint32_t y, bool value);

  [[nodiscard]] isa::Region region() const override { return region_; }
  void read_field(isa::Field field, std::span<std::uint32_t> values) const override;
  void read_enable(std::span<std::uint64_t> words) const override;

 private:
  static constexpr std::uint32_t bits_per_word = 64;

  [[nodiscard]] std::size_t enable_word(std::uint32_t x, std::uint32_t y) const {
    return y * words_per_row_ + x / bits_per_word;
  }
  [[nodiscard]] std::size_t pixel_at(std::uint32_t x, std::uint32_t y) const {
    return static_cast<std::size_t>(y) * region_.width + x;
  }
  [[nodiscard]] std::int64_t get(std::size_t pixel, isa::Field field) const;
  void put(std::size_t pixel, isa::Field field, std::uint64_t value);
  /// Calls `act` at each pixel whose E is 1 and stores the result in E. The second form also passes the instruction's
  /// F.
  template <class Act>
  void at_enabled(const Act& act);
  template <class Act>
  void at_enabled_with_f(const isa::Instruction& instruction, const Act& act);
  /// Sets E of every pixel to a function of the pixel and the old E.
  template <class NewEnable>
  void set_enable(const NewEnable& new_enable);
  void apply(const isa::Instruction& instruction);

  isa::Region region_;
  std::size_t words_per_pixel_;        ///< includes one spare word
  std::vector<std::uint64_t> memory_;  ///< bit b of a pixel is bit b % 64 of its word b / 64
  std::size_t words_per_row_;
  std::vector<std::uint64_t> enable_;  ///< pixel x of a row is bit x % 64 of its word x / 64
  isa::Linear squares_;                ///< coefficients added to the next instruction's sum
  std::uint64_t overflows_ = 0;
};

inline std::int64_t ReferenceArray::get(std::size_t pixel, isa::Field field) const {
  const std::uint64_t* const words = &memory_[pixel * words_per_pixel_ + field.base / bits_per_word];
  const unsigned begin = field.base % bits_per_word;
  std::uint64_t value = words[0] >> begin;
  if (begin + field.width > bits_per_word) value |= words[1] << (bits_per_word - begin);
  return static_cast<std::int64_t>(value & low_bits(field.width));
}

}  // namespace csgsim::reference
