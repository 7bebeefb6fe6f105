#include "host/convex/outside.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <string_view>
#include <utility>

#include "host/convex/clip.h"

namespace csgsim::convex {

namespace {

constexpr std::string_view taking_away = "subtracting solids from convex pieces";

/// Whether the plane contains a face of the common part `both`, and part of `rest` is outside the half-space.
bool is_wall(facet::Halfspace halfspace, const Polytope& both, const Polytope& rest, const facet::PlaneTable& planes) {
  const bool has_face =
      std::any_of(both.faces.begin(), both.faces.end(), [&](const Face& face) { return face.halfspace == halfspace; });
  const facet::Plane plane = outward_plane(halfspace, planes);
  return has_face && std::any_of(rest.vertices.begin(), rest.vertices.end(),
                                 [&](const glm::dvec3& vertex) { return plane.height(vertex) > tolerance(planes); });
}

}  // namespace

std::vector<Polytope> outside(Polytope polytope, const facet::Convex& solid, const facet::PlaneTable& planes,
                              const Work& work) {
  std::vector<Polytope> parts;
  Polytope both = polytope;
  for (const facet::Halfspace& halfspace : solid.halfspaces) {
    work.charge(clip_steps(both), taking_away);
    both = clip(std::move(both), halfspace, planes);
    if (!both.empty()) continue;
    parts.push_back(std::move(polytope));
    return parts;
  }
  Polytope rest = std::move(polytope);
  for (const facet::Halfspace& halfspace : solid.halfspaces) {
    work.charge(both.faces.size() + rest.vertices.size(), taking_away);
    if (!is_wall(halfspace, both, rest, planes)) continue;
    work.charge(2 * clip_steps(rest), taking_away);
    Polytope part = clip(rest, opposite(halfspace), planes);
    if (!part.empty()) parts.push_back(std::move(part));
    rest = clip(std::move(rest), halfspace, planes);
  }
  return parts;
}

}  // namespace csgsim::convex
