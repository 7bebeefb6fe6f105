#include "hw/multi_processor/collector.h"

#include <algorithm>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>

#include "hw/base/quotient.h"
#include "hw/machines/kind.h"
#include "hw/multi_processor/regions.h"
#include "hw/systemc/clear_view.h"

namespace csgsim::multi_processor {

namespace {

using Memories = std::vector<std::shared_ptr<const PixelMemory>>;

/// A view of a subsegment merged from the memories of the nodes; a copy owns its pixels.
class MergedView final : public systemc::PixelView {
 public:
  MergedView(const isa::Region& region, const isa::ArrayShape& nodes, Memories memories)
      : region_(region), nodes_(nodes), memories_(std::move(memories)) {}

  void read_field(isa::Field field, std::uint32_t width, std::uint32_t height,
                  std::span<std::uint32_t> values) const override {
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        const Place place = place_of(x, y);
        values[std::size_t{y} * width + x] = static_cast<std::uint32_t>(place.memory->read(place.pixel, field));
      }
    }
  }

  void read_enable(std::uint32_t width, std::uint32_t height, std::span<std::uint64_t> words) const override {
    constexpr std::uint32_t word_bits = 64;
    const std::size_t row_words = quotient_up(width, word_bits);
    std::fill(words.begin(), words.end(), 0U);
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        const Place place = place_of(x, y);
        const std::uint64_t bit = place.memory->enabled(place.pixel) ? 1 : 0;
        words[y * row_words + x / word_bits] |= bit << x % word_bits;
      }
    }
  }

  [[nodiscard]] std::unique_ptr<const PixelView> copy() const override {
    Memories copies = memories_;
    for (std::shared_ptr<const PixelMemory>& memory : copies) memory = std::make_shared<const PixelMemory>(*memory);
    return std::make_unique<MergedView>(region_, nodes_, std::move(copies));
  }

 private:
  struct Place {
    const PixelMemory* memory = nullptr;
    std::size_t pixel = 0;
  };

  [[nodiscard]] Place place_of(std::uint32_t x, std::uint32_t y) const {
    const std::uint32_t row = (region_.y + y) % nodes_.height;
    const std::uint32_t column = (region_.x + x) % nodes_.width;
    const PixelMemory* const memory = memories_[std::size_t{row} * nodes_.width + column].get();
    const NodePixels pixels = pixels_of_node(region_, nodes_, row, column);
    if (memory->pixels() < pixels.count()) throw std::logic_error("read of pixels that were not kept");
    return {memory, std::size_t{y / nodes_.height} * pixels.columns + x / nodes_.width};
  }

  isa::Region region_;
  isa::ArrayShape nodes_;
  Memories memories_;
};

MergedView view_of(const isa::Region& region, const isa::ArrayShape& nodes, std::span<const NodeState> states) {
  Memories memories;
  memories.reserve(states.size());
  for (const NodeState& state : states) memories.emplace_back(std::shared_ptr<void>(), &state.pixels);
  return {region, nodes, std::move(memories)};
}

}  // namespace

Collector::Collector(sc_core::sc_module_name name, const machines::Machine& machine, const systemc::SegmentNames& names)
    : sc_core::sc_module(name),
      nodes_(machine.array),
      branches_(machine.kind->depends_on_pixels(machine)),
      names_(names),
      reported_(std::size_t{nodes_.width} * nodes_.height),
      ends_(reported_.size()) {}

systemc::Keep Collector::required_after(const isa::Region& region, std::uint32_t index) {
  return retirement->required_after(names_.segment_of(region), index);
}

void Collector::after_instruction(std::uint32_t node, NodeState state) {
  const std::uint32_t index = reported_[node]++;
  if (index == steps_.size()) steps_.emplace_back(reported_.size());
  steps_[index][node] = std::move(state);
}

void Collector::after_subsegment(std::uint32_t node, const isa::Region& region, NodeState end) {
  ends_[node] = std::move(end);
  if (++ended_ < reported_.size()) return;
  report_subsegment(region);
  steps_.clear();
  std::fill(reported_.begin(), reported_.end(), 0U);
  ended_ = 0;
}

void Collector::report_subsegment(const isa::Region& region) {
  const std::uint32_t segment = names_.segment_of(region);
  for (std::uint32_t index = 0; index < steps_.size(); ++index) {
    systemc::Retired retired{.segment = segment, .index = index};
    machines::PixelClocks at_pixels;
    for (const NodeState& state : steps_[index]) {
      at_pixels.all += state.pixel_clocks;
      at_pixels.enabled += state.enabled_clocks;
      retired.clocks = std::max(retired.clocks, state.clocks);
      retired.enabled_pixels += state.enabled_pixels;
    }
    if (branches_) retired.at_pixels = at_pixels;
    retirement->after_instruction(retired, view_of(region, nodes_, steps_[index]));
  }
  if (steps_.empty()) return retirement->after_segment(segment, systemc::ClearView());
  retirement->after_segment(segment, view_of(region, nodes_, ends_));
}

void Collector::after_clear(const isa::Region& segment) {
  if (++ended_ < reported_.size()) return;
  ended_ = 0;
  for (const isa::Region& part : divide_region(segment, nodes_.width, nodes_.height)) {
    retirement->after_segment(names_.segment_of(part), systemc::ClearView());
  }
}

}  // namespace csgsim::multi_processor
