#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/studies/design/row.h"

namespace csgsim::studies {

/// What designs are held against each other by; less is better.
struct ExploreAxis {
  const char* name;
  const char* title;  ///< with its unit
  /// Of a row that was drawn; nothing where there is no price.
  std::optional<double> (*value)(const ExploreRow& row);
  bool is_of_picture;  ///< a frame each has its own: those of several models add up; else the greatest is what is built
  bool may_be_zero;
};

/// All that there are.
std::span<const ExploreAxis> explore_axes();

std::vector<std::string> explore_axis_names();

/// Those of a list with commas, in its order. Throws InputError.
std::vector<ExploreAxis> axes_in(const std::string& text);

/// Values on some axes, an axis each; of each candidate as many.
using Values = std::vector<double>;

/// Whether no other is at most as much on each axis, and less on one. Candidates that are equal stand or fall together.
std::vector<bool> pareto_of(std::span<const Values> candidates);

/// Numbers of the front's candidates, by their values; of equal ones the first.
std::vector<std::size_t> listed_front(std::span<const Values> candidates);

/// The same of rows, by the values of each.
template <class Row, class ValuesOf>
std::vector<Row> front_rows(std::span<const Row> rows, const ValuesOf& values_of) {
  std::vector<Values> values;
  for (const Row& row : rows) values.push_back(values_of(row));
  std::vector<Row> front;
  for (const std::size_t one : listed_front(values)) front.push_back(rows[one]);
  return front;
}

/// Of those of the front the one that is nearest to the best of each axis at once: on each axis the logarithm of the
/// value (of 1 + value where it may be 0) is taken, and stretched so that the least of the front is 0 and the greatest
/// 1; the knee has the least sum of squares. Of equals the first; `front` says which candidates count. Nothing of
/// nothing.
std::optional<std::size_t> knee_of(std::span<const Values> candidates, const std::vector<bool>& front,
                                   std::span<const ExploreAxis> axes);

/// Designs that are held against each other: how each draws one model, or all of them.
struct ExploreGroup {
  std::string model;              ///< empty for all
  std::vector<ExploreAxis> axes;  ///< of those asked for, the ones that any design has a price on
  std::vector<std::size_t> rows;  ///< of each candidate, in the order of the rows; for all models that of the first
  std::vector<Values> values;     ///< of each candidate
  std::vector<bool> front;
  std::optional<std::size_t> knee;  ///< a candidate
  std::size_t refused = 0;          ///< designs that cannot draw it
  std::size_t unpriced = 0;         ///< designs without a price on one of the axes; they are no candidates
};

/// A group a model, and where there are several one of all: there, what a picture takes adds up over the models, and
/// what is built is as large as the model asks for that asks for most.
std::vector<ExploreGroup> groups_of(std::span<const ExploreRow> rows, std::span<const ExploreAxis> axes);

}  // namespace csgsim::studies
