// Options of faceting.
// Used by curved.h, solid.h, solid_at.h and sim.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace csgsim::facet {

/// How curved solids are represented: faceted as in OpenSCAD or as the caller requests, or as exact curves.
struct Faceting {
  /// Maximum distance of facets from the true surface, in model units; uses as few half-spaces as possible.
  std::optional<double> tolerance{};
  /// Replaces OpenSCAD's $fn for every curved solid. Ignored if there is a tolerance.
  std::optional<double> fragments{};
  /// Keeps spheres and cylinders as curved surfaces (quadrics). The other two options apply to solids that are still
  /// faceted.
  bool exact_curves = false;
  /// Only with exact curves: spheres that appear as circles stay curved and are drawn as fast spheres
  /// (host/view/fast_sphere.h); all other solids are faceted.
  bool fast_spheres = false;
  /// Only with exact curves: a solid whose own $fn is above 0 and below this is meant as a polygon, and is faceted.
  double min_round_sides = 13;
  /// Only with exact curves: marks primitives that are faceted nevertheless; none if empty.
  std::vector<bool> faceted{};

  bool operator==(const Faceting&) const = default;
};

/// Number of corners of a regular polygon inscribed in a circle whose sides stay within `tolerance` of it (the
/// sagitta): the smallest n >= 3 with radius (1 - cos(180 / n)) <= tolerance. Throws InputError beyond max_fragments.
std::uint32_t fragments_within(double radius, double tolerance);

}  // namespace csgsim::facet
