#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace csgsim::facet {

/// How curved solids become half-spaces: as OpenSCAD facets them, or as the caller says. Or whether they stay curved.
struct Faceting {
  /// Facets stay within this distance of the true surface, model units, with as few half-spaces as that allows.
  std::optional<double> tolerance{};
  /// OpenSCAD's $fn for every curved solid, whatever the model says. Ignored where there is a tolerance.
  std::optional<double> fragments{};
  /// Spheres and cylinders stay curved surfaces: quadrics. The other two hold for what is faceted still.
  bool exact_curves = false;
  /// With exact curves: only spheres that are seen as circles stay curved, and are drawn as fast spheres
  /// (host/view/fast_sphere.h); the rest is faceted.
  bool fast_spheres = false;
  /// With exact curves: solids whose own $fn is above 0 and less than this are meant as polygons, and are faceted.
  double fewest_round = 13;
  /// With exact curves: by primitive, those that are faceted all the same; none if empty.
  std::vector<bool> faceted{};

  bool operator==(const Faceting&) const = default;
};

/// Corners of a regular polygon inside a circle whose sides stay within `tolerance` of it (the sagitta): the least n
/// with radius (1 - cos(180 / n)) <= tolerance, at least 3. Throws InputError past max_fragments.
std::uint32_t fragments_within(double radius, double tolerance);

}  // namespace csgsim::facet
