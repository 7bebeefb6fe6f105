#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/emit/curves.h"
#include "host/emit/look.h"
#include "host/emit/options.h"
#include "host/facet/faceting.h"
#include "host/model/tree.h"
#include "host/view/camera.h"
#include "host/view/projection.h"
#include "hw/machines/machine.h"

namespace csgsim::studies {

/// One point of an accuracy study: a knob turned to some value, the others as the user has them.
struct Settings {
  std::string knob;   ///< z-bits, fraction-bits, edge-on, size, fn, tolerance, curves, or together
  std::string value;  ///< as text; with the knob it names the point
  facet::Faceting faceting;
  view::Sampling sampling;
};

/// What curved surfaces are drawn of, and by what.
struct CurvesSubject {
  const model::Tree& tree;
  const view::Camera& camera;
  const machines::Machine& machine;
  const emit::Options& options;
  const emit::Look& look;
};

/// A way to draw curved surfaces.
struct CurvesChoice {
  emit::Curves curves = emit::Curves::facets;
  facet::Faceting (*faceting)(const facet::Faceting& base) = nullptr;  ///< that `base` is with it
  /// Why the model, its view, the machine, or the scene's effects do not allow it; nothing if they do.
  std::optional<std::string> (*why_not)(const CurvesSubject& subject) = nullptr;
};

std::span<const CurvesChoice> curves_choices();

/// The knobs in the order in which they are turned.
std::vector<std::string> knob_names();

/// Which knobs are turned, and how far.
struct Knobs {
  std::vector<std::string> names = knob_names();
  std::vector<double> tolerances{};    ///< model units
  std::vector<CurvesChoice> curves{};  ///< those that can be drawn
};

/// The tolerances that are usual: parts of the diagonal, model units.
std::vector<double> usual_tolerances(double diagonal);

/// The points of a study around `base`.
std::vector<Settings> points(const view::Sampling& base, const facet::Faceting& faceting, const Knobs& knobs);

/// z bits and fraction bits varied together, fewest first: what a choice of the cheapest settings is made from.
std::vector<Settings> grid(const view::Sampling& base, const facet::Faceting& faceting);

}  // namespace csgsim::studies
