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

/// An instruction at a pixel, with the clocks in which it was carried out there, counted from the rendering's first,
/// and the pixel after it.
struct PixelMoment {
  std::size_t index = 0;
  machines::ClockSpan clocks{};
  PixelMemory after;
};

/// Carries out a subsegment's list on a node's pixels of it, in the loops of the order, and clocks are counted as it
/// does so.
class ListRenderer {
 public:
  /// `keeps`: what is to be kept after each instruction. All has to live as long as the renderer. `before`: what the
  /// instructions of the list that came before have left of the pixels; empty if none did.
  ListRenderer(const Figures& figures, const isa::ArrayShape& nodes, std::span<const isa::Instruction> list,
               const ListForm& form, std::span<const systemc::Keep> keeps, const NodePixels& own,
               const PixelMemory& before);

  /// Has what becomes of one of the pixels, counted row by row, told to `moments`, which has to live as long as the
  /// renderer.
  void watch(std::size_t pixel, std::vector<PixelMoment>& moments) { watched_.push_back({pixel, &moments}); }

  /// Carries out the list; before its first instruction memory is cleared, and a native program made.
  void render();

  /// Copies the colours of the pixels, in row order, into the image memory.
  std::vector<std::uint32_t> store_colours(isa::Field colour);

  [[nodiscard]] std::uint64_t clocks() const { return processor_.clocks(); }

  /// One an instruction.
  [[nodiscard]] std::vector<NodeState>& steps() { return steps_; }
  [[nodiscard]] PixelMemory& memory() { return memory_; }

 private:
  struct Watched {
    std::size_t pixel = 0;
    std::vector<PixelMoment>* moments = nullptr;
  };

  /// When an instruction begins at a pixel: clocks that have passed, and that would have without branches taken.
  struct Begun {
    std::uint64_t clocks = 0;
    std::uint64_t whole_clocks = 0;
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
  Begun begin(std::size_t index, std::size_t pixel);
  void act(std::size_t index, std::size_t pixel, std::uint64_t sum);
  void end(std::size_t index, std::size_t pixel, const Begun& begun);
  void along_row(std::size_t index, std::uint32_t row, std::uint64_t sum, std::uint64_t step);

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

/// Clocks in which a node makes so many of its pixels show a colour that is at hand.
std::uint64_t background_clocks(const Figures& figures, const NodePixels& own, isa::Field colour);

}  // namespace csgsim::multi_processor
