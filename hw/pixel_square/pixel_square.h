#pragma once

#include <cstdint>
#include <memory>
#include <systemc>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/account.h"
#include "hw/pixel_square/corner_divider.h"
#include "hw/pixel_square/frame_buffer.h"
#include "hw/pixel_square/graphics_processors.h"
#include "hw/pixel_square/host_sender.h"
#include "hw/pixel_square/model_receiver.h"
#include "hw/pixel_square/model_source.h"
#include "hw/pixel_square/port_word.h"
#include "hw/pixel_square/renderer.h"
#include "hw/pixel_square/ring.h"
#include "hw/pixel_square/ring_word.h"
#include "hw/pixel_square/store_sender.h"
#include "hw/systemc/clock.h"
#include "hw/systemc/clocked_machine.h"
#include "hw/systemc/evaluator_form.h"
#include "hw/systemc/retirement.h"
#include "hw/systemc/segment_names.h"

namespace csgsim::pixel_square {

/// The whole pixel-square machine (thesis fig. 7.3):
///
///     host ─┬─▶ FIFO ─▶ renderer 0 ─▶ FIFO ─▶ frame buffer
///           ├─▶ FIFO ─▶ renderer 1 ─▶ FIFO ─────▲  ▲
///           └─▶ FIFO of clears ────────────────────┘
///
/// If the machine has dividers, the host is replaced by a FIFO for the model, a receiver for that FIFO, the dividers
/// with one store each, and the unit that sends the stored squares.
///
/// If it has graphics processors, a ring connects the FIFOs of processors and renderers on its input side to those of
/// renderers and frame buffer on its output side:
///
///     processor 0 ─▶ FIFO ─▶ ring ─▶ FIFO ─▶ renderer 0 ─▶ FIFO ─▶ ring
///     renderer 0  ─▶ FIFO ─▶ ring ─▶ FIFO ─▶ frame buffer
///
/// All units act on the rising edge of one clock. A word written at an edge can be read at the next; an entry freed at
/// an edge can be filled at the next.
class PixelSquareMachine final : public sc_core::sc_module, public systemc::ClockedMachine {
 public:
  PixelSquareMachine(sc_core::sc_module_name name, const machines::Machine& machine, systemc::EvaluatorForm form);

  /// Draws a frame, until the frame buffer has stored the last word or cleared the last square. A Program without
  /// segments takes no clock.
  systemc::RunReport run(const isa::Program& program, systemc::RunListener& listener) override;

  [[nodiscard]] std::vector<wave::Tap> taps(const isa::Program& program, const wave::Request& request) const override;

 private:
  /// Units that distribute the squares: the host; the host and dividers; or graphics processors.
  struct Front {
    std::unique_ptr<HostSender> host;
    std::unique_ptr<sc_core::sc_fifo<isa::LinkWord>> model;
    std::unique_ptr<ModelSource> source;
    std::unique_ptr<ModelReceiver> receiver;
    std::vector<std::unique_ptr<CornerDivider>> dividers;
    std::unique_ptr<StoreSender> sender;
    std::unique_ptr<GraphicsProcessors> processors;
  };

  /// The ring, its input FIFOs, and the FIFOs from the ring to the frame buffer; used only with graphics processors.
  struct RingParts {
    explicit RingParts(const machines::Machine& machine);

    sc_core::sc_vector<sc_core::sc_fifo<RingWord>> words;
    sc_core::sc_vector<sc_core::sc_signal<std::uint64_t>> targets;
    sc_core::sc_vector<sc_core::sc_fifo<PortWord>> colours;
    Ring ring;
  };

  [[nodiscard]] std::vector<wave::Tap> front_taps(const isa::Program& program) const;
  [[nodiscard]] std::vector<wave::Tap> processor_taps(const isa::Program& program) const;
  [[nodiscard]] std::vector<wave::Tap> pixel_taps(wave::Pixel pixel, const isa::Program& program,
                                                  const wave::Request& request) const;
  void bind_front(const machines::Machine& machine);
  void bind_divider(const machines::Machine& machine);
  void bind_sender();
  void bind_ring(const machines::Machine& machine);
  void begin_front(const isa::Program& program);
  void begin_dividers(const machines::Size& picture);
  /// Valid without graphics processors.
  [[nodiscard]] Sender& sender() { return front_.host ? static_cast<Sender&>(*front_.host) : *front_.sender; }
  [[nodiscard]] const Sender& sender() const {
    return front_.host ? static_cast<const Sender&>(*front_.host) : *front_.sender;
  }
  void begin(const isa::Program& program, systemc::RunListener& listener);
  void on_done();
  [[nodiscard]] std::uint64_t edges() const;
  [[nodiscard]] SquareAccount frame_account(std::uint64_t clocks) const;
  [[nodiscard]] std::vector<std::uint32_t> picture_of(const isa::Program& program) const;

  const machines::Machine machine_;
  systemc::Clock clock_;
  sc_core::sc_vector<sc_core::sc_fifo<isa::LinkWord>> instructions_;
  sc_core::sc_vector<sc_core::sc_fifo<PortWord>> colours_;
  sc_core::sc_vector<sc_core::sc_fifo<PortWord>> clears_;
  sc_core::sc_vector<sc_core::sc_signal<std::uint64_t>> finished_;
  sc_core::sc_signal<std::uint64_t> frames_{"frames"};

  Front front_;
  std::unique_ptr<RingParts> ring_;
  std::vector<isa::Region> squares_;  ///< squares of the frame, for dividers
  sc_core::sc_vector<Renderer> renderers_;
  FrameBuffer frame_buffer_;
  systemc::SegmentNames names_;
  systemc::Retirement retirement_{"retirement"};
};

}  // namespace csgsim::pixel_square
