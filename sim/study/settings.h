#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/facet/faceting.h"
#include "host/view/projection.h"

namespace csgsim::study {

/// One point of an accuracy study: a knob turned to some value, the others as the user has them.
struct Settings {
  std::string knob;   ///< z-bits, fraction-bits, edge-on, size, fn, tolerance, or together
  std::string value;  ///< as text; with the knob it names the point
  facet::Faceting faceting;
  view::Sampling sampling;
};

/// The points of a study around `base`. `diagonal` is the model's, in model units; tolerances are parts of it.
std::vector<Settings> points(const view::Sampling& base, const facet::Faceting& faceting, double diagonal);

/// z bits and fraction bits varied together, fewest first: what a choice of the cheapest settings is made from.
std::vector<Settings> grid(const view::Sampling& base, const facet::Faceting& faceting);

}  // namespace csgsim::study
