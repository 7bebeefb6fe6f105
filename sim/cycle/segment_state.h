// The pixel state that observers of a clocked machine read.
// Used by in_order.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>

#include "hw/systemc/run_listener.h"
#include "sim/engine/engine.h"

namespace csgsim::cycle {

/// The pixels of a machine in a segment's region, as observers see them. `pixels` is null if no observer announced that
/// it reads them; reading them throws std::logic_error then.
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
    throw std::logic_error("an observer reads the state after an instruction for which its reads_after returned false");
  }

  const systemc::PixelView* pixels_;
  isa::Region region_;
};

}  // namespace csgsim::cycle
