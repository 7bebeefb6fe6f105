#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hw/isa/program.h"
#include "hw/scan_line/packet.h"
#include "hw/scan_line/snapshot.h"

namespace csgsim::scan_line {

/// An instruction whose packet has just left the last cell of its line.
struct Retired {
  std::uint32_t segment = 0;
  std::uint32_t index = 0;           ///< within the segment
  std::uint64_t clocks = 0;          ///< in which its words entered
  std::uint64_t enabled_pixels = 0;  ///< cells whose E was 1 when it came to them
};

/// Sees a run go by: the lines of a chain one after the other, those of different chains side by side.
class RunListener {
 public:
  virtual ~RunListener() = default;

  /// What the snapshot after that instruction has to show.
  [[nodiscard]] virtual Keep keeps_after(std::uint32_t /*segment*/, std::uint32_t /*index*/) const {
    return Keep::nothing;
  }
  virtual void after_instruction(const Retired& /*retired*/, const Snapshot* /*snapshot*/) {}

  /// The snapshot shows all.
  virtual void after_line(std::uint32_t /*segment*/, const Snapshot& /*snapshot*/) {}
};

/// What is drawn, and who sees it; all of it has to live until the run is done. Line i belongs to chain i mod chains.
struct Frame {
  std::span<const isa::Segment> lines;  ///< each of one row, all equally wide
  isa::Field colour;                    ///< which the refresh shows
  std::uint32_t background = 0;         ///< which it shows for a line without instructions
  RunListener* listener = nullptr;

  [[nodiscard]] std::uint32_t pixels() const { return lines.empty() ? 0 : lines.front().region.width; }
};

/// Counts the clock periods that have ended since the first edge after begin().
class Periods {
 public:
  void begin() { *this = {}; }
  void edge() {
    if (begun_) ++count_;
    begun_ = true;
  }
  [[nodiscard]] std::uint64_t count() const { return count_; }

 private:
  bool begun_ = false;
  std::uint64_t count_ = 0;
};

}  // namespace csgsim::scan_line
