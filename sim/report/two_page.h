// The page that compares two runs.
// Used by sim/app.
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

/// One of two runs on a page.
struct ShownRun {
  std::string name;  ///< name of what was drawn, and the machine
  DrawnProgram drawn;
  const machines::Machine& machine;
  Json stats;           ///< content of a stats file
  std::string explain;  ///< see Context::explain
};

/// The first difference of two runs.
struct FirstDifference {
  std::vector<std::string> sentences;  ///< description for the page
  std::optional<std::size_t> pixel;    ///< index in row order; its histories come first
};

/// The page of two runs, A and B, with pictures of one size: both pictures and their difference, counts and clocks side
/// by side, and the drawing of each, for which the Program runs once more. Both drawings have histories of the same
/// pixels: some that differ, the background, and A's primitives, most expensive first. The data are `a` and `b`, the
/// stats of each, and `difference`: the number of differing `pixels`, and the `first` of them or null.
Page two_page(const ShownRun& a, const ShownRun& b, const FirstDifference& first, const Context& context);

}  // namespace csgsim::report
