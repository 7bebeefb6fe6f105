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
  std::uint32_t index = 0;           ///< index of the instruction in the segment
  std::uint64_t enabled_pixels = 0;  ///< number of cells whose E was 1 when the instruction reached them
  std::uint64_t busy_cells = 0;  ///< clocks that an instruction's packet was in a cell, summed over the line's cells
  const Snapshot* snapshot = nullptr;  ///< snapshot that the packet requested; valid until the next step
};

/// A chain of cells with one hold register each, and the shift chain that returns the colours to the refresh port at
/// cell 0. In each clock, every cell processes the beat in it, which then moves to the next cell. If the network is
/// trees, a beat moves from level to level, and is then processed by all cells of the line in one clock.
///
/// At the last beat of a mark, each cell stores its colour in its hold register. In the clock after that beat was in
/// the line's last cell, all hold registers are copied to the shift chain. The shift chain then has pixel 0 at the port
/// in the next clock, then pixel 1, and so on.
///
/// Execution is deferred: a packet is executed in all cells when it leaves the last of them. Reading a cell executes
/// the pending steps of that cell and of the cells before it.
class Chain {
 public:
  Chain(std::uint32_t cells, std::uint32_t memory_bits, const CellShape& shape);

  /// Clocks from the entry to a cell.
  [[nodiscard]] std::uint32_t clocks_to(std::uint32_t cell) const {
    return clocks_to_cell(network_, cells_.count(), cell);
  }

  /// Empties the chain; the following lines have `line_pixels` pixels (1 to the number of cells).
  void begin(std::uint32_t line_pixels);

  /// Advances by one clock, in which the beat `entering` is in cell 0 or at the root of the tree. Throws
  /// std::logic_error for a mark that arrives before a hold register or the shift chain is free, and for a beat out of
  /// sequence.
  void step(const Beat& entering);

  /// Pixel at the refresh port in the next clock.
  [[nodiscard]] RefreshPixel refresh() const;

  /// The packet that left the last cell in the last clock; PacketKind::none if there was none.
  [[nodiscard]] const Departure& departure() const { return departure_; }

  // State of a cell for waves, after the completed clocks.
  /// Beat in a cell in the next clock; valid only for cells that a beat needs at least one clock to reach.
  [[nodiscard]] Beat beat_in(std::uint32_t cell) const;
  /// Segment of the pixel in a cell; empty before the first segment.
  [[nodiscard]] std::optional<std::uint32_t> segment_of(std::uint32_t cell) const;
  /// Words of F received from the last packet that has F.
  [[nodiscard]] std::uint64_t sum(std::uint32_t cell) const;
  [[nodiscard]] bool enabled(std::uint32_t cell) const;
  [[nodiscard]] std::uint64_t read(std::uint32_t cell, isa::Field field) const;
  /// Content of the cell's hold register.
  [[nodiscard]] std::uint32_t held(std::uint32_t cell) const;
  /// Colour in the shift chain at a cell in the next clock; empty if no pixel of the line is at that cell.
  [[nodiscard]] std::optional<std::uint32_t> shifting(std::uint32_t cell) const {
    return shifting_ && shifted_ + cell < pixels_ ? std::optional(shift_[shifted_ + cell]) : std::nullopt;
  }

 private:
  /// A packet in the cells.
  struct Flight {
    Packet packet;
    std::vector<CellStep> steps;  ///< steps of its beats
    std::uint64_t entered = 0;    ///< clock of its first beat
    /// For each beat, the number of cells that have executed the beat; empty if no beat has been executed.
    std::vector<std::uint32_t> done_cells;
    std::uint64_t enabled = 0;  ///< number of these cells that were enabled in the acting step
    std::size_t snapshot = no_snapshot;
  };

  static constexpr std::size_t no_snapshot = ~std::size_t{0};

  void shift();
  void transfer();
  void accept_beat(const Beat& beat);
  void take(const Packet& packet);
  void hold();
  void depart();
  [[nodiscard]] Flight& flight(std::size_t index) const;
  [[nodiscard]] std::uint32_t beats_executed(const Flight& flight, std::uint32_t cell) const;
  [[nodiscard]] std::uint32_t cells_reached(const Flight& flight, std::uint32_t beat) const;
  void catch_up(std::uint32_t cell) const;
  void catch_up(Flight& flight, std::uint32_t beat, std::uint32_t end_cell) const;
  void finish(Flight& flight);
  void record_snapshot(const Flight& flight, CellRange range) const;
  std::size_t take_snapshot(Keep keep);

  Network network_;
  CellShape shape_;
  mutable Cells cells_;  ///< mutable: reads execute pending steps
  std::uint32_t pixels_ = 1;
  std::uint64_t clock_ = 0;
  mutable std::vector<Flight> flights_;  ///< a ring, the oldest first
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  std::optional<Packet> last_f_packet_;     ///< packet with F that left last
  std::vector<std::uint64_t> sums_before_;  ///< words of F that each cell received before the chain was emptied
  std::optional<std::uint32_t> cleared_;    ///< segment of the clearing packet that left last
  std::vector<std::uint32_t> shift_;
  std::uint32_t shifted_ = 0;  ///< pixels of the line that have left the shift chain
  bool shifting_ = false;      ///< whether some pixels have not left the shift chain
  bool held_ = false;          ///< whether a mark has reached the cells and the shift chain has not taken the line
  bool transfers_ = false;     ///< whether the shift chain takes the line in this clock
  mutable std::vector<Snapshot> snapshots_;  ///< used and unused
  std::vector<std::size_t> unused_;
  Departure departure_;
  std::size_t departed_snapshot_ = no_snapshot;
  std::uint32_t next_beat_ = 0;  ///< number of the beat that must enter next
};

}  // namespace csgsim::scan_line
