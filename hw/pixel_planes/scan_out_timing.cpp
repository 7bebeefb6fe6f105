#include "hw/pixel_planes/scan_out_timing.h"

#include <algorithm>

#include "hw/machines/clocks.h"
#include "hw/pixel_planes/figures.h"

namespace csgsim::pixel_planes {

ScanOutTiming::ScanOutTiming(const machines::Machine& machine, std::uint32_t colour_bits, std::uint64_t edge)
    : bits_(colour_bits),
      rows_(machine.array.height),
      shift_clocks_((machine.array.width + machines::kind_figures<Figures>(machine).scan_out_pixels - 1) /
                    machines::kind_figures<Figures>(machine).scan_out_pixels),
      way_(machines::evaluator_latency(machine) + 2),
      shared_(machines::kind_figures<Figures>(machine).scan_out_port == ScanOutPort::shared),
      row_begun_(edge),
      request_(edge + 1) {
  if (shared_) return;
  while (row_ < rows_) finish_row(row_begun_ + bits_);
}

void ScanOutTiming::record_refresh_word(std::uint64_t edge) {
  request_ = edge + 1;
  if (++sent_ == bits_) finish_row(edge + way_);
}

void ScanOutTiming::record_remaining_words(std::uint64_t edge) {
  while (request() != never) record_refresh_word(std::max(request(), edge));
}

/// Ends the latching of a row at `edge`. The row is shown from then on, or after the previous row.
void ScanOutTiming::finish_row(std::uint64_t edge) {
  latched_ = edge;
  row_begun_ = row_ == 0 ? edge : std::max(edge, row_begun_ + shift_clocks_);
  request_ = row_begun_ + 1;
  sent_ = 0;
  ++row_;
}

}  // namespace csgsim::pixel_planes
