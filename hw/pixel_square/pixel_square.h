#pragma once

#include <cstdint>
#include <span>
#include <systemc>

#include "hw/isa/program.h"
#include "hw/machines/accounts.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/divider.h"
#include "hw/pixel_square/frame_buffer.h"
#include "hw/pixel_square/host.h"
#include "hw/pixel_square/renderer.h"
#include "hw/pixel_square/retirement.h"
#include "hw/pixel_square/words.h"

namespace csgsim::pixel_square {

struct RunReport {
  std::uint64_t clocks = 0;  ///< until the frame buffer has stored the last word or cleared the last square
  machines::SquareAccount account;
};

/// The whole pixel-square machine (thesis fig. 7.3):
///
///     host ─▶ FIFO ─▶ divider ─▶ FIFO ─▶ renderer 0 ─▶ FIFO ─▶ frame buffer
///                        ├─────▶ FIFO ─▶ renderer 1 ─▶ FIFO ─────▲  ▲
///                        └─────▶ FIFO of clears ────────────────────┘
///
/// All parts act on the rising edge of one clock. A word written at an edge can be read at the next; a place freed at
/// an edge can be filled at the next. SystemC elaborates once a process, so there can be one in a process; it runs any
/// number of Programs one after the other. From its construction on, a SystemC warning is an exception.
class PixelSquareMachine final : public sc_core::sc_module {
 public:
  PixelSquareMachine(sc_core::sc_module_name name, const machines::Machine& machine);

  /// Draws a frame. The Program has to be one for the machine (machines::check_runs_on). Without segments it takes no
  /// clock. What the listener throws comes out when the machine is done.
  RunReport run(const isa::Program& program, RunListener& listener);

  /// The frame buffer's colours, in row order.
  [[nodiscard]] std::span<const std::uint32_t> picture() const { return frame_buffer_.picture(); }

 private:
  void begin(const isa::Program& program, RunListener& listener);
  void on_done();
  [[nodiscard]] machines::SquareAccount account() const;

  sc_core::sc_clock clock_;
  sc_core::sc_fifo<ModelWord> model_;
  sc_core::sc_vector<sc_core::sc_fifo<InstructionWord>> instructions_;
  sc_core::sc_vector<sc_core::sc_fifo<ColourWord>> colours_;
  sc_core::sc_fifo<ClearWord> clears_;
  sc_core::sc_vector<sc_core::sc_signal<std::uint64_t>> finished_;
  sc_core::sc_signal<std::uint64_t> frames_{"frames"};

  Host host_;
  Divider divider_;
  sc_core::sc_vector<Renderer> renderers_;
  FrameBuffer frame_buffer_;
  Retirement retirement_{"retirement"};
};

}  // namespace csgsim::pixel_square
