#pragma once

#include "host/emit/context.h"

namespace csgsim::emit {

/// Colours of a primitive's facets, as the colour field holds them.
class FacetColour {
 public:
  FacetColour(const Context& context, std::uint32_t primitive);

  [[nodiscard]] std::uint32_t of(facet::Halfspace facet) const;

  /// Of what the near plane cuts open.
  [[nodiscard]] std::uint32_t of_cap() const;

 private:
  [[nodiscard]] std::uint32_t shaded(const glm::dvec3& normal) const;

  const Context& context_;
  view::Basis axes_;
  bool complemented_;
  glm::dvec3 colour_;
};

}  // namespace csgsim::emit
