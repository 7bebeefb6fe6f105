#include "hw/multi_processor/clocks.h"

#include <bit>
#include <optional>

#include "hw/base/quotient.h"
#include "hw/multi_processor/figures.h"

namespace csgsim::multi_processor {

namespace {

using machines::Machine;

/// Clocks of an operation at all of the node's pixels, including the enclosing loops.
std::uint64_t pass_clocks(const NodePixels& node_pixels, std::uint64_t clocks_per_pixel, const Figures& figures) {
  return node_pixels.count() * (clocks_per_pixel + figures.loop.pixel) +
         node_pixels.rows * std::uint64_t{figures.loop.row};
}

/// Clocks of the loops that enclose the loop over instructions.
std::uint64_t outer_clocks(const NodePixels& node_pixels, const Figures& figures) {
  switch (figures.order) {
    case RenderingOrder::segment: return 0;
    case RenderingOrder::scan_line: return node_pixels.rows * std::uint64_t{figures.loop.row};
    case RenderingOrder::pixel: return pass_clocks(node_pixels, 0, figures);
  }
  return 0;
}

constexpr std::uint64_t bits_a_word = 64;  ///< bits in a word of a plane

/// For each word of a plane's row, a mask that selects the pixels of the node's first `columns` columns.
std::vector<std::uint64_t> row_mask(const machines::PixelActivity& pixel_activity, const NodePixels& node_pixels,
                                    std::uint64_t columns, const isa::ArrayShape& nodes) {
  std::vector<std::uint64_t> mask(pixel_activity.row_words);
  for (std::uint64_t column = 0; column < columns; ++column) {
    const std::uint64_t x = node_pixels.first_x + column * nodes.width;
    mask[static_cast<std::size_t>(x / bits_a_word)] |= std::uint64_t{1} << x % bits_a_word;
  }
  return mask;
}

/// Counts the pixels of a node that are set in a plane. The node's pixels are numbered row by row.
class PlaneCounts {
 public:
  /// `nodes`: array of nodes over which the pixels are interleaved.
  PlaneCounts(const machines::PixelActivity& pixel_activity, const NodePixels& own, const isa::ArrayShape& nodes)
      : met_(pixel_activity), own_(own), nodes_(nodes), row_(row_mask(pixel_activity, own, own.columns, nodes)) {}

  /// Number of set pixels in [begin, end).
  [[nodiscard]] std::uint64_t between(std::uint32_t plane, std::uint64_t begin, std::uint64_t end) const {
    return before(plane, end) - before(plane, begin);
  }

  [[nodiscard]] std::uint64_t all(std::uint32_t plane) const { return before(plane, own_.count()); }

 private:
  [[nodiscard]] std::uint64_t before(std::uint32_t plane, std::uint64_t end) const {
    const std::vector<std::uint64_t>& words = met_.planes[plane];
    if (words.empty() || end == 0) return 0;
    std::uint64_t sum = 0;
    const auto add_row = [&](std::uint64_t row, const std::vector<std::uint64_t>& mask) {
      const std::uint64_t* const bits =
          &words[static_cast<std::size_t>(own_.first_y + row * nodes_.height) * mask.size()];
      for (std::size_t i = 0; i < mask.size(); ++i) sum += static_cast<std::uint64_t>(std::popcount(bits[i] & mask[i]));
    };
    const std::uint64_t whole_rows = end / own_.columns;
    for (std::uint64_t row = 0; row < whole_rows; ++row) add_row(row, row_);
    if (const std::uint64_t rest = end % own_.columns; rest > 0)
      add_row(whole_rows, row_mask(met_, own_, rest, nodes_));
    return sum;
  }

