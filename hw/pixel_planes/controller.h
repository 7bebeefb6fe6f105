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

/// What the controller is at, for waves.
struct ControllerStatus {
  bool busy = false;          ///< with an instruction
  std::uint64_t ordinal = 0;  ///< of the instruction within the frame, those skipped included
  isa::Instruction instruction;
  std::uint32_t bit = 0;     ///< of the stream or field, the first of the step on the wires
  std::uint32_t pass = 0;    ///< of a stream that is sent twice, or of a memory read
  std::uint64_t clocks = 0;  ///< since the frame's first
};

/// The sizes of what the controller is built of.
struct ControllerFigures {
  std::uint32_t link_width = 1;    ///< bits
  std::uint32_t latency = 0;       ///< clocks from the roots of the multiplier trees to the pixels
  std::uint32_t memory_bits = 1;   ///< of a pixel
  std::uint32_t clear_clocks = 0;  ///< in which these become 0; at least one is taken
  bool two_buffers = false;        ///< a picture is copied into the topmost bits, and shown from there
};

/// Takes commands from the link and puts a control word on the wires at each rising edge. A frame begins with the clock
/// in which the controller asks the host for it: when the host has one, and, with one buffer, the last row of the
/// picture before has been latched. An instruction's clocks are those in which one of its steps is on the
/// wires, and, for a question, those until the answer has come. If instructions are to be skipped then, it drops what
/// the link holds and asks the host to go on from another place. After the frame's last command it waits `latency`
/// clocks for the last step to reach the pixels, and tells the scan-out what to show. With two buffers it first copies
/// the picture, as soon as the last row of the one before has been latched. The refresh words that the scan-out asks
/// for go before the next command, and wherever the controller waits for something.
class Controller final : public systemc::ClockedModule {
 public:
  sc_core::sc_fifo_in<isa::LinkWord> link{"link"};
  sc_core::sc_fifo_out<std::uint64_t> requests{"requests"};    ///< the instructions that the host has to go on from
  sc_core::sc_fifo_in<bool> frames{"frames"};                  ///< for each frame that lies in the host's memory, one
  sc_core::sc_fifo_in<RefreshStep> refreshes{"refreshes"};     ///< that the scan-out asks for
  sc_core::sc_fifo_in<bool> latched{"latched"};                ///< one when it has latched a picture's last row
  sc_core::sc_fifo_out<FinishedPicture> pictures{"pictures"};  ///< for the scan-out, one at a time
  sc_core::sc_in<Answer> answer{"answer"};
  sc_core::sc_port<PixelWires> wires{"wires"};
  sc_core::sc_fifo_out<Account> accounts{"accounts"};
  sc_core::sc_out<std::uint64_t> programs{"programs"};  ///< carried out to their end

  /// `period`: of the clock.
  Controller(sc_core::sc_module_name name, const sc_core::sc_time& period, const array::Sequencer& sequencer,
             const ControllerFigures& figures);

  /// In the middle of a frame: the instruction is in the receiver and begins with that clock of the frame.
  void resume(const isa::Instruction& instruction, std::uint64_t ordinal, std::uint64_t first_clock);

  /// Clocks counted for the frame that is being drawn or was drawn last, the final latency included.
  [[nodiscard]] std::uint64_t clocks() const { return status_.clocks; }
  [[nodiscard]] const ControllerAccount& account() const { return account_; }
  [[nodiscard]] std::uint64_t instructions() const { return instructions_; }  ///< of that frame, carried out
  [[nodiscard]] bool idle() const { return state_ == State::idle; }
  [[nodiscard]] ControllerStatus status() const;
  [[nodiscard]] std::string_view state() const;

 private:
  enum class State : std::uint8_t { idle, asking, ready, issuing, clearing, waiting, holding, copying, draining };

  /// As in ControllerStatus.
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
  void ask();
  void begin_command();
  void begin(const isa::Instruction& instruction);
  void begin(const isa::SegmentStart& start);
  void begin(const isa::SegmentEnd& end);
  void begin(const isa::FrameEnd& end);
  [[nodiscard]] bool has_control_wires() const;
  bool refresh();
  void put_control_word();
  void await(std::uint64_t& waiting_for);
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
  void jump(std::uint64_t skipped);
  void receive();
  [[nodiscard]] std::uint64_t edges() const;

  const sc_core::sc_time period_;
  const ControllerFigures figures_;
  array::Sequencer sequencer_;
  link::Receiver receiver_;
  State state_ = State::idle;
  ControllerStatus status_;
  std::uint64_t acted_at_ = 0;       ///< edge
  std::vector<Place> ahead_;         ///< of steps that have been put on the wires for the edges from that one on
  std::optional<Issued> last_step_;  ///< of the instruction, which is then still to be put
  bool resting_ = false;             ///< the wires carry nothing
  sc_core::sc_event_or_list begins_or_refreshes_;  ///< what an idle controller wakes for
  ControllerAccount account_;
  std::uint64_t next_ordinal_ = 0;  ///< of the instruction that comes next
  std::uint64_t instructions_ = 0;
  std::uint64_t instruction_clocks_ = 0;
  bool jumped_ = false;         ///< and no command has come since
  unsigned edges_to_drop_ = 0;  ///< at which what the link holds has to be dropped
  isa::Region region_;          ///< that is being cleared
  std::uint32_t cleared_ = 0;   ///< clocks of that
  isa::Field colour_;           ///< that the frame's end named
  isa::Field shown_;            ///< that the scan-out was told of last
  bool unlatched_ = false;      ///< rows of it are still to be latched
  bool refreshed_ = false;      ///< a refresh word is on the wires
  std::uint32_t drained_ = 0;
  std::uint64_t programs_done_ = 0;
};

}  // namespace csgsim::pixel_planes
