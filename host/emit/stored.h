// Depths of primitives that are stored while a segment is drawn.
// Used by the strategy stored, comparison.cpp and drawing.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/emit/surface.h"

namespace csgsim::emit {

/// The fields of a primitive's depths. Its solid is at depths d with `front` <= d < `back`; at pixels without the
/// solid, `front` is the farthest depth and `back` the nearest.
struct StoredFields {
  isa::Field front;
  isa::Field back;
};

/// The primitives whose depths are stored while a drawing's surfaces are drawn in a segment.
class StoredDepths {
 public:
  explicit StoredDepths(const Context& context);

  [[nodiscard]] const std::vector<std::uint32_t>& primitives() const { return primitives_; }
  /// Empty for a primitive whose depths are not stored.
  [[nodiscard]] std::optional<StoredFields> of(std::uint32_t primitive) const;

 private:
  std::vector<std::uint32_t> primitives_;  ///< ascending
  const Layout& layout_;
};

/// Writes the depths of all primitives for which the context stores depths.
void emit_stored_depths(const Context& context, Broadcast& out);

/// E := E and "Z1 is in the primitive", by its stored depths, as far as they matter where the surface can be.
void emit_stored_comparison(const Context& context, Broadcast& out, std::uint32_t primitive, const StoredFields& fields,
                            const PlannedSurface& surface);

}  // namespace csgsim::emit
