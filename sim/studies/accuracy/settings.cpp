#include "sim/studies/accuracy/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "host/facet/curved.h"

namespace csgsim::studies {

namespace {

facet::Faceting as_facets(const facet::Faceting& base) {
  facet::Faceting faceting = base;
  faceting.exact_curves = false;
  faceting.fast_spheres = false;
  faceting.faceted.clear();
  return faceting;
}

facet::Faceting as_fast_spheres(const facet::Faceting& base) {
  facet::Faceting faceting = as_facets(base);
  faceting.exact_curves = true;
  faceting.fast_spheres = true;
  return faceting;
}

facet::Faceting as_quadrics(const facet::Faceting& base) {
  facet::Faceting faceting = as_facets(base);
  faceting.exact_curves = true;
  return faceting;
}

std::optional<std::string> no_reason(const CurvesSubject& /*subject*/) { return std::nullopt; }

std::optional<std::string> why_no_fast_spheres(const CurvesSubject& subject) {
  if (subject.camera.projection == view::Projection::perspective)
    return "fast spheres are drawn as circles, but in perspective spheres are ellipses; use --projection "
           "ortho";
  const facet::Faceting fast = as_fast_spheres({});
  const bool has_sphere = std::ranges::any_of(
      subject.tree.primitives, [&](const model::Primitive& primitive) { return facet::stays_curved(primitive, fast); });
  if (!has_sphere) return "the model has no sphere that appears as a circle";
  return emit::curves_unsupported_reason(subject.machine, subject.options, subject.look);
}

std::optional<std::string> quadrics_unsupported_reason(const CurvesSubject& subject) {
  return emit::quadrics_unsupported_reason(subject.machine, subject.options, subject.look);
}

constexpr CurvesChoice choices_of_curves[] = {
    {emit::Curves::facets, as_facets, no_reason},
    {emit::Curves::fast, as_fast_spheres, why_no_fast_spheres},
    {emit::Curves::exact, as_quadrics, quadrics_unsupported_reason},
};

/// Adds a point with that value of the knob. Returns its settings, initially the user's, for the caller to change.
using Add = std::function<Settings&(std::string value)>;

struct Knob {
  const char* name;
  void (*turn)(const Add& add, const Settings& base, const Knobs& turned);
};

constexpr Knob knobs[] = {
    {"z-bits",
     [](const Add& add, const Settings& /*base*/, const Knobs& /*turned*/) {
       for (unsigned bits = 8; bits <= 24; bits += 2) add(std::to_string(bits)).sampling.z_bits = bits;
     }},
    {"fraction-bits",
     [](const Add& add, const Settings& /*base*/, const Knobs& /*turned*/) {
       for (unsigned bits = 0; bits <= 16; bits += 2) add(std::to_string(bits)).sampling.fraction_bits = bits;
     }},
    {"edge-on",
     [](const Add& add, const Settings& /*base*/, const Knobs& /*turned*/) {
       for (unsigned parts = 4; parts <= 4096; parts *= 4)
         add(fmt::format("1/{}", parts)).sampling.edge_on_fraction = 1.0 / parts;
     }},
    {"size",
     [](const Add& add, const Settings& base, const Knobs& /*turned*/) {
       for (const unsigned part : {8U, 4U, 2U, 1U}) {
         const std::uint32_t width = std::max(1U, base.sampling.width / part);
         const std::uint32_t height = std::max(1U, base.sampling.height / part);
         view::Sampling& sampling = add(fmt::format("{}x{}", width, height)).sampling;
         sampling.width = width;
         sampling.height = height;
       }
     }},
    {"fn",
     [](const Add& add, const Settings& /*base*/, const Knobs& /*turned*/) {
       for (unsigned fragments = 8; fragments <= 128; fragments *= 2)
         add(std::to_string(fragments)).faceting = {std::nullopt, fragments};
     }},
    {"tolerance",
     [](const Add& add, const Settings& /*base*/, const Knobs& turned) {
       for (const double tolerance : turned.tolerances)
         add(fmt::format("{:g}", tolerance)).faceting = {tolerance, std::nullopt};
     }},
    {"curves",
     [](const Add& add, const Settings& base, const Knobs& turned) {
       for (const CurvesChoice& choice : turned.curves)
         add(std::string(emit::name_of(choice.curves))).faceting = choice.faceting(base.faceting);
     }},
    {"together",
     [](const Add& add, const Settings& /*base*/, const Knobs& /*turned*/) {
       for (unsigned z = 10; z <= 20; z += 2) {
         for (unsigned fraction = 2; fraction <= 12; fraction += 2) {
           view::Sampling& sampling = add(fmt::format("{}/{}", z, fraction)).sampling;
           sampling.z_bits = z;
           sampling.fraction_bits = fraction;
         }
       }
     }},
};

}  // namespace

std::span<const CurvesChoice> curves_choices() { return choices_of_curves; }

std::vector<std::string> knob_names() {
  std::vector<std::string> names;
  for (const Knob& knob : knobs) names.emplace_back(knob.name);
  return names;
}

std::vector<double> default_tolerances(double diagonal) {
  return {1e-2 * diagonal, 3e-3 * diagonal, 1e-3 * diagonal, 3e-4 * diagonal, 1e-4 * diagonal};
}

std::vector<Settings> accuracy_points(const view::Sampling& base, const facet::Faceting& faceting,
                                      const Knobs& turned) {
  std::vector<Settings> settings;
  for (const Knob& knob : knobs) {
    if (std::ranges::find(turned.names, knob.name) == turned.names.end()) continue;
    const Settings unturned{knob.name, "", faceting, base};
    const Add add = [&](std::string value) -> Settings& {
      Settings& point = settings.emplace_back(unturned);
      point.value = std::move(value);
      return point;
    };
    knob.turn(add, unturned, turned);
  }
  return settings;
}

std::vector<Settings> bit_width_pairs(const view::Sampling& base, const facet::Faceting& faceting) {
  return accuracy_points(base, faceting, {{"together"}});
}

}  // namespace csgsim::studies
