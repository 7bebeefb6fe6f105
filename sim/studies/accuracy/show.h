// Tables, fronts and plots of an accuracy study.
// Used by csgsim accuracy.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/design/row.h"

namespace csgsim::studies {

/// The rows of one knob; `together` varies z bits and fraction bits.
std::vector<Measurement> rows_of_knob(std::span<const Measurement> measurements, std::string_view knob);

/// The Pareto front in clocks and wrong pixels of measurements of one picture (same size and faceting), fewest clocks
/// first. Points with equal clocks and wrong pixels are listed once.
std::vector<Measurement> pareto_front(std::span<const Measurement> measurements);

/// One step along a front, to at most half the wrong pixels, and its cost.
struct Halving {
  Measurement from;
  Measurement to;
  double more_clocks = 0;  ///< additional clocks, as a fraction of the clocks of `from`
};

/// Steps along a front from its cheapest point, each to the cheapest point with at most half the wrong pixels.
std::vector<Halving> halvings(std::span<const Measurement> front);

/// A measurement of curved surfaces without facets, and of facets with the same accuracy.
struct EqualFacets {
  Measurement curved;
  Measurement facets;           ///< cheapest facets that are at least as accurate; if there are none, the most accurate
  bool is_as_accurate = false;  ///< the facets differ from the true curved surfaces at no more pixels than `curved`
};

/// One entry for each way to draw curved surfaces without facets, if facets were measured too: those of the knobs fn
/// and tolerance, and those of the model.
std::vector<EqualFacets> equally_accurate_facets(std::span<const Measurement> rows);

/// Prints the points, the front, and the cost of facets that are as accurate as curved surfaces.
void print_accuracy(std::span<const Measurement> rows, unsigned views);

/// Labels of a study's plots.
struct MeasuredModel {
  std::string model;
  unsigned views = 1;  ///< number of views in which each point was drawn
};

/// Plots of errors and clocks against the values of each knob, and of the Pareto front of z bits and fraction bits.
std::vector<plots::Plot> plots_of_accuracy(std::span<const Measurement> rows, const MeasuredModel& model);

}  // namespace csgsim::studies
