#include "hw/multi_processor/list_renderer.h"

namespace csgsim::multi_processor {

ListRenderer::ListRenderer(const Figures& figures, const isa::ArrayShape& nodes, std::span<const isa::Instruction> list,
                           const ListForm& form, std::span<const systemc::Keep> keeps, const NodePixels& own,
                           const PixelMemory& before)
    : order_(figures.order),
      program_(figures.chain.program),
      nodes_(nodes),
      list_(list),
      form_(form),
      keeps_(keeps),
      own_(own),
      begins_(before.pixels() == 0),
      processor_(figures),
      memory_(begins_ ? PixelMemory(own.count(), nodes.memory_bits) : before),
      steps_(list.size()) {
  for (std::size_t i = 0; i < list_.size(); ++i) {
    if (keeps_[i] != systemc::Keep::nothing) steps_[i].pixels = memory_;
  }
}

template <class Visit>
void ListRenderer::for_each_in_row(std::uint32_t row, const Visit& visit) {
  for (std::uint32_t column = 0; column < own_.columns; ++column) {
    visit(std::size_t{row} * own_.columns + column, column);
    processor_.count_pixel();
  }
}

template <class Visit>
void ListRenderer::for_each_pixel(const Visit& visit) {
  for (std::uint32_t row = 0; row < own_.rows; ++row) {
    for_each_in_row(row, [&](std::size_t pixel, std::uint32_t /*column*/) { visit(pixel); });
    processor_.count_row();
  }
}

void ListRenderer::render() {
  if (own_.count() == 0 || list_.empty()) return;  // a node without pixels does not read the list
  if (begins_) for_each_pixel([&](std::size_t /*pixel*/) { processor_.clear(nodes_.memory_bits); });
  if (program_ == NodeProgram::native) {
    for (const isa::Instruction& instruction : list_) processor_.link(instruction, form_);
  }
  switch (order_) {
    case RenderingOrder::segment: return by_segment();
    case RenderingOrder::scan_line: return by_scan_line();
    case RenderingOrder::pixel: return by_pixel();
  }
}

void ListRenderer::by_segment() {
  for (std::size_t index = 0; index < list_.size(); ++index) {
    const isa::Linear& linear = list_[index].linear;
    fetch(list_[index]);
    std::uint64_t sum = 0;
    std::uint64_t across = 0;
    std::uint64_t down = 0;
    if (linear.width > 0) {
      sum = processor_.start(linear, x_of(0), y_of(0));
      across = processor_.step(linear, linear.a, nodes_.width);
      down = processor_.step(linear, linear.b, nodes_.height);
    }
    for (std::uint32_t row = 0; row < own_.rows; ++row) {
      execute_row(index, row, sum, across);
      if (linear.width > 0) processor_.add(linear, sum, down);
      processor_.count_row();
    }
  }
}

void ListRenderer::by_scan_line() {
  for (std::uint32_t row = 0; row < own_.rows; ++row) {
    for (std::size_t index = 0; index < list_.size(); ++index) {
      const isa::Linear& linear = list_[index].linear;
      fetch(list_[index]);
      std::uint64_t sum = 0;
      std::uint64_t across = 0;
      if (linear.width > 0) {
        sum = processor_.start(linear, x_of(0), y_of(row));
        across = processor_.step(linear, linear.a, nodes_.width);
      }
      execute_row(index, row, sum, across);
    }
    processor_.count_row();
  }
}

void ListRenderer::by_pixel() {
  for (std::uint32_t row = 0; row < own_.rows; ++row) {
    for_each_in_row(row, [&](std::size_t pixel, std::uint32_t column) {
      for (std::size_t index = 0; index < list_.size(); ++index) {
        const isa::Linear& linear = list_[index].linear;
        fetch(list_[index]);
        const PixelStart pixel_start = begin(index, pixel);
        const std::uint64_t sum = linear.width > 0 ? processor_.start(linear, x_of(column), y_of(row)) : 0;
        act(index, pixel, sum);
        end(index, pixel, pixel_start);
      }
    });
    processor_.count_row();
  }
}

void ListRenderer::execute_row(std::size_t instruction_index, std::uint32_t row, std::uint64_t sum,
                               std::uint64_t step) {
  const isa::Linear& linear = list_[instruction_index].linear;
  for_each_in_row(row, [&](std::size_t pixel, std::uint32_t /*column*/) {
    const PixelStart pixel_start = begin(instruction_index, pixel);
    act(instruction_index, pixel, sum);
    if (linear.width > 0) processor_.add(linear, sum, step);
    end(instruction_index, pixel, pixel_start);
  });
}

void ListRenderer::fetch(const isa::Instruction& instruction) {
  if (program_ == NodeProgram::native) return processor_.call(instruction);
  processor_.fetch(instruction, form_);
}

/// Begins an instruction at a pixel: tests the enable bit.
ListRenderer::PixelStart ListRenderer::begin(std::size_t instruction_index, std::size_t pixel) {
  const PixelStart pixel_start{processor_.clocks(), processor_.unbranched_clocks(), memory_.enabled(pixel)};
  steps_[instruction_index].enabled_pixels += pixel_start.is_enabled ? 1U : 0U;
  processor_.test_enable(list_[instruction_index], memory_, pixel);
  return pixel_start;
}

void ListRenderer::act(std::size_t instruction_index, std::size_t pixel, std::uint64_t sum) {
  NodeState& step = steps_[instruction_index];
  processor_.act(list_[instruction_index], memory_, pixel, sum);
  if (keeps_[instruction_index] != systemc::Keep::nothing) step.pixels.copy(pixel, memory_);
}

void ListRenderer::end(std::size_t instruction_index, std::size_t pixel, const PixelStart& pixel_start) {
  NodeState& step = steps_[instruction_index];
  const std::uint64_t clocks = processor_.clocks() - pixel_start.clocks;
  step.clocks = processor_.unbranched_clocks() - pixel_start.unbranched_clocks;
  step.pixel_clocks += clocks;
  if (pixel_start.is_enabled) step.enabled_clocks += clocks;
  for (const Watched& one : watched_) {
    if (one.pixel == pixel)
      one.moments->push_back({instruction_index, {pixel_start.clocks, processor_.clocks()}, memory_.of(pixel)});
  }
}

std::vector<std::uint32_t> ListRenderer::store_colours(isa::Field colour) {
  std::vector<std::uint32_t> colours;
  if (colour.width == 0) return colours;
  for_each_pixel([&](std::size_t pixel) {
    colours.push_back(processor_.load_colour(memory_, pixel, colour));
    processor_.store_colour(colour);
  });
  return colours;
}

std::uint64_t background_clocks(const Figures& figures, const NodePixels& node_pixels, isa::Field colour) {
  WordProcessor processor(figures);
  if (colour.width == 0) return 0;
  for (std::uint32_t row = 0; row < node_pixels.rows; ++row) {
    for (std::uint32_t column = 0; column < node_pixels.columns; ++column) {
      processor.store_colour(colour);
      processor.count_pixel();
    }
    processor.count_row();
  }
  return processor.clocks();
}

}  // namespace csgsim::multi_processor
