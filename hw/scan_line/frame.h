#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hw/isa/program.h"

namespace csgsim::scan_line {

/// What is drawn; all of it has to live until the run is done. Line i belongs to chain i mod chains.
struct Frame {
  std::span<const isa::Segment> lines;  ///< each of one row, all equally wide
  isa::Field colour;                    ///< which the refresh shows
  std::uint32_t background = 0;         ///< which it shows for a line without instructions

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
