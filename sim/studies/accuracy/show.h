#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/design/row.h"

namespace csgsim::studies {

/// Those at which that knob is turned: `together` are z bits and fraction bits.
std::vector<Measurement> of_knob(std::span<const Measurement> measurements, std::string_view knob);

/// Of measurements of one picture (same size and faceting), those that no other beats in both clocks and wrong pixels;
/// fewest clocks first. Points that took the same clocks and were as wrong are listed once.
std::vector<Measurement> pareto_front(std::span<const Measurement> measurements);

/// One step along a front: what it costs to have at most half the wrong pixels.
struct Halving {
  Measurement from;
  Measurement to;
  double more_clocks = 0;  ///< as a part of from's clocks
};

/// Steps along a front from its cheapest point, each to the cheapest with at most half the wrong pixels.
std::vector<Halving> halvings(std::span<const Measurement> front);

/// Curved surfaces that are drawn without facets, and what facets of the same accuracy cost.
struct EqualFacets {
  Measurement curved;
  Measurement facets;     ///< the fewest clocks of those that are as right; if none is, those that are least wrong
  bool as_right = false;  ///< whether no more pixels of the facets differ from the true curved surfaces
};

/// One for each way to draw curved surfaces that is not by facets, if facets were measured too: those of the knobs fn
/// and tolerance, and those that the model says.
std::vector<EqualFacets> facets_as_right(std::span<const Measurement> rows);

/// Prints the points, the front, and the cost of facets that are as accurate as curved surfaces.
void print_accuracy(std::span<const Measurement> rows, unsigned views);

/// What was measured.
struct MeasuredModel {
  std::string model;
  unsigned views = 1;  ///< that each point was drawn in
};

/// Errors and clocks against the values of each knob, and the Pareto front of z bits and fraction bits.
std::vector<plots::Plot> plots_of_accuracy(std::span<const Measurement> rows, const MeasuredModel& of);

}  // namespace csgsim::studies
