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

/// What a renderer is told.
struct TimedCommand {
  CommandKind kind = CommandKind::start;
  std::uint64_t words = 0;              ///< on the link
  std::uint64_t clocks = 0;             ///< of the pixels' controller
  const isa::Region* region = nullptr;  ///< with the end: of the square
  std::uint64_t skips = 0;              ///< instructions after it that are not carried out
  machines::ClockSpan* told = nullptr;  ///< unless null, becomes the clocks of the frame that these are
};

/// Some bits of a command; the last bring the whole of it.
struct TimedLinkWord {
  std::optional<TimedCommand> whole;
};

struct TimedPortWord {
  bool last = false;                 ///< of the square, or of the header of one to clear
  std::optional<std::uint32_t> row;  ///< of the picture, in which it begins; none for a word of a header
  std::size_t cleared = 0;           ///< with the last of such a header: the number of the square
};

/// A renderer, as edges see it: the decoder of its commands, its pixels, and what their squares leave through.
class RendererTiming {
 public:
  RendererTiming(const machines::Machine& machine, std::uint32_t colour_bits, std::size_t renderer, Agenda& agenda);

  [[nodiscard]] Fifo<TimedLinkWord>& link() { return link_; }
  [[nodiscard]] Fifo<TimedPortWord>& colours() { return colours_; }

  // What its three parts do at an edge.
  void decode(Time now);
  void draw(Time now);
  void leave(Time now);

  /// It gets one more square.
  void hand() { ++handed_; }

  /// Squares that it has got and, as can be told at that edge, not finished.
  [[nodiscard]] std::uint64_t unfinished(Time now) const { return handed_ - finished_ + (finished_at_ == now ? 1 : 0); }

  [[nodiscard]] std::uint64_t finished() const { return finished_; }
  [[nodiscard]] const SquareClocks& clocks(Time end) { return clocks_.whole(end); }

 private:
  void obey(const TimedCommand& command, Time now);
  void move_out(Time now);
  void finish(Time now);

  Agenda* agenda_;
  std::size_t pixels_;   ///< part
  std::size_t decoder_;  ///< part
  std::size_t output_;   ///< part
  std::uint64_t
      waiting_;   ///< finished squares that may wait beside the one that is drawn; 0: they leave from the pixels
  Time latency_;  ///< from the controller to the pixels
  std::uint32_t colour_bits_;
  std::uint64_t port_bits_;
  Time move_clocks_;   ///< to the second buffer
  Time latch_clocks_;  ///< of a row, with one buffer; 0: nothing is latched

  Fifo<TimedLinkWord> link_;
  Fifo<TimedPortWord> colours_;
  PartClocks clocks_;  ///< of the pixels

  std::optional<TimedCommand> command_;  ///< that the decoder holds
  std::optional<LeavingSquare> drawn_;   ///< a square that is drawn and has not moved
  std::uint64_t skips_left_ = 0;         ///< commands that are to be dropped
  bool moving_ = false;                  ///< a square, to the second buffer
  bool leaving_ = false;                 ///< a square, from the pixels' memory
  std::deque<LeavingSquare> squares_;    ///< that have not left, the first of which leaves
  Time whole_at_ = 0;                    ///< edge at which the last of them was, where it waits
  std::optional<RowLatch> latch_;        ///< of its rows
  Time left_ = 0;                        ///< edge of its last word
  std::uint64_t handed_ = 0;
  std::uint64_t finished_ = 0;
  Time finished_at_ = 0;
};

}  // namespace csgsim::pixel_square
