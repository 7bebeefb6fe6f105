#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/engine/engine.h"

namespace csgsim::testing {

/// Pixels of a region; tests set their memory (at most 32 bits) and enable by hand.
class FakePixels final : public engine::PixelState {
 public:
  explicit FakePixels(isa::Region region)
      : region_(region),
        memory_(static_cast<std::size_t>(region.width) * region.height),
        enable_(memory_.size(), false) {}

  void write(isa::Field field, std::uint32_t x, std::uint32_t y, std::uint32_t value) {
    std::uint32_t& memory = memory_[at(x, y)];
    memory = (memory & ~(ones(field) << field.base)) | value << field.base;
  }
  void enable(std::uint32_t x, std::uint32_t y) { enable_[at(x, y)] = true; }
  /// Enables exactly the pixels at these columns and rows.
  void enable_only(const std::vector<std::array<std::uint32_t, 2>>& pixels) {
    enable_.assign(enable_.size(), false);
    for (const auto& [x, y] : pixels) enable(x, y);
  }

  [[nodiscard]] isa::Region region() const override { return region_; }
  void read_field(isa::Field field, std::span<std::uint32_t> values) const override {
    for (std::size_t i = 0; i < memory_.size(); ++i) values[i] = memory_[i] >> field.base & ones(field);
  }
  void read_enable(std::span<std::uint64_t> words) const override {
    const std::size_t words_per_row = (region_.width + 63) / 64;
    for (std::uint64_t& word : words) word = 0;
    for (std::uint32_t y = 0; y < region_.height; ++y)
      for (std::uint32_t x = 0; x < region_.width; ++x)
        if (enable_[at(x, y)]) words[y * words_per_row + x / 64] |= std::uint64_t{1} << x % 64;
  }

 private:
  [[nodiscard]] std::size_t at(std::uint32_t x, std::uint32_t y) const {
    return static_cast<std::size_t>(y) * region_.width + x;
  }
  static std::uint32_t ones(isa::Field field) {
    return static_cast<std::uint32_t>((std::uint64_t{1} << field.width) - 1);
  }

  isa::Region region_;
  std::vector<std::uint32_t> memory_;
  std::vector<bool> enable_;
};

}  // namespace csgsim::testing
