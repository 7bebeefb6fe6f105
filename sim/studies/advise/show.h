// Output of csgsim advise: texts, JSON and the plot.
// Used by csgsim advise.
#pragma once

#include <span>
#include <string>

#include "sim/plots/plot.h"
#include "sim/studies/advise/advice.h"

namespace csgsim::studies {

/// Prints the number of searched choices and the requirements. `subject` names the model and the machine.
void print_search(const std::string& subject, std::span<const AdviceRow> rows, const Requirements& requirements);

/// Prints the part of the front with the required colours; of a long front, the choices closest to the requirements.
void print_front(std::span<const AdviceRow> rows, const Requirements& requirements);

/// Prints the recommendations and the commands that render them. If no choice meets all requirements, also the
/// conflicting requirements and the closest choice.
void print_advice(const Advice& advice, const Requirements& requirements);

/// The JSON file of a search: requirements, recommendations, the front and all points.
std::string advice_json(const std::string& title, const Requirements& requirements, std::span<const AdviceRow> rows,
                        const Advice& advice);

/// All requirements that the choice misses, as in `6 bits too many, 2.3 frames/s too few`.
std::string misses_text(const AdviceRow& row, const Requirements& requirements);

/// Plot of the maximum frame rate against memory bits per pixel, a step line for each limit of wrong pixels, with the
/// requirements and the recommendations.
plots::Plot plot_of_advice(std::span<const AdviceRow> rows, const Requirements& requirements,
                           std::span<const Recommendation> recommendations, const std::string& model);

}  // namespace csgsim::studies
