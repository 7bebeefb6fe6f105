#pragma once

#include <string>

#include "sim/report/page.h"

namespace csgsim::report {

/// Series that a plot shows; of more the page says so.
inline constexpr std::size_t most_series = 12;

/// A plot as a figure: its legend, the picture (for wide windows and for narrow ones), and its values as a table.
/// Each point tells its values where it is pointed at. `id` is the figure's.
std::string plot_html(const Plot& plot, const std::string& id);

}  // namespace csgsim::report
