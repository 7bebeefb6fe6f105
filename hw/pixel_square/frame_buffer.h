#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <systemc>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/pixel_square/activity_counter.h"
#include "hw/pixel_square/words.h"

namespace csgsim::pixel_square {

/// What the frame buffer has to take for a frame.
struct FrameContents {
  std::uint64_t squares = 0;      ///< drawn or cleared
  std::uint32_t colour_bits = 0;  ///< a pixel
  std::uint32_t background = 0;   ///< colour of a cleared square
};

/// Holds the picture. Takes one word of colours, or clears one square, a clock. Its ports, one a renderer and after
/// them the divider's, take turns: the first that has a word gets its turn, counted from the one after the port that
/// had the last.
class FrameBuffer final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_vector<sc_core::sc_fifo_in<ColourWord>> colours;  ///< one a renderer
  sc_core::sc_fifo_in<ClearWord> clears{"clears"};
  sc_core::sc_out<std::uint64_t> frames{"frames"};  ///< that are whole

  FrameBuffer(sc_core::sc_module_name name, machines::Size picture, std::uint32_t renderers);

  void begin(const FrameContents& contents);

  /// Of every pixel, in row order: what was stored last, 0 if nothing ever was.
  [[nodiscard]] std::span<const std::uint32_t> picture() const { return picture_; }
  [[nodiscard]] const machines::SquareClocks& account() const { return counter_.clocks(); }

 private:
  void on_clock();
  machines::SquareActivity act();
  bool serve(std::size_t port);
  void store(const ColourWord& word);
  void clear(const isa::Region& region);
  void count_square();

  const machines::Size size_;
  std::vector<std::uint32_t> picture_;
  FrameContents contents_;
  std::uint64_t squares_ = 0;
  std::size_t turn_ = 0;  ///< port that is asked first
  std::uint64_t frames_done_ = 0;
  ActivityCounter counter_;
};

}  // namespace csgsim::pixel_square
