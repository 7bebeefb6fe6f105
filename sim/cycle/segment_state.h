#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>

#include "hw/systemc/run_listener.h"
#include "sim/engine/engine.h"

namespace csgsim::cycle {

/// What observers see of a machine's pixels: those of a segment's region. Of pixels that nobody has said to look at,
/// null, reading throws std::logic_error.
class SegmentState final : public engine::PixelState {
 public:
  SegmentState(const systemc::PixelView* pixels, isa::Region region) : pixels_(pixels), region_(region) {}

  [[nodiscard]] isa::Region region() const override { return region_; }
  void read_field(isa::Field field, std::span<std::uint32_t> values) const override {
    pixels().read_field(field, region_.width, region_.height, values);
  }
  void read_enable(std::span<std::uint64_t> words) const override {
    pixels().read_enable(region_.width, region_.height, words);
  }

 private:
  [[nodiscard]] const systemc::PixelView& pixels() const {
    if (pixels_ != nullptr) return *pixels_;
    throw std::logic_error("an observer reads the state after an instruction without having said so");
  }

  const systemc::PixelView* pixels_;
  isa::Region region_;
};

}  // namespace csgsim::cycle