  const machines::PixelActivity& met_;
  const NodePixels own_;
  const isa::ArrayShape nodes_;
  std::vector<std::uint64_t> row_;
};

std::uint64_t at_enabled(std::uint64_t enabled, std::uint64_t chosen, const PixelCosts& costs) {
  return (enabled - chosen) * costs.unselected + chosen * costs.full;
}

}  // namespace

std::uint64_t pixel_clocks(const isa::Instruction& instruction, const Machine& machine) {
  return pixel_costs(instruction, machines::kind_figures<Figures>(machine)).full;
}

machines::PixelClocks subsegment_pixel_clocks(const isa::Segment& segment, std::size_t index, const Machine& machine,
                                              const machines::PixelActivity* pixel_activity) {
  const PixelCosts costs = pixel_costs(segment.instructions[index], machines::kind_figures<Figures>(machine));
  const NodePixels own{0, 0, segment.region.width, segment.region.height};
  if (pixel_activity == nullptr) return {own.count() * costs.maximum(), own.count() * costs.maximum()};
  const PlaneCounts counts(*pixel_activity, own, {1, 1, 0});
  const machines::PixelActivity::Planes planes = pixel_activity->instructions[index];
  const std::uint64_t enabled = counts.all(planes.enabled);
  const std::uint64_t clocks = at_enabled(enabled, counts.all(planes.chosen), costs);
  return {(own.count() - enabled) * costs.disabled + clocks, clocks};
}

std::uint64_t clearing_clocks(const NodePixels& node_pixels, const Machine& machine) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  const std::uint64_t memory_words = quotient_up(machine.array.memory_bits, figures.word_bits) + 1;
  return pass_clocks(node_pixels, memory_words * figures.operations.write, figures);
}

RenderingClocks::RenderingClocks(const ListPart& part, const Machine& machine)
    : part_(part), machine_(machine), figures_(machines::kind_figures<Figures>(machine)) {
  costs_.reserve(part.instructions.size());
  for (const isa::Instruction& instruction : part.instructions)
    costs_.push_back(instruction_costs(instruction, part.form, figures_));
  for (const InstructionCosts& one : costs_) {
    chain_ += one.link;
    once_ += one.once;
    row_ += one.row;
    pixel_ += one.pixel + (part.pixel_activity == nullptr ? one.at_pixel.maximum() : one.at_pixel.disabled);
  }
  if (part.pixel_activity != nullptr) compute_weights();
}

void RenderingClocks::compute_weights() {
  std::vector<std::uint64_t> weights(part_.pixel_activity->planes.size());
  for (std::size_t i = 0; i < costs_.size(); ++i) {
    const machines::PixelActivity::Planes planes = part_.pixel_activity->instructions[part_.first + i];
    const PixelCosts& costs = costs_[i].at_pixel;
    weights[planes.enabled] += costs.unselected - costs.disabled;
    weights[planes.chosen] += costs.full - costs.unselected;
  }
  for (std::uint32_t plane = 0; plane < weights.size(); ++plane) {
    if (weights[plane] != 0) weights_.push_back({plane, weights[plane]});
  }
}

std::uint64_t RenderingClocks::list_clocks(const NodePixels& node_pixels) const {
  std::uint64_t clocks =
      outer_clocks(node_pixels, figures_) + chain_ + once_ + node_pixels.rows * row_ + node_pixels.count() * pixel_;
  if (part_.begins) clocks += clearing_clocks(node_pixels, machine_);
  if (weights_.empty()) return clocks;
  const PlaneCounts counts(*part_.pixel_activity, node_pixels, machine_.array);
  for (const Weight& one : weights_) clocks += one.clocks * counts.all(one.plane);
  return clocks;
}

std::uint64_t RenderingClocks::all(const NodePixels& node_pixels, isa::Field colour) const {
  if (node_pixels.count() == 0) return 0;
  const bool has_instructions = !costs_.empty();
  const std::uint64_t clocks = has_instructions ? list_clocks(node_pixels) : 0;
  if (!part_.ends || colour.width == 0) return clocks;
  const bool is_background = part_.begins && !has_instructions;
  const std::uint64_t words = quotient_up(colour.width, figures_.word_bits);
  const std::uint64_t reads = is_background ? 0 : words * figures_.operations.read;
  return clocks + pass_clocks(node_pixels, reads + words * figures_.operations.write, figures_);
}

