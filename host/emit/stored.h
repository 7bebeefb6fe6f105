#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/emit/surface.h"

namespace csgsim::emit {

/// Where a primitive's depths are kept. Its solid is at depths from `front` to before `back`; at pixels where it is at
/// none, `front` is the farthest depth and `back` the nearest.
struct StoredFields {
  isa::Field front;
  isa::Field back;
};

/// Whose depths are kept while a drawing's surfaces are drawn in a segment.
class StoredDepths {
 public:
  explicit StoredDepths(const Context& context);

  [[nodiscard]] const std::vector<std::uint32_t>& primitives() const { return primitives_; }
  /// Nothing for a primitive whose depths are not kept.
  [[nodiscard]] std::optional<StoredFields> of(std::uint32_t primitive) const;

 private:
  std::vector<std::uint32_t> primitives_;  ///< ascending
  const Layout& layout_;
};

/// The depths of all that the context keeps depths of, into their fields.
void emit_stored_depths(const Context& context, Broadcast& out);

/// E := E and "Z1 is in the primitive", whose depths are in the fields, by what of it matters where the surface can be.
void emit_stored_comparison(const Context& context, Broadcast& out, std::uint32_t primitive, const StoredFields& fields,
                            const PlannedSurface& of);

}  // namespace csgsim::emit
