#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "hw/scan_line/cells.h"
#include "hw/scan_line/figures.h"
#include "hw/scan_line/packet.h"
#include "hw/scan_line/snapshot.h"

namespace csgsim::scan_line {

/// A packet whose last beat has just left the last cell of the line.
struct Departure {
  PacketKind kind = PacketKind::none;
  std::uint32_t segment = 0;
  std::uint32_t index = 0;             ///< of the instruction in the segment
  std::uint64_t enabled_pixels = 0;    ///< cells whose E was 1 when the instruction came to them
  std::uint64_t busy_cells = 0;        ///< clocks that an instruction's packet was in a cell, summed over the line's
  const Snapshot* snapshot = nullptr;  ///< as the packet asked for it; until the next step
};

/// A chain of cells, the hold register of each, and the shift chain that takes the colours back to the refresh port at
/// cell 0. In a clock every beat of a packet works in the cell that it is in, and then moves on by one. With trees a
/// beat moves on from level to level, and then works in all cells of the line in one clock.
///
/// A mark makes each cell hold its colour with its last beat. In the clock after that has been in the line's last cell,
/// all hold registers go to the shift chain, which has pixel 0 at the port in the next clock, then pixel 1, and so on.
///
/// Cells do what a packet asks of them when it has left the last of them, all together; a cell that is looked at, and
/// those before it, have caught up by then.
class Chain {
 public:
  Chain(std::uint32_t cells, std::uint32_t memory_bits, const CellShape& shape);

  /// Clocks from the entry to that cell.
  [[nodiscard]] std::uint32_t clocks_to(std::uint32_t cell) const {
    return clocks_to_cell(network_, cells_.count(), cell);
  }

  /// Empties the chain, for lines of that many pixels (1 to the number of cells).
  void begin(std::uint32_t pixels);

  /// One clock, in which that beat is in cell 0, or at the root of the tree. Throws std::logic_error for a mark that
  /// comes too soon, so that a hold register or the shift chain is not free yet, and for a beat that is not the next of
  /// its packet or comes into one.
  void step(const Beat& entering);

  /// What is at the refresh port in the clock that comes.
  [[nodiscard]] RefreshPixel refresh() const;

  /// What left the last cell in the clock that has been; of PacketKind::none if nothing did.
  [[nodiscard]] const Departure& departure() const { return departure_; }

  // For waves: of a cell, as the clocks that have been left it.
  /// What is in a cell, one that takes clocks to come to, in the clock that comes.
  [[nodiscard]] Beat beat_in(std::uint32_t cell) const;
  /// Of which segment that cell holds a pixel; none before its first.
  [[nodiscard]] std::optional<std::uint32_t> segment_of(std::uint32_t cell) const;
  /// The words of F that have come in, of the packet that brought some last.
  [[nodiscard]] std::uint64_t sum(std::uint32_t cell) const;
  [[nodiscard]] bool enabled(std::uint32_t cell) const;
  [[nodiscard]] std::uint64_t read(std::uint32_t cell, isa::Field field) const;
  /// What that cell's hold register has.
  [[nodiscard]] std::uint32_t held(std::uint32_t cell) const;
  /// What the shift chain has at that cell, in the clock that comes; none if nothing of the line is left there.
  [[nodiscard]] std::optional<std::uint32_t> shifting(std::uint32_t cell) const {
    return shifting_ && shifted_ + cell < pixels_ ? std::optional(shift_[shifted_ + cell]) : std::nullopt;
  }

 private:
  /// A packet on its way.
  struct Flight {
    Packet packet;
    std::vector<CellStep> steps;            ///< of its beats
    std::uint64_t entered = 0;              ///< clock of its first beat
    std::vector<std::uint32_t> done_cells;  ///< for each beat, how many cells have caught up; empty: none, with any
    std::uint64_t enabled = 0;              ///< of these, those that were enabled when they acted
    std::size_t snapshot = no_snapshot;
  };

  static constexpr std::size_t no_snapshot = ~std::size_t{0};

  void shift();
  void transfer();
  void enter(const Beat& beat);
  void take(const Packet& packet);
  void hold();
  void depart();
  [[nodiscard]] Flight& flight(std::size_t number) const;
  [[nodiscard]] std::uint32_t beats_in(const Flight& flight, std::uint32_t cell) const;
  [[nodiscard]] std::uint32_t cells_reached(const Flight& flight, std::uint32_t beat) const;
  void catch_up(std::uint32_t cell) const;
  void catch_up(Flight& flight, std::uint32_t beat, std::uint32_t end) const;
  void finish(Flight& flight);
  void take_down(const Flight& flight, CellRange range) const;
  std::size_t take_snapshot(Keep keep);

  Network network_;
  CellShape shape_;
  mutable Cells cells_;  ///< which catch up when they are looked at
  std::uint32_t pixels_ = 1;
  std::uint64_t clock_ = 0;
  mutable std::vector<Flight> flights_;  ///< a ring, the oldest first
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  std::optional<Packet> brought_;           ///< the last that has left of those that brought F
  std::vector<std::uint64_t> sums_before_;  ///< in each cell, what had come in before the chain was emptied
  std::optional<std::uint32_t> cleared_;    ///< segment of the last that has left of those that cleared
  std::vector<std::uint32_t> shift_;
  std::uint32_t shifted_ = 0;                ///< pixels of the line that have left the shift chain
  bool shifting_ = false;                    ///< some have not
  bool held_ = false;                        ///< a mark has come to the cells whose line the shift chain has not taken
  bool transfers_ = false;                   ///< it does so in this clock
  mutable std::vector<Snapshot> snapshots_;  ///< used and unused
  std::vector<std::size_t> unused_;
  Departure departure_;
  std::size_t departed_snapshot_ = no_snapshot;
  std::uint32_t due_ = 0;  ///< number of the beat that has to enter next
};

}  // namespace csgsim::scan_line
