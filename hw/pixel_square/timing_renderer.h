#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "hw/machines/machine.h"
#include "hw/machines/timeline.h"
#include "hw/pixel_square/timing_agenda.h"
#include "hw/pixel_square/timing_leaving.h"

namespace csgsim::pixel_square {

enum class CommandKind : std::uint8_t { start, instruction, end };

/// A command as a renderer receives it.
struct TimedCommand {
  CommandKind kind = CommandKind::start;
  std::uint64_t words = 0;              ///< number of link words
  std::uint64_t clocks = 0;             ///< clocks of the pixels' controller
  const isa::Region* region = nullptr;  ///< region of the square; set in the end command
  std::uint64_t skips = 0;              ///< number of following instructions that are skipped
  machines::ClockSpan* span = nullptr;  ///< receives the clocks of the frame that the command occupies, unless null
};

/// Word of a command; the last word contains the whole command.
struct TimedLinkWord {
  std::optional<TimedCommand> whole;
};

struct TimedPortWord {
  bool last = false;                 ///< whether this ends the square, or the header of a square to clear
  std::optional<std::uint32_t> row;  ///< row of the picture in which the word begins; empty for a header word
  std::size_t cleared = 0;           ///< number of the square; set in the last word of the header of a square to clear
};

/// Edge-level model of a renderer: its command decoder, its pixels, and its output.
class RendererTiming {
 public:
  RendererTiming(const machines::Machine& machine, std::uint32_t colour_bits, std::size_t renderer, Agenda& agenda);

  [[nodiscard]] Fifo<TimedLinkWord>& link() { return link_; }
  [[nodiscard]] Fifo<TimedPortWord>& colours() { return colours_; }

  // Each lets one of the three units (decoder, pixels, output) act at an edge.
  void decode(Time now);
  void draw(Time now);
  void leave(Time now);

  /// Assigns one more square to the renderer.
  void assign() { ++assigned_; }

  /// Number of assigned squares that are not finished, as visible at edge `now`.
  [[nodiscard]] std::uint64_t unfinished_squares(Time now) const {
    return assigned_ - finished_ + (finished_at_ == now ? 1 : 0);
  }

  [[nodiscard]] std::uint64_t finished() const { return finished_; }
  [[nodiscard]] const SquareClocks& clocks(Time end) { return clocks_.complete(end); }

 private:
  void execute(const TimedCommand& command, Time now);
  void move_out(Time now);
  void finish(Time now);

  Agenda* agenda_;
  std::size_t pixels_;   ///< unit number
  std::size_t decoder_;  ///< unit number
  std::size_t output_;   ///< unit number
  /// Finished squares that can wait in addition to the one being drawn; 0 if squares leave from the pixels' memory.
  std::uint64_t waiting_;
  Time latency_;  ///< clocks from the controller to the pixels
  std::uint32_t colour_bits_;
  std::uint64_t port_bits_;
  Time move_clocks_;   ///< clocks to move a square to the second buffer or the backing store
  Time latch_clocks_;  ///< with one buffer: clocks to latch a row; 0 if nothing is latched

  Fifo<TimedLinkWord> link_;
  Fifo<TimedPortWord> colours_;
  PartClocks clocks_;  ///< clocks of the pixels

  std::optional<TimedCommand> command_;  ///< command held by the decoder
  std::optional<LeavingSquare> drawn_;   ///< a drawn square that has not moved yet
  std::uint64_t skips_left_ = 0;         ///< commands still to be dropped
  bool moving_ = false;                  ///< whether a square moves to the second buffer
  bool leaving_ = false;                 ///< whether a square leaves from the pixels' memory
  std::deque<LeavingSquare> squares_;    ///< squares that have not left completely; the first is leaving
  Time whole_at_ = 0;                    ///< edge at which the last of these squares was complete in the buffer
  std::optional<RowLatch> latch_;        ///< latch for the rows of the leaving square
  Time left_ = 0;                        ///< edge at which the last square's last word left
  std::uint64_t assigned_ = 0;
  std::uint64_t finished_ = 0;
  Time finished_at_ = 0;
};

}  // namespace csgsim::pixel_square
