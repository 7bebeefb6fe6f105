// The points of an accuracy study.
// Used by measure.h and by csgsim render with --max-wrong-pixels.
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

/// A point of an accuracy study: one setting of --knobs at some value, the others as given by the user.
struct Settings {
  std::string knob;   ///< z-bits, fraction-bits, edge-on, size, fn, tolerance, curves, or together
  std::string value;  ///< as text; knob and value identify the point
  facet::Faceting faceting;
  view::Sampling sampling;
};

/// Inputs that determine which ways to draw curved surfaces are possible.
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
  facet::Faceting (*faceting)(const facet::Faceting& base) = nullptr;  ///< `base` changed to this way
  /// Why the model, its view, the machine or the scene's effects do not allow this way; empty if they do.
  std::optional<std::string> (*why_not)(const CurvesSubject& subject) = nullptr;
};

std::span<const CurvesChoice> curves_choices();

/// The settings that --knobs accepts, in the order in which they are varied.
std::vector<std::string> knob_names();

/// The settings to vary (--knobs), and their values.
struct Knobs {
  std::vector<std::string> names = knob_names();
  std::vector<double> tolerances{};    ///< model units
  std::vector<CurvesChoice> curves{};  ///< possible ways only
};

/// The default tolerances in model units: fractions of the diagonal.
std::vector<double> default_tolerances(double diagonal);

/// The points of a study around `base`.
std::vector<Settings> accuracy_points(const view::Sampling& base, const facet::Faceting& faceting, const Knobs& knobs);

/// All pairs of z bits and fraction bits, fewest first: the candidates for the cheapest settings.
std::vector<Settings> bit_width_pairs(const view::Sampling& base, const facet::Faceting& faceting);

}  // namespace csgsim::studies
