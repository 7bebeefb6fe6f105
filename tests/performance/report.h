#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "tests/performance/bench.h"

namespace csgsim::bench {

/// All results, with the command for each number.
nlohmann::ordered_json to_json(const Results& results);

nlohmann::ordered_json to_json(const ProgramWork& work);

/// All results as tables in Markdown.
std::string to_tables(const Results& results);

/// Plots of time against each size, named growth_NAME.
std::vector<plots::Plot> plots_of_growths(const std::vector<Growth>& growths);

/// Draws them as SVG and, with gnuplot, as PNG into the folder. Returns the files. Throws InputError if gnuplot cannot
/// be run.
std::vector<std::filesystem::path> draw_growths(const Results& results);

}  // namespace csgsim::bench
