// Tables and plots of classification methods.
// Used by csgsim classify.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/classify/measure.h"

namespace csgsim::studies {

/// Rows with the same shape and reduction of trees, in the order of the table.
struct ClassifyGroup {
  std::string shape;
  std::string reduced;
  std::vector<ClassifyRow> rows;
};

std::vector<ClassifyGroup> groups_of(std::span<const ClassifyRow> rows);

/// The methods or coherences of the rows, without duplicates, in order of first appearance.
std::vector<std::string> methods_of(std::span<const ClassifyRow> rows);
std::vector<std::string> coherences_of(std::span<const ClassifyRow> rows);

/// The row of a method and a coherence; nullptr if it was not requested.
const ClassifyRow* find_row(std::span<const ClassifyRow> rows, const std::string& method, const std::string& coherence);

/// Prints the rays in the form of the thesis's table 4.9, seconds in the form of table 4.10 for each processor, and the
/// fastest method.
void print_classification(std::span<const ClassifyRow> rows, std::span<const software::Priced> processors);

/// Classification time by method, with a panel per processor and a series per coherence.
std::vector<plots::Plot> plots_of_classification(std::span<const ClassifyRow> rows,
                                                 std::span<const software::Priced> processors,
                                                 const std::string& model);

}  // namespace csgsim::studies
