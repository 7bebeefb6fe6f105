#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/timeline.h"
#include "hw/pixel_square/timing_division.h"
#include "hw/pixel_square/timing_store.h"

namespace csgsim::pixel_square {

/// Edge-level model of a divider: the clocks of tests between stored words, and the clocks in which it waits for room
/// in the store.
class DividerTiming {
 public:
  /// `timeline`: null, or a blank timeline that the renderers fill.
  DividerTiming(const isa::Program& program, const machines::Machine& machine, std::size_t part, std::size_t sender,
                Agenda& agenda, machines::Timeline* timeline);

  [[nodiscard]] StoreTiming& store() { return store_; }

  /// Assigns one more square to the divider, in program order.
  void assign(std::size_t square) { assigned_.push_back(square); }

  /// Starts the divider at edge `now`, at which the last of the model's `model_words` words arrives.
  void begin(Time now, std::uint64_t model_words);

  /// Acts at an edge.
  void act(Time now);

  [[nodiscard]] const SquareClocks& clocks(Time end) { return clocks_.complete(end); }

 private:
  /// Words that are stored without tests between them.
  struct Piece {
    std::uint64_t clocks = 0;  ///< clocks of the tests before the first word
    std::uint64_t words = 0;
    TimedStored last;  ///< the last of these words
  };

  void list_pieces(std::size_t square);
  void schedule_next(Time now);

  const isa::Program& program_;
  const machines::Machine& machine_;
  const DivisionClocks division_;
  const std::size_t part_;
  Agenda* agenda_;
  machines::Timeline* timeline_;
  StoreTiming store_;
  PartClocks clocks_;
  std::deque<std::size_t> assigned_;  ///< squares not yet divided
  std::deque<Piece> pieces_;          ///< remaining pieces of the current square
  std::uint64_t stored_ = 0;          ///< words of the current piece that are stored
  std::uint64_t before_ = 0;          ///< clocks of tests before the next piece, in addition to its own
  bool from_list_ = false;
};

}  // namespace csgsim::pixel_square
