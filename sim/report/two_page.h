#pragma once

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
  Json stats;  ///< as of a stats file
};

/// The page of two runs of pictures of one size, A and B: both pictures and where they differ, their counts and clocks
/// side by side, and the drawing of each, for which it is run once more. `told`: sentences on where they first differ.
/// The data are `a` and `b`, the stats of each, and `difference`: how many `pixels` differ, and the `first`, or null.
Page two_page(const ShownRun& a, const ShownRun& b, const std::vector<std::string>& told, const Context& context);

}  // namespace csgsim::report
