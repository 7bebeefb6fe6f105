#include "sim/software/display/facet_sheets.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <span>

namespace csgsim::software {

namespace {

/// End points of a polygon's side in its direction.
using Ends = std::array<double, 6>;

Ends ends_of(const glm::dvec3& from, const glm::dvec3& to) { return {from.x, from.y, from.z, to.x, to.y, to.z}; }

}  // namespace

FacetSheets::FacetSheets(const Facets& facets, const facet::Geometry& geometry)
    : facets_(facets),
      planes_(geometry.planes, geometry.planes.diagonal()),
      sheets_(facets.facets.size(), Sheet(planes_)),
      bounds_(facets.facets.size()) {
  for (std::uint32_t primitive = 0; primitive + 1 < facets.of_primitives.size(); ++primitive)
    find_neighbours(primitive);
}

void FacetSheets::find_neighbours(std::uint32_t primitive) {
  const auto first = static_cast<std::uint32_t>(facets_.of_primitives[primitive]);
  const auto end = static_cast<std::uint32_t>(facets_.of_primitives[primitive + 1]);
  std::map<Ends, facet::Halfspace> beyond;
  for (std::uint32_t i = first; i < end; ++i) {
    const std::span<const glm::dvec3> corners = facets_.corners_of(i);
    for (std::size_t corner = 0; corners.size() >= 3 && corner < corners.size(); ++corner)
      beyond.emplace(ends_of(corners[(corner + 1) % corners.size()], corners[corner]), facets_.facets[i].halfspace);
  }
  for (std::uint32_t i = first; i < end; ++i) {
    const std::span<const glm::dvec3> corners = facets_.corners_of(i);
    if (corners.size() < 3) continue;
    for (std::size_t corner = 0; corner < corners.size(); ++corner) {
      const auto place = beyond.find(ends_of(corners[corner], corners[(corner + 1) % corners.size()]));
      if (place != beyond.end()) bounds_[i].push_back(place->second);
    }
    if (bounds_[i].size() == corners.size()) continue;
    // The neighbour is a duplicate plane that Facets contains only once, so all faces are used.
    bounds_[i].clear();
    for (std::uint32_t other = first; other < end; ++other) {
      if (other != i) bounds_[i].push_back(facets_.facets[other].halfspace);
    }
  }
}

Region FacetSheets::whole(std::uint32_t facet) {
  if (facets_.corners_of(facet).size() < 3) return {};
  Sheet& sheet = sheets_[facet];
  Region region = sheet.begin(plane_of(facet));
  for (const facet::Halfspace& bound : bounds_[facet]) {
    if (region.empty()) break;
    if (bound.plane != sheet.plane()) region = sheet.clip(region, bound);
  }
  return region;
}

bool FacetSheets::cross(std::uint32_t one, const Region& of_one, std::uint32_t other, const Region& of_other) const {
  const std::optional<Chord> on_one = sheets_[one].chord(of_one, plane_of(other));
  if (!on_one) return false;
  const std::optional<Chord> on_other = sheets_[other].chord(of_other, plane_of(one));
  return on_other && overlap(planes_, *on_one, *on_other);
}

std::vector<glm::dvec3> FacetSheets::corner_positions(std::uint32_t facet, const Region& region) const {
  std::vector<glm::dvec3> places;
  places.reserve(region.corners.size());
  for (const std::uint32_t corner : region.corners)
    places.push_back(sheets_[facet].place(corner, 2 * place_error) * planes_.unit());
  if (!facets_.facets[facet].halfspace.positive) std::ranges::reverse(places);
  return places;
}

}  // namespace csgsim::software
