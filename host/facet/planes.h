// Table of a model's distinct planes.
// Used by geometry.h, host/convex, host/solids and sim/software.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/facet/coincidence.h"
#include "host/facet/solid.h"

namespace csgsim::facet {

/// One side of a canonical plane: normal . p + offset <= 0 if `positive`, >= 0 otherwise.
struct Halfspace {
  std::uint32_t plane = 0;  ///< index into PlaneTable::planes()
  bool positive = true;

  bool operator==(const Halfspace&) const = default;
};

/// The planes of a model without duplicates. Planes that coincide share an entry, regardless of primitive and
/// orientation, so values computed from them are exactly equal. The first of several coincident planes represents all
/// of them.
class PlaneTable {
 public:
  /// `centre` and `diagonal`: centre and size of the model. Offsets are relative to the centre and compared relative to
  /// the size, so that a model far from the origin loses no precision.
  PlaneTable(const glm::dvec3& centre, double diagonal);

  /// Adds a plane in model space. Returns its canonical half-space.
  Halfspace add(const Plane& plane);

  /// Canonical planes: the first nonzero component of the normal is positive, and offsets are relative to `centre()`.
  [[nodiscard]] const std::vector<Plane>& planes() const { return planes_; }
  [[nodiscard]] const glm::dvec3& centre() const { return centre_; }
  [[nodiscard]] double diagonal() const { return diagonal_; }

 private:
  [[nodiscard]] std::optional<std::uint32_t> find(const Plane& canonical) const;
  void enter(std::uint32_t plane);

  glm::dvec3 centre_;
  double diagonal_;
  std::vector<Plane> planes_;
  /// A hash table of planes by grid cell, with open addressing. Its size is a power of two; at least half of its slots
  /// are empty.
  std::vector<std::uint32_t> slots_;
};

}  // namespace csgsim::facet
