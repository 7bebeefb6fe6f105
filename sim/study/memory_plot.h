#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "sim/study/sweep.h"

namespace csgsim::study {

/// Draws which bits of pixel memory hold what, a bar for each way in which the rows of one model lay it out, as PNG and
/// SVG into a folder. Throws InputError if gnuplot cannot be run.
std::vector<std::filesystem::path> draw_memory(std::span<const SweepRow> rows, const std::string& model,
                                               const std::filesystem::path& folder);

}  // namespace csgsim::study
