#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/engine/engine.h"

namespace csgsim::reference {

/// A segment's pixels, held and worked on one bit at a time, straight from the meanings in hw/isa/opcodes.h: the judge
/// of the other engines. Memory and enable begin as 0. Slow: meant for small arrays.
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

  [[nodiscard]] bool enabled(std::uint32_t x, std::uint32_t y) const { return enable_[pixel_at(x, y)] != 0; }
  [[nodiscard]] std::uint32_t read(isa::Field field, std::uint32_t x, std::uint32_t y) const;
  void write(isa::Field field, std::uint32_t x, std::uint32_t y, std::uint32_t value);
  void write_enable(std::uint32_t x, std::uint32_t y, bool value) { enable_[pixel_at(x, y)] = value ? 1 : 0; }

  [[nodiscard]] isa::Region region() const override { return region_; }
  void read_field(isa::Field field, std::span<std::uint32_t> values) const override;
  void read_enable(std::span<std::uint64_t> words) const override;

 private:
  [[nodiscard]] std::size_t pixel_at(std::uint32_t x, std::uint32_t y) const {
    return static_cast<std::size_t>(y) * region_.width + x;
  }
  [[nodiscard]] std::int64_t get(std::size_t pixel, isa::Field field) const;
  void put(std::size_t pixel, isa::Field field, std::uint64_t value);
  void put_linear(std::size_t pixel, isa::Field field, std::int64_t value);
  std::int64_t f_at(std::uint32_t x, std::uint32_t y, const isa::Instruction& instruction);
  void execute_at(std::uint32_t x, std::uint32_t y, const isa::Instruction& instruction);

  isa::Region region_;
  std::uint32_t memory_bits_;
  using Bit = std::uint8_t;  ///< 0 or 1
  std::vector<Bit> memory_;  ///< bit b of pixel p at p * memory_bits_ + b
  std::vector<Bit> enable_;
  isa::Linear squares_;  ///< that the next instruction's sum has besides
  std::uint64_t overflows_ = 0;
};

}  // namespace csgsim::reference
