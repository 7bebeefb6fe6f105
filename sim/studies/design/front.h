// Pareto fronts of designs.
// Used by explore, accuracy and advise.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/studies/design/row.h"

namespace csgsim::studies {

/// A quantity by which designs are compared; lower is better.
struct ExploreAxis {
  const char* name;
  const char* title;  ///< including the unit
  /// Value of a drawn row; empty if it has no price.
  std::optional<double> (*value)(const ExploreRow& row);
  bool is_of_picture;  ///< a value per frame, summed over models; otherwise a property of the hardware: the maximum
                       ///< over models
  bool may_be_zero;    ///< whether find_knee() uses the logarithm of 1 + value
};

/// All axes.
std::span<const ExploreAxis> explore_axes();

std::vector<std::string> explore_axis_names();

/// Parses a list of names separated by commas and keeps its order. Throws InputError for an unknown name.
std::vector<ExploreAxis> parse_axes(const std::string& text);

/// Value on the axis of a design, given by its rows, one per model: the sum or the maximum. Empty if a row has no
/// price.
std::optional<double> value_of(std::span<const ExploreRow> rows, std::span<const std::size_t> design,
                               const ExploreAxis& axis);

/// Values of a candidate, one per axis; all candidates have the same number.
using Values = std::vector<double>;

/// Whether each candidate is Pareto-optimal: no other is at most equal on every axis and lower on one. Equal candidates
/// have equal results.
std::vector<bool> pareto_flags(std::span<const Values> candidates);

/// Indices of the candidates on the front, sorted by their values; duplicates are listed once.
std::vector<std::size_t> front_indices(std::span<const Values> candidates);

/// The front of rows, whose values are given by `values_of`.
template <class Row, class ValuesOf>
std::vector<Row> front_rows(std::span<const Row> rows, const ValuesOf& values_of) {
  std::vector<Values> values;
  for (const Row& row : rows) values.push_back(values_of(row));
  std::vector<Row> front;
  for (const std::size_t one : front_indices(values)) front.push_back(rows[one]);
  return front;
}

/// The knee of the front: the candidate closest to the best values of all axes at once. Values are mapped to logarithms
/// (of 1 + value if the value may be 0) and scaled to 0 (minimum of the front) to 1 (maximum); the knee has the
/// smallest sum of squares, and is the first among equals. `front` selects the candidates. Empty if there are none.
std::optional<std::size_t> find_knee(std::span<const Values> candidates, const std::vector<bool>& front,
                                     std::span<const ExploreAxis> axes);

/// Designs compared with each other, by how they draw one model or all models.
struct ExploreGroup {
  std::string model;              ///< empty: all models
  std::vector<ExploreAxis> axes;  ///< the requested axes on which at least one design has a price
  std::vector<std::size_t> rows;  ///< row of each candidate; for all models that of the first model
  std::vector<Values> values;     ///< one per candidate
  std::vector<bool> front;
  std::optional<std::size_t> knee;  ///< index of a candidate
  std::size_t refused = 0;          ///< number of designs that cannot draw the model
  std::size_t unpriced = 0;         ///< number of designs without a price on one of the axes; they are not candidates
};

/// One group per model, and one for all models if there are several. In the latter, values per frame are summed over
/// the models, and the hardware is that of the most demanding model.
std::vector<ExploreGroup> groups_of(std::span<const ExploreRow> rows, std::span<const ExploreAxis> axes);

}  // namespace csgsim::studies
