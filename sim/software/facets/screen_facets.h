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

/// A facet in a picture. It covers the pixels at which its plane is what a ray enters its primitive through, or leaves
/// it through, by the integers that machines draw by (docs/numbers.md). Of planes of one primitive that are level the
/// first of its half-spaces is the one. So the events at a pixel are those of the facets that cover it.
struct ScreenFacet {
  static constexpr std::uint32_t near_cap = 0xffffffffU;

  std::uint32_t facet = near_cap;  ///< index into Facets::facets; near_cap where a ray begins in the primitive
  std::uint32_t primitive = 0;
  bool leaves = false;        ///< rays leave the primitive here
  view::FixedLinear depth{};  ///< depth steps with fraction bits
  view::PixelRect pixels{};   ///< that hold those it covers; not empty
  /// Of what ScreenFacets::linears has of it: first functions that are at least 0 where it covers, then the depths of
  /// faces on the other side of the primitive that are within a step of it somewhere: there it depends on whether
  /// anything is left between them.
  std::size_t bounds = 0;
  std::size_t opposites = 0;
  std::size_t end = 0;

  [[nodiscard]] std::uint32_t crossing() const { return 2 * primitive + (leaves ? 1 : 0); }
};

/// All facets of a model in a picture, in the order of Facets, a primitive's near cap before its facets.
struct ScreenFacets {
  std::vector<ScreenFacet> facets;
  std::vector<view::FixedLinear> linears;
  std::vector<std::size_t> of_primitives;  ///< of each primitive its first facet here, and of the one after the last
  unsigned fraction_bits = 0;
  std::uint32_t farthest = 0;  ///< 2^n - 1, where nothing is seen

  [[nodiscard]] std::span<const view::FixedLinear> bounds_of(const ScreenFacet& facet) const {
    return std::span(linears).subspan(facet.bounds, facet.opposites - facet.bounds);
  }
  [[nodiscard]] std::span<const view::FixedLinear> opposites_of(const ScreenFacet& facet) const {
    return std::span(linears).subspan(facet.opposites, facet.end - facet.opposites);
  }

  /// The columns of a row within the bounds of a facet. Of a facet with opposites, and of one whose depth leaves the
  /// range of depths, event_at() has to be asked at each of them still.
  [[nodiscard]] Span span_of(const ScreenFacet& facet, std::int32_t row) const;
  /// The event at a pixel within the facet's bounds; `value` is its depth there, with fraction bits. Nothing where the
  /// primitive is thinner than a step, or outside the range of depths.
  [[nodiscard]] std::optional<Event> event_at(const ScreenFacet& facet, std::int32_t column, std::int32_t row,
                                              std::int64_t value) const;
  /// Calls use(column, event) at each pixel of a row that the facet covers, from the left. Returns the columns that
  /// were looked at.
  template <class Use>
  Span for_row(const ScreenFacet& facet, std::int32_t row, const Use& use) const {
    const Span span = span_of(facet, row);
    std::int64_t value = value_at(facet.depth, span.first, row);
    for (std::int32_t column = span.first; column <= span.last; ++column, value += facet.depth.a) {
      if (const std::optional<Event> event = event_at(facet, column, row, value)) use(column, *event);
    }
    return span;
  }
  /// The same at any pixel.
  [[nodiscard]] std::optional<Event> event_at(const ScreenFacet& facet, std::int32_t column, std::int32_t row) const;
};

/// Throws InputError, naming its place in the file, for a face that does not fit the numbers of machines.
ScreenFacets screen_facets(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view,
                           const Facets& facets);

}  // namespace csgsim::software