/// Each enclosing loop, from the outermost inwards, has begun once for every row or pixel before this one.
std::vector<machines::ClockSpan> RenderingClocks::spans_at(const NodePixels& node_pixels, std::uint32_t column,
                                                           std::uint32_t row) const {
  if (costs_.empty()) return {};  // without instructions there are no planes to count
  std::optional<PlaneCounts> counts;
  if (part_.pixel_activity != nullptr) counts.emplace(*part_.pixel_activity, node_pixels, machine_.array);
  const auto at_pixels = [&](std::size_t i, std::uint64_t begin, std::uint64_t end) {
    const PixelCosts& costs = costs_[i].at_pixel;
    if (!counts) return (end - begin) * costs.maximum();
    const machines::PixelActivity::Planes planes = part_.pixel_activity->instructions[part_.first + i];
    const std::uint64_t enabled = counts->between(planes.enabled, begin, end);
    const std::uint64_t chosen = planes.chosen == planes.enabled ? enabled : counts->between(planes.chosen, begin, end);
    return (end - begin - enabled) * costs.disabled + at_enabled(enabled, chosen, costs);
  };
  const auto clocks = [&](std::size_t i, std::uint64_t rows, std::uint64_t begin, std::uint64_t end) {
    return costs_[i].overhead_clocks(rows, end - begin) + at_pixels(i, begin, end);
  };
  const auto clocks_of_all = [&](std::uint64_t rows, std::uint64_t begin, std::uint64_t end) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < costs_.size(); ++i) sum += clocks(i, rows, begin, end);
    return sum;
  };
  const std::uint64_t row_begin = std::uint64_t{row} * node_pixels.columns;
  const std::uint64_t here = row_begin + column;
  std::uint64_t now = (part_.begins ? clearing_clocks(node_pixels, machine_) : 0) + chain_;
  if (figures_.order != RenderingOrder::segment) {
    now += outer_clocks({.columns = node_pixels.columns, .rows = row}, figures_) + clocks_of_all(row, 0, row_begin);
    if (figures_.order == RenderingOrder::pixel)
      now += column * std::uint64_t{figures_.loop.pixel} + clocks_of_all(0, row_begin, here);
  }
  std::vector<machines::ClockSpan> spans;
  spans.reserve(costs_.size());
  for (std::size_t i = 0; i < costs_.size(); ++i) {
    std::uint64_t begin = now + costs_[i].reach;
    switch (figures_.order) {
      case RenderingOrder::segment:
        begin = now + clocks(i, row, 0, here);
        now += clocks(i, node_pixels.rows, 0, node_pixels.count());
        break;
      case RenderingOrder::scan_line:
        begin = now + clocks(i, 1, row_begin, here);
        now += clocks(i, 1, row_begin, row_begin + node_pixels.columns);
        break;
      case RenderingOrder::pixel: now += clocks(i, 0, here, here + 1); break;
    }
    spans.push_back({begin, begin + at_pixels(i, here, here + 1)});
  }
  return spans;
}

double max_rendering_clocks(std::span<const isa::Instruction> list, const isa::Region& region, const ListForm& form,
                            const Machine& machine) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  double clocks = 0;
  for (const isa::Instruction& instruction : list) {
    const InstructionCosts costs = instruction_costs(instruction, form, figures);
    clocks += static_cast<double>(costs.at_pixel.maximum() + costs.reach + costs.sum + costs.link + figures.loop.pixel +
                                  figures.loop.row);
  }
  const std::uint64_t words =
      quotient_up(machine.array.memory_bits + 2ULL * isa::max_field_width, std::uint64_t{figures.word_bits}) + 4;
  clocks += static_cast<double>(words * (std::uint64_t{figures.operations.read} + figures.operations.write) +
                                3 * (std::uint64_t{figures.loop.pixel} + figures.loop.row));
  return 2 * clocks * region.width * region.height;
}

}  // namespace csgsim::multi_processor
