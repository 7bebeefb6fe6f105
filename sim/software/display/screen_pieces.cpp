#include "sim/software/display/screen_pieces.h"

#include <algorithm>
#include <cstddef>

#include "host/view/region.h"
#include "hw/base/error.h"

namespace csgsim::software {

namespace {

using view::FixedLinear;

/// Creates pieces from facets and their cuts.
class PieceMaker {
 public:
  PieceMaker(const Polygons& polygons, const ScreenFacets& seen, const facet::Geometry& geometry,
             const view::View& view)
      : polygons_(polygons), seen_(seen), centre_(geometry.planes.centre()), view_(view) {
    for (const ScreenFacet& facet : seen.facets) {
      if (facet.facet == ScreenFacet::near_cap) continue;
      if (facet.facet >= seen_of_.size()) seen_of_.resize(facet.facet + 1, nullptr);
      seen_of_[facet.facet] = &facet;
    }
    for (const facet::Plane& wall : polygons.walls) walls_.push_back(view::screen_plane(view, wall, centre_));
    made_.pieces.fraction_bits = seen.fraction_bits;
    made_.pieces.farthest = seen.farthest;
  }

  void begin_cell() { made_.begins.push_back(static_cast<std::uint32_t>(made_.pieces.facets.size())); }

  void add(const Piece& piece) {
    const ScreenFacet* const facet = piece.facet < seen_of_.size() ? seen_of_[piece.facet] : nullptr;
    if (facet == nullptr) return;
    std::vector<FixedLinear>& linears = made_.pieces.linears;
    ScreenFacet made = *facet;
    made.bounds = linears.size();
    view::Region region(facet->pixels);
    for (const FixedLinear& bound : seen_.bounds_of(*facet)) {
      region.clip(bound);
      linears.push_back(bound);
    }
    for (const Cut& cut : piece.cuts) {
      const FixedLinear bound = bound_of(made.depth, cut);
      if (!region.clip(bound)) linears.push_back(bound);
    }
    made.pixels = region.empty() ? view::PixelRect{} : view::common(region.pixels(), facet->pixels);
    if (made.pixels.empty()) {
      linears.resize(made.bounds);
      return;
    }
    // A constraint that is positive throughout a convex region does not bound it.
    const auto first = linears.begin() + static_cast<std::ptrdiff_t>(made.bounds);
    const auto is_slack = [&](const FixedLinear& bound) { return region.is_certainly_at_least(bound, 1); };
    linears.erase(std::remove_if(first, linears.end(), is_slack), linears.end());
    made.opposites = linears.size();
    for (const FixedLinear& opposite : seen_.opposites_of(*facet)) linears.push_back(opposite);
    made.end = linears.size();
    made_.pieces.facets.push_back(made);
  }

  ScreenPieces release() {
    begin_cell();
    return std::move(made_);
  }

 private:
  /// A function that is >= 0 on the piece's side of the cut.
  [[nodiscard]] FixedLinear bound_of(const FixedLinear& depth, const Cut& cut) const {
    const bool is_wall = cut.plane >= polygons_.canonical_planes;
    const view::ScreenPlane& plane = is_wall ? walls_[cut.plane - polygons_.canonical_planes] : view_.planes[cut.plane];
    if (!plane.representable) {
      throw InputError(
          "a plane that clips polygons is too large for the picture: its coefficients exceed the number range of "
          "the machines; move the camera back, or reduce --z-bits or --fraction-bits");
    }
    const FixedLinear& at = plane.linear;
    switch (view::side_of(plane, cut.positive)) {
      case view::Side::front: return view::difference(depth, at);
      case view::Side::back: return view::difference(at, depth, -1);
      case view::Side::edge_positive: return at;
      case view::Side::edge_negative: return {-at.a, -at.b, -at.c - 1};
    }
    return at;
  }

  const Polygons& polygons_;
  const ScreenFacets& seen_;
  glm::dvec3 centre_;
  const view::View& view_;
  std::vector<const ScreenFacet*> seen_of_;  ///< indexed by facet; nullptr if it is not in the picture
  std::vector<view::ScreenPlane> walls_;
  ScreenPieces made_;
};

}  // namespace

ScreenPieces screen_pieces(const Polygons& polygons, std::span<const std::uint32_t> cells, const ScreenFacets& seen,
                           const facet::Geometry& geometry, const view::View& view) {
  PieceMaker maker(polygons, seen, geometry, view);
  for (const std::uint32_t cell : cells) {
    maker.begin_cell();
    for (const Piece& piece : polygons.cells[cell].bucket) maker.add(piece);
  }
  return maker.release();
}

}  // namespace csgsim::software
