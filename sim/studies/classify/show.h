#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/classify/measure.h"

namespace csgsim::studies {

/// Rows of one shape and one way to reduce trees, the others of them in the order of the table.
struct ClassifyGroup {
  std::string shape;
  std::string reduced;
  std::vector<ClassifyRow> rows;
};

std::vector<ClassifyGroup> groups_of(std::span<const ClassifyRow> rows);

/// In their order, each once.
std::vector<std::string> methods_of(std::span<const ClassifyRow> rows);
std::vector<std::string> coherences_of(std::span<const ClassifyRow> rows);

/// The row of a method and a coherence; nullptr if it was not asked for.
const ClassifyRow* row_of(std::span<const ClassifyRow> rows, const std::string& method, const std::string& coherence);

/// The rays in the form of the thesis's table 4.9, seconds in that of table 4.10 for each processor, and what of
/// that is the least.
void print_classification(std::span<const ClassifyRow> rows, std::span<const software::Priced> processors);

/// Seconds of classification by method, a panel a processor and a line a coherence.
std::vector<plots::Plot> plots_of_classification(std::span<const ClassifyRow> rows,
                                                 std::span<const software::Priced> processors,
                                                 const std::string& model);

}  // namespace csgsim::studies
