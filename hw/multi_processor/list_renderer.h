#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/timeline.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/node_state.h"
#include "hw/multi_processor/regions.h"
#include "hw/multi_processor/word_processor.h"
#include "hw/systemc/run_listener.h"

namespace csgsim::multi_processor {

/// The execution of an instruction at a pixel: its clocks, counted from the start of the rendering, and the pixel's
/// state after it.
struct PixelMoment {
  std::size_t index = 0;
  machines::ClockSpan clocks{};
  PixelMemory after;
};

/// Executes a subsegment's list at a node's pixels in the configured loop order, and counts clocks while doing so.
class ListRenderer {
 public:
  /// `keeps`: for each instruction, the state to record after it. `before`: the pixels after the earlier instructions
  /// of the list; empty if there are none. All references must outlive the renderer.
  ListRenderer(const Figures& figures, const isa::ArrayShape& nodes, std::span<const isa::Instruction> list,
               const ListForm& form, std::span<const systemc::Keep> keeps, const NodePixels& own,
               const PixelMemory& before);

  /// Records the executions at one of the pixels, numbered row by row, in `moments`, which must outlive the renderer.
  void watch(std::size_t pixel, std::vector<PixelMoment>& moments) { watched_.push_back({pixel, &moments}); }

  /// Executes the list; clears memory before its first instruction, and builds the native program if used.
  void render();

  /// Stores the colours of the pixels in the image memory, and returns them in row order.
  std::vector<std::uint32_t> store_colours(isa::Field colour);

  [[nodiscard]] std::uint64_t clocks() const { return processor_.clocks(); }

  /// States of the pixels after each instruction, by index of the instruction.
  [[nodiscard]] std::vector<NodeState>& steps() { return steps_; }
  [[nodiscard]] PixelMemory& memory() { return memory_; }

 private:
  struct Watched {
    std::size_t pixel = 0;
    std::vector<PixelMoment>* moments = nullptr;
  };

  /// State when an instruction begins at a pixel: elapsed clocks, and the clocks that would have elapsed without taken
  /// branches.
  struct PixelStart {
    std::uint64_t clocks = 0;
    std::uint64_t unbranched_clocks = 0;
    bool is_enabled = false;
  };

  template <class Visit>
  void for_each_pixel(const Visit& visit);
  template <class Visit>
  void for_each_in_row(std::uint32_t row, const Visit& visit);

  void by_segment();
  void by_scan_line();
  void by_pixel();
  void fetch(const isa::Instruction& instruction);
  PixelStart begin(std::size_t instruction_index, std::size_t pixel);
  void act(std::size_t instruction_index, std::size_t pixel, std::uint64_t sum);
  void end(std::size_t instruction_index, std::size_t pixel, const PixelStart& pixel_start);
  void execute_row(std::size_t instruction_index, std::uint32_t row, std::uint64_t sum, std::uint64_t step);

  [[nodiscard]] std::uint32_t x_of(std::uint32_t column) const { return own_.first_x + column * nodes_.width; }
  [[nodiscard]] std::uint32_t y_of(std::uint32_t row) const { return own_.first_y + row * nodes_.height; }

  const RenderingOrder order_;
  const NodeProgram program_;
  const isa::ArrayShape nodes_;
  std::span<const isa::Instruction> list_;
  const ListForm form_;
  std::span<const systemc::Keep> keeps_;
  const NodePixels own_;
  const bool begins_;
  WordProcessor processor_;
  PixelMemory memory_;
  std::vector<NodeState> steps_;
  std::vector<Watched> watched_;
};

/// Clocks in which a node sets its pixels to the background colour.
std::uint64_t background_clocks(const Figures& figures, const NodePixels& node_pixels, isa::Field colour);

}  // namespace csgsim::multi_processor
