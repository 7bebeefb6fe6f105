#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/facet/coincidence.h"
#include "host/facet/solid.h"

namespace csgsim::facet {

/// One side of a canonical plane: normal . p + offset <= 0 if `positive`, >= 0 if not.
struct Halfspace {
  std::uint32_t plane = 0;  ///< index into PlaneTable::planes()
  bool positive = true;

  bool operator==(const Halfspace&) const = default;
};

/// The planes of a model without repetition: planes that coincide share an entry, whichever primitive or orientation
/// they come from, so that whatever is computed from them is equal exactly. The first plane seen of a kind stands for
/// all.
class PlaneTable {
 public:
  /// Offsets are compared relative to `diagonal`, the size of the model, about `centre`, so that a model far from the
  /// origin loses nothing.
  PlaneTable(const glm::dvec3& centre, double diagonal);

  /// The canonical half-space of a plane in model space.
  Halfspace add(const Plane& plane);

  /// Canonical planes: normals whose first component that is not 0 is positive, offsets relative to `centre()`.
  [[nodiscard]] const std::vector<Plane>& planes() const { return planes_; }
  [[nodiscard]] const glm::dvec3& centre() const { return centre_; }
  [[nodiscard]] double diagonal() const { return diagonal_; }

 private:
  [[nodiscard]] std::optional<std::uint32_t> find(const Plane& canonical) const;
  void enter(std::uint32_t plane);

  glm::dvec3 centre_;
  double diagonal_;
  std::vector<Plane> planes_;
  /// A hash table of planes by the cell of a grid that they are in, with open addressing: its size is a power of
  /// two, and half empty at least.
  std::vector<std::uint32_t> slots_;
};

}  // namespace csgsim::facet
