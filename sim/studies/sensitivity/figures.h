// Assumed numbers with a range.
// Used by sim/studies/explore and sim/studies/sensitivity.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "hw/machines/machine.h"

namespace csgsim::studies {

/// An assumed number of a machine or of a process, and the values that it may plausibly have.
struct RangedFigure {
  std::string key;
  std::string unit;
  std::int64_t value = 0;  ///< as stated
  std::int64_t low = 0;
  std::int64_t high = 0;
  std::string reason;  ///< of the range
  bool is_of_process = false;

  bool operator==(const RangedFigure&) const = default;
};

/// Whether a figure sets the size of the picture, of the array or of the memory, on which the compared pictures depend.
bool is_size_figure(std::string_view key);

/// Appends the figures whose range has several values, except sizes and the keys in `but`.
void add_ranged_figures(std::span<const machines::Figure> figures, bool is_of_process, const std::set<std::string>& but,
                        std::vector<RangedFigure>& ranged);

}  // namespace csgsim::studies
