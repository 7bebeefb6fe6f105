// The controller of Pixel-planes.
// Used by the Pixel-planes machine.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <systemc>
#include <vector>

#include "hw/array/sequencer.h"
#include "hw/isa/wire.h"
#include "hw/link/receiver.h"
#include "hw/pixel_planes/account.h"
#include "hw/pixel_planes/control_word.h"
#include "hw/pixel_planes/pixel_ports.h"
#include "hw/systemc/clocked_module.h"

namespace csgsim::pixel_planes {

/// State of the controller, for waves.
struct ControllerStatus {
  bool busy = false;          ///< whether it executes an instruction
  std::uint64_t ordinal = 0;  ///< number of the instruction within the frame, including skipped ones
  isa::Instruction instruction;
  std::uint32_t bit = 0;     ///< first stream or field bit of the step on the wires
  std::uint32_t pass = 0;    ///< number of completed passes over a stream or a memory operand
  std::uint64_t clocks = 0;  ///< clocks since the beginning of the frame
};

/// Parameters of the controller.
struct ControllerFigures {
  std::uint32_t link_width = 1;    ///< bits
  std::uint32_t latency = 0;       ///< clocks from the roots of the multiplier trees to the pixels
  std::uint32_t memory_bits = 1;   ///< memory bits per pixel
  std::uint32_t clear_clocks = 0;  ///< clocks to clear this memory; 0 counts as 1
  /// Whether a finished picture is copied into the topmost bits and displayed from there.
  bool two_buffers = false;
};

/// Reads commands from the link and puts a control word on the wires at each rising edge.
///
/// A frame begins with the clock in which the controller requests it from the host. This happens when the host has a
/// frame and, with one buffer, the last row of the previous picture has been latched. The clocks of an instruction are
/// those in which one of its steps is on the wires and, for a global-OR test, those until the answer arrives. If the
/// answer causes a skip, the controller drops the words on the link and requests the host to continue at another
/// instruction.
///
/// After the frame's last command the controller waits `latency` clocks until the last step has reached the pixels, and
/// sends the displayed field to the scan-out. With two buffers it first copies the picture, as soon as the last row of
/// the previous picture has been latched. Refresh words requested by the scan-out have priority over the next command,
/// and are sent whenever the controller waits.
class Controller final : public systemc::ClockedModule {
 public:
  sc_core::sc_fifo_in<isa::LinkWord> link{"link"};
  sc_core::sc_fifo_out<std::uint64_t> requests{"requests"};  ///< instruction at which the host has to continue
  /// One token for each frame in the host's memory that the controller has not begun.
  sc_core::sc_fifo_in<bool> frames{"frames"};
  sc_core::sc_fifo_in<RefreshStep> refreshes{"refreshes"};     ///< bits that the scan-out requests
  sc_core::sc_fifo_in<bool> latched{"latched"};                ///< one token when a picture's last row is latched
  sc_core::sc_fifo_out<FinishedPicture> pictures{"pictures"};  ///< one finished picture at a time, for the scan-out
  sc_core::sc_in<Answer> answer{"answer"};
  sc_core::sc_port<PixelWires> wires{"wires"};
  sc_core::sc_fifo_out<Account> accounts{"accounts"};
  sc_core::sc_out<std::uint64_t> programs{"programs"};  ///< number of completed frames

  /// `period`: clock period.
  Controller(sc_core::sc_module_name name, const sc_core::sc_time& period, const array::Sequencer& sequencer,
             const ControllerFigures& figures);

  /// Resumes in the middle of a frame: `instruction` is in the receiver and begins in clock `first_clock`.
  void resume(const isa::Instruction& instruction, std::uint64_t ordinal, std::uint64_t first_clock);

  /// Clocks of the current or last frame, including the final latency.
  [[nodiscard]] std::uint64_t clocks() const { return status_.clocks; }
  [[nodiscard]] const ControllerAccount& account() const { return account_; }
  [[nodiscard]] std::uint64_t instructions() const { return instructions_; }  ///< number executed in that frame
  [[nodiscard]] bool idle() const { return state_ == State::idle; }
  [[nodiscard]] ControllerStatus status() const;
  [[nodiscard]] std::string_view state() const;  ///< name of the current state, for waves

 private:
  enum class State : std::uint8_t { idle, asking, ready, issuing, clearing, waiting, holding, copying, draining };

  /// Position within an instruction: bit and pass as in ControllerStatus.
  struct Place {
    std::uint32_t bit = 0;
    std::uint32_t pass = 0;
  };

  struct Issued {
    Place place;
    array::BitStep step;
  };

  void end_of_elaboration() override;
  void on_clock() override;
  void act();
  void begin_frame();
  void request_frame();
  void begin_command();
  void begin(const isa::Instruction& instruction);
  void begin(const isa::SegmentStart& start);
  void begin(const isa::SegmentEnd& end);
  void begin(const isa::FrameEnd& end);
  [[nodiscard]] bool has_control_wires() const;
  bool refresh();
  void put_control_word();
  void count_waiting_clock(std::uint64_t& activity_clocks);
  void issue();
  void issue_ahead();
  Issued issued();
  array::BitStep next_step();
  void put_step(std::uint64_t edge, const array::BitStep& step);
  void clear();
  void begin_copy();
  void copy();
  void finish();
  void put(const ControlWord& word, const array::RootBits& bits = {});
  void take_answer();
  void skip_instructions(std::uint64_t instruction_count);
  void receive();
  [[nodiscard]] std::uint64_t edges() const;

  const sc_core::sc_time period_;
  const ControllerFigures figures_;
  array::Sequencer sequencer_;
  link::Receiver receiver_;
  State state_ = State::idle;
  ControllerStatus status_;
  std::uint64_t acted_at_ = 0;       ///< edge of the last action
  std::vector<Place> ahead_;         ///< places of steps that are already on the wires, for the edges from acted_at_ on
  std::optional<Issued> last_step_;  ///< last step of the instruction, if it has not been put on the wires yet
  bool resting_ = false;             ///< whether the wires carry an idle word
  sc_core::sc_event_or_list begins_or_refreshes_;  ///< events that wake an idle controller
  ControllerAccount account_;
  std::uint64_t next_ordinal_ = 0;  ///< ordinal of the next instruction
  std::uint64_t instructions_ = 0;
  std::uint64_t instruction_clocks_ = 0;
  bool jumped_ = false;         ///< whether no command has arrived since instructions were last skipped
  unsigned edges_to_drop_ = 0;  ///< number of further edges at which the words on the link must be dropped
  isa::Region region_;          ///< region being cleared
  std::uint32_t cleared_ = 0;   ///< number of clocks spent on clearing the region
  isa::Field colour_;           ///< colour field of the frame's last command
  isa::Field shown_;            ///< field last sent to the scan-out
  bool unlatched_ = false;      ///< whether some rows of that field have not been latched
  bool refreshed_ = false;      ///< whether a refresh word is on the wires
  std::uint32_t drained_ = 0;
  std::uint64_t programs_done_ = 0;
};

}  // namespace csgsim::pixel_planes
