#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "hw/machines/machine.h"
#include "sim/report/configuration.h"
#include "sim/report/page.h"
#include "sim/report/pictures.h"

namespace csgsim::report {

/// One of two runs that a page shows beside each other.
struct ShownRun {
  std::string name;  ///< of what was drawn, on which machine
  DrawnProgram drawn;
  const machines::Machine& machine;
  Json stats;           ///< as of a stats file
  std::string explain;  ///< as Context::explain
};

/// The first difference of two runs.
struct FirstDifference {
  std::vector<std::string> told;     ///< in sentences
  std::optional<std::size_t> pixel;  ///< in row order, whose stories come first
};

/// The page of two runs of pictures of one size, A and B: both pictures and where they differ, their counts and clocks
/// side by side, and the drawing of each, for which it is run once more, with stories of the same pixels: some that
/// differ, the background and A's primitives, the most expensive first. The data are `a` and `b`, the stats of each,
/// and `difference`: how many `pixels` differ, and the `first`, or null.
Page two_page(const ShownRun& a, const ShownRun& b, const FirstDifference& first, const Context& context);

}  // namespace csgsim::report
