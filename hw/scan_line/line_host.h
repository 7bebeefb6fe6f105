#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <systemc>

#include "hw/machines/machine.h"
#include "hw/scan_line/active_list.h"
#include "hw/scan_line/activity.h"
#include "hw/scan_line/figures.h"
#include "hw/scan_line/picture_lines.h"
#include "hw/systemc/clocked_module.h"

namespace csgsim::scan_line {

/// The host of a scan-line array. Sorts the picture's primitives into buckets; then, for each line, updates the active
/// list, prepares the line's instructions, and transfers the line to the link of its chain as soon as the link has
/// begun the previous line. The transfer takes one clock. Lines are identified by their number in the frame.
class LineHost final : public systemc::ClockedModule {
 public:
  sc_core::sc_vector<sc_core::sc_fifo_out<std::uint32_t>> lines;  ///< transferred lines, one FIFO per chain

  LineHost(sc_core::sc_module_name name, const Figures& figures);

  /// Begins a frame with the next clock.
  void begin(const PictureLines& frame);

  [[nodiscard]] const ActivityCounter& counter() const { return counter_; }  ///< counter of the frame that began last

  // State for waves.
  [[nodiscard]] std::string_view activity() const { return counter_.now(); }
  /// Line that the host works on; after the last line, the number of lines.
  [[nodiscard]] std::uint32_t line() const { return current_line_; }

 private:
  void on_clock() override;
  LineActivity act();
  void begin_line();

  const Figures figures_;
  PictureLines frame_;
  ActiveList active_;
  std::uint32_t line_ = 0;
  std::uint32_t current_line_ = 0;  ///< line of the clock that began last
  std::uint64_t sorting_ = 0;       ///< remaining clocks of sorting
  std::uint64_t updating_ = 0;      ///< remaining clocks of updating for the line
  std::uint64_t preparing_ = 0;     ///< remaining clocks of preparing for the line
  ActivityCounter counter_;
};

}  // namespace csgsim::scan_line
