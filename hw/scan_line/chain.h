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
  WordKind kind = WordKind::none;
  std::uint32_t segment = 0;
  std::uint32_t index = 0;             ///< of the instruction in the segment
  std::uint64_t enabled_pixels = 0;    ///< cells whose E was 1 when the instruction came to them
  std::uint64_t busy_cells = 0;        ///< clocks that an instruction's packet was in a cell, summed over the line's
  const Snapshot* snapshot = nullptr;  ///< as the word asked for it; until the next step
};

/// A chain of cells, the hold register of each, and the shift chain that takes the colours back to the refresh port at
/// cell 0. In a clock every beat of a packet works in the cell that it is in, and then moves on by one. With trees a
/// beat moves on from level to level, and then works in all cells of the line in one clock.
///
/// A mark makes each cell hold its colour with its last beat. In the clock after that has been in the line's last cell,
/// all hold registers go to the shift chain, which has pixel 0 at the port in the next clock, then pixel 1, and so on.
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
  void step(const PacketWord& entering);

  /// What is at the refresh port in the clock that comes.
  [[nodiscard]] RefreshPixel refresh() const;

  /// What left the last cell in the clock that has been; of WordKind::none if nothing did.
  [[nodiscard]] const Departure& departure() const { return departure_; }

  [[nodiscard]] const Cells& cells() const { return cells_; }

  /// What that cell's hold register has.
  [[nodiscard]] std::uint32_t held(std::uint32_t cell) const { return hold_[cell]; }
  /// What the shift chain has at that cell, in the clock that comes; none if nothing of the line is left there.
  [[nodiscard]] std::optional<std::uint32_t> shifting(std::uint32_t cell) const {
    return shifting_ && shifted_ + cell < pixels_ ? std::optional(shift_[shifted_ + cell]) : std::nullopt;
  }

  // For waves.
  /// What is in that cell, one that takes clocks to come to, in the clock that comes; null if nothing is.
  [[nodiscard]] const PacketWord* beat_in(std::uint32_t cell) const;
  /// Of which segment that cell holds a pixel; none before its first.
  [[nodiscard]] std::optional<std::uint32_t> segment_of(std::uint32_t cell) const { return segment_of_[cell]; }

 private:
  /// A beat on its way.
  struct Flight {
    PacketWord word;
    std::uint32_t moved = 0;    ///< clocks since it entered: its cell in a chain, its level in a tree
    std::uint64_t enabled = 0;  ///< cells that the instruction found enabled, counted with the beat of its result
    std::uint64_t busy = 0;     ///< cells in which it was one of an instruction
    std::size_t snapshot = no_snapshot;
  };

  static constexpr std::size_t no_snapshot = ~std::size_t{0};

  void shift();
  void transfer();
  void enter(const PacketWord& word);
  void move(Flight& flight);
  void hold();
  void work(Flight& flight, std::uint32_t cell);
  void clear(const Flight& flight, std::uint32_t cell);
  void work_on_instruction(Flight& flight, std::uint32_t cell);
  void work_on_mark(const Flight& flight, std::uint32_t cell);
  void take_down(const Flight& flight, std::uint32_t cell);
  void depart();
  std::size_t take_snapshot(Keep keep);

  Network network_;
  Cells cells_;
  std::uint32_t pixels_ = 1;
  std::vector<Flight> flights_;  ///< a ring, one a cell
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  std::vector<std::optional<std::uint32_t>> segment_of_;  ///< for each cell
  std::vector<std::uint32_t> hold_;
  std::vector<std::uint32_t> shift_;
  std::uint32_t shifted_ = 0;        ///< pixels of the line that have left the shift chain
  bool shifting_ = false;            ///< some have not
  bool held_ = false;                ///< a mark has come to the cells whose line the shift chain has not taken
  bool transfers_ = false;           ///< it does so in this clock
  std::vector<Snapshot> snapshots_;  ///< used and unused
  std::vector<std::size_t> unused_;
  Departure departure_;
  std::size_t departed_snapshot_ = no_snapshot;
  std::uint32_t due_ = 0;      ///< number of the beat that has to enter next
  std::uint64_t enabled_ = 0;  ///< of the packet that is leaving the last cell
  std::uint64_t busy_ = 0;     ///< likewise
};

}  // namespace csgsim::scan_line
