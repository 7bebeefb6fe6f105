#include "hw/multi_processor/taps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "hw/isa/instruction_numbers.h"
#include "hw/multi_processor/clocks.h"
#include "hw/multi_processor/list_renderer.h"
#include "hw/wave/instruction_taps.h"
#include "hw/wave/pixel_taps.h"
#include "hw/wave/segments.h"

namespace csgsim::multi_processor {

namespace {

using wave::Number;
using wave::Tap;

std::string corner_text(const isa::Region& region) {
  return region.width == 0 ? std::string() : fmt::format("{},{}", region.x, region.y);
}

std::string_view kind_of(const BusLines& lines) {
  constexpr auto names =
      std::to_array<std::string_view>({"command", "frame", "segment", "heads", "request", "answer", "pause"});
  return lines.number == 0 ? "" : names.at(static_cast<std::size_t>(lines.sent.kind));
}

/// States of a pixel while its node renders.
class PixelStory {
 public:
  PixelStory(wave::Pixel pixel, const Node& node, const isa::Region& region, const machines::Machine& machine)
      : node_(node),
        region_(region),
        machine_(machine),
        own_(pixels_of_node(region, machine.array, pixel.y % machine.array.height, pixel.x % machine.array.width)),
        place_(std::size_t{(pixel.y - region.y - own_.first_y) / machine.array.height} * own_.columns +
               (pixel.x - region.x - own_.first_x) / machine.array.width) {}

  /// Index of the instruction executed there, in the subsegment's list.
  [[nodiscard]] Number instruction() {
    if (!renders()) return std::nullopt;
    // An instruction that would begin in a turn of the screen begins after it.
    const std::uint64_t stalled = node_.is_stalled() ? 1 : 0;
    const auto found = std::ranges::find_if(moments_, [now = elapsed(), stalled](const PixelMoment& one) {
      return one.clocks.begin + stalled <= now && now < one.clocks.end;
    });
    return found == moments_.end() ? std::nullopt : Number(replayed_.list->first + found->index);
  }

  /// What `read` returns for the current state of the pixel; empty if the node holds no state of it.
  template <class Read>
  [[nodiscard]] Number state(const Read& read) {
    if (!renders()) {
      const SavedPixels& saved = node_.saved();
      if (saved.pixels.pixels() == 0 || !(saved.region == region_)) return std::nullopt;
      return Number(read(saved.pixels.of(place_)));
    }
    const bool begins = before_.pixels() == 0;
    if (begins && elapsed() < clearing_clocks(own_, machine_)) return std::nullopt;
    const auto after =
        std::ranges::find_if(moments_, [now = elapsed()](const PixelMoment& one) { return one.clocks.end > now; });
    if (after == moments_.begin()) return begins ? 0 : Number(read(before_));
    return Number(read(std::prev(after)->after));
  }

 private:
  /// Elapsed clocks of the rendering.
  [[nodiscard]] std::uint64_t elapsed() const { return node_.work_elapsed(); }

  bool renders() {
    const Rendering& now = node_.rendering();
    if (now.list == nullptr || !(now.list->region == region_)) return false;
    if (now.list == replayed_.list && now.start_clock == replayed_.start_clock) return true;
    replayed_ = now;
    moments_.clear();
    const std::vector<systemc::Keep> keeps(now.list->instructions.size(), systemc::Keep::nothing);
    before_ = now.before->pixels() == 0 ? PixelMemory() : now.before->of(place_);
    ListRenderer renderer(machines::kind_figures<Figures>(machine_), machine_.array, now.list->instructions,
                          now.list->form, keeps, own_, *now.before);
    renderer.watch(place_, moments_);
    renderer.render();
    return true;
  }

  const Node& node_;
  const isa::Region region_;
  const machines::Machine& machine_;
  const NodePixels own_;
  const std::size_t place_;  ///< index of the pixel among the node's own
  Rendering replayed_;       ///< the rendering that `moments_` belong to
  PixelMemory before_;       ///< the pixel before that rendering; empty for the first part of a list
  std::vector<PixelMoment> moments_;
};

}  // namespace

std::string node_name(std::uint32_t node, const isa::ArrayShape& nodes) {
  return fmt::format("node_{}_{}", node / nodes.width, node % nodes.width);
}

std::vector<Tap> display_taps(const DisplayProcessor& display) {
  return {wave::text("display.activity", [&display] { return std::string(display.activity()); }),
          wave::text("display.segment", [&display] { return corner_text(display.segment()); })};
}

std::vector<Tap> bus_taps(const ControlBus& bus, const sc_core::sc_signal<BusLines>& lines,
                          const isa::ArrayShape& nodes) {
  return {wave::text("bus.activity", [&bus] { return std::string(bus.activity()); }),
          wave::text("bus.master",
                     [&bus, nodes] {
                       const std::optional<std::uint32_t> master = bus.master();
                       if (!master) return std::string();
                       return *master == display_master ? std::string("display")
                                                        : node_name(*master - master_of(0), nodes);
                     }),
          wave::number("bus.words", 32, [&lines] { return Number(lines.read().number); }),
          wave::text("bus.kind", [&lines] { return std::string(kind_of(lines.read())); })};
}

std::vector<Tap> node_taps(const std::string& part, const Node& node) {
  return {wave::text(part + ".activity", [&node] { return std::string(node.activity()); }),
          wave::text(part + ".subsegment", [&node] {
            const List* const list = node.rendering().list;
            return list == nullptr ? std::string() : corner_text(list->region);
          })};
}

std::vector<Tap> pixel_taps(wave::Pixel pixel, const Node& node, const isa::Program& program,
                            const machines::Machine& machine) {
  const std::string part = wave::pixel_part_name(pixel);
  const std::uint32_t segment = wave::segment_of(pixel, program);
  const auto story = std::make_shared<PixelStory>(pixel, node, program.segments[segment].region, machine);
  std::vector<Tap> taps = wave::instruction_taps(
      part, program, [story, first = isa::first_instruction_numbers(program)[segment]]() -> Number {
        const Number index = story->instruction();
        return index ? Number(first + *index) : std::nullopt;
      });
  taps.push_back(wave::bit(
      part + ".enable", [story] { return story->state([](const PixelMemory& memory) { return memory.enabled(0); }); }));
  wave::add(
      wave::field_taps(part, program,
                       [story](isa::Field field) {
                         return story->state([field](const PixelMemory& memory) { return memory.read(0, field); });
                       }),
      taps);
  taps.push_back(wave::hexadecimal(part + ".image", 32, [&node, pixel]() -> Number {
    if (!node.has_image()) return std::nullopt;
    return node.colour(pixel.x, pixel.y);
  }));
  return taps;
}

}  // namespace csgsim::multi_processor
