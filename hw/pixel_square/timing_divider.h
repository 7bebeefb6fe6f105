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

/// A divider, as edges see it: what it tests between the words that it stores, and when there is room for these.
class DividerTiming {
 public:
  /// `told`, unless null, is a blank timeline, which the renderers fill.
  DividerTiming(const isa::Program& program, const machines::Machine& machine, std::size_t part, std::size_t sender,
                Agenda& agenda, machines::Timeline* told);

  [[nodiscard]] StoreTiming& store() { return store_; }

  /// One more square is its own; they come in the order of the Program.
  void give(std::size_t square) { own_.push_back(square); }

  /// The model's last word came at that edge, after so many clocks in which one came.
  void begin(Time now, std::uint64_t words);

  /// What it does at an edge.
  void act(Time now);

  [[nodiscard]] const SquareClocks& clocks(Time end) { return clocks_.whole(end); }

 private:
  /// Words that are stored one after another, and the clocks of tests before the first.
  struct Piece {
    std::uint64_t clocks = 0;
    std::uint64_t words = 0;
    TimedStored last;
  };

  void list_pieces(std::size_t square);
  void next(Time now);

  const isa::Program& program_;
  const machines::Machine& machine_;
  const DivisionClocks division_;
  const std::size_t part_;
  Agenda* agenda_;
  machines::Timeline* told_;
  StoreTiming store_;
  PartClocks clocks_;
  std::deque<std::size_t> own_;  ///< squares that are to be divided
  std::deque<Piece> pieces_;     ///< of the square at hand
  std::uint64_t stored_ = 0;     ///< words of the piece at hand
  std::uint64_t before_ = 0;     ///< clocks of tests that come before the next piece besides its own
  bool from_list_ = false;
};

}  // namespace csgsim::pixel_square
