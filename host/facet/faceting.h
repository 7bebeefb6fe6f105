// Options of faceting.
// Used by curved.h, solid.h, solid_at.h, host/setup and sim.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace csgsim::facet {

/// How curved solids are represented: as in OpenSCAD, with the facets that the caller requests, or as exact curved
/// surfaces.
struct Faceting {
  /// Maximum distance of facets from the true surface, in model units; if set, as few half-spaces as possible are used.
  std::optional<double> tolerance{};
  /// Replaces OpenSCAD's $fn for every curved solid. Ignored if there is a tolerance.
  std::optional<double> fragments{};
  /// Whether spheres and cylinders stay curved surfaces (quadrics). The two options above apply to solids that are
  /// faceted nevertheless.
  bool exact_curves = false;
  /// Requires exact_curves. Spheres that appear as circles stay curved and are drawn as fast spheres
  /// (host/view/fast_sphere.h); all other solids are faceted.
  bool fast_spheres = false;
  /// Requires exact_curves. A solid whose own $fn is above 0 and below this is meant as a polygon, and is faceted.
  double min_round_sides = 13;
  /// Requires exact_curves. Marks primitives that are faceted nevertheless; empty if there are none.
  std::vector<bool> faceted{};

  bool operator==(const Faceting&) const = default;
};

/// Smallest number of corners of a regular polygon inscribed in a circle whose sides stay within `tolerance` of the
/// circle (the sagitta): the smallest n >= 3 with radius (1 - cos(180 degrees / n)) <= tolerance. Throws InputError if
/// n exceeds max_fragments.
std::uint32_t fragments_within(double radius, double tolerance);

}  // namespace csgsim::facet
