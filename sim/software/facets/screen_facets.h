// Facets of primitives in a picture.
// Used by ray tracing and by the display methods.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "sim/software/facets/facets.h"
#include "sim/software/rays/ray_band.h"
#include "sim/software/rays/span.h"

namespace csgsim::software {

/// A facet in a picture. It covers the pixels at which a ray enters or leaves its primitive through its plane,
/// according to the integers of the machines (docs/numbers.md). If planes of one primitive have equal depth, the first
/// of its half-spaces is used. The events at a pixel are therefore exactly those of the facets that cover it.
struct ScreenFacet {
  static constexpr std::uint32_t near_cap = 0xffffffffU;

  std::uint32_t facet = near_cap;  ///< index into Facets::facets; near_cap if a ray starts inside the primitive
  std::uint32_t primitive = 0;
  bool leaves = false;        ///< whether rays leave the primitive here
  view::FixedLinear depth{};  ///< depth steps with fraction bits
  view::PixelRect pixels{};   ///< non-empty bounding rectangle of the covered pixels
  /// Ranges in ScreenFacets::linears: first the functions that are >= 0 at covered pixels, then the depths of faces on
  /// the opposite side of the primitive that are within a step of this one somewhere, where the primitive may be too
  /// thin.
  std::size_t bounds = 0;
  std::size_t opposites = 0;
  std::size_t end = 0;

  [[nodiscard]] std::uint32_t crossing() const { return 2 * primitive + (leaves ? 1 : 0); }
};

/// All facets of a model in a picture, in the order of Facets; a primitive's near cap precedes its facets.
struct ScreenFacets {
  std::vector<ScreenFacet> facets;
  std::vector<view::FixedLinear> linears;
  std::vector<std::size_t> of_primitives;  ///< index of each primitive's first screen facet, and the end
  unsigned fraction_bits = 0;
  std::uint32_t farthest = 0;  ///< 2^n - 1, the depth where nothing is visible

  [[nodiscard]] std::span<const view::FixedLinear> bounds_of(const ScreenFacet& facet) const {
    return std::span(linears).subspan(facet.bounds, facet.opposites - facet.bounds);
  }
  [[nodiscard]] std::span<const view::FixedLinear> opposites_of(const ScreenFacet& facet) const {
    return std::span(linears).subspan(facet.opposites, facet.end - facet.opposites);
  }

  /// The columns of a row within the bounds of a facet. If the facet has opposites, or its depth leaves the valid
  /// range, event_at() must be called for each of them.
  [[nodiscard]] Span span_of(const ScreenFacet& facet, std::int32_t row) const;
  /// The event at a pixel within the facet's bounds; `value` is its depth with fraction bits. Empty if the primitive is
  /// thinner than a step, or the depth is out of range.
  [[nodiscard]] std::optional<Event> event_at(const ScreenFacet& facet, std::int32_t column, std::int32_t row,
                                              std::int64_t value) const;
  /// Calls use(column, event) from left to right at each pixel of a row that the facet covers. Returns the tested
  /// columns.
  template <class Use>
  Span for_row(const ScreenFacet& facet, std::int32_t row, const Use& use) const {
    const Span span = span_of(facet, row);
    std::int64_t value = value_at(facet.depth, span.first, row);
    for (std::int32_t column = span.first; column <= span.last; ++column, value += facet.depth.a) {
      if (const std::optional<Event> event = event_at(facet, column, row, value)) use(column, *event);
    }
    return span;
  }
  /// The event at any pixel.
  [[nodiscard]] std::optional<Event> event_at(const ScreenFacet& facet, std::int32_t column, std::int32_t row) const;
};

/// Throws InputError, with the primitive's place in the file, if a face exceeds the number range of the machines.
ScreenFacets screen_facets(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view,
                           const Facets& facets);

}  // namespace csgsim::software
