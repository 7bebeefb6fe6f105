#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/study/advice.h"

namespace csgsim::study {

/// What memory bits buy: the most frames a second against memory bits a pixel, a staircase for each limit of wrong
/// pixels, with the wishes and what is recommended.
plots::Plot plot_of_advice(std::span<const AdviceRow> rows, const Wishes& wishes,
                           std::span<const Recommendation> recommendations, const std::string& model);

/// Draws it as folder/advise.png and .svg. Returns the files. Throws InputError if gnuplot cannot be run.
std::vector<std::filesystem::path> draw_advice_plot(std::span<const AdviceRow> rows, const Wishes& wishes,
                                                    std::span<const Recommendation> recommendations,
                                                    const std::string& model, const std::filesystem::path& folder);

}  // namespace csgsim::study
