#pragma once

#include <string>

#include "sim/plots/plot.h"
#include "sim/report/page.h"

namespace csgsim::report {

/// Series that a plot shows; of more the page says so.
inline constexpr std::size_t most_series = 12;

/// A plot as a figure: its legend, the picture (for wide windows and for narrow ones), and its values as a table.
/// Each point tells its values where it is pointed at. `id` is the figure's. Lines look as `looks` has it; those that
/// it does not name, by their place in the plot.
std::string plot_html(const Plot& plot, const std::string& id, const plots::Looks& looks = {});

/// The looks of the lines of all plots of a page: lines of one name look alike in all of them.
plots::Looks page_looks(const Page& page);

}  // namespace csgsim::report
