#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/advise/advice.h"

namespace csgsim::studies {

/// What memory bits buy: the most frames a second against memory bits a pixel, a staircase for each limit of wrong
/// pixels, with the wishes and what is recommended.
plots::Plot plot_of_advice(std::span<const AdviceRow> rows, const Wishes& wishes,
                           std::span<const Recommendation> recommendations, const std::string& model);

}  // namespace csgsim::studies
