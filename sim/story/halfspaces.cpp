#include "sim/story/halfspaces.h"

#include <glm/geometric.hpp>
#include <utility>

#include "host/csg/positive_tree.h"
#include "host/emit/broadcast.h"
#include "hw/isa/opcodes.h"

namespace csgsim::story {

namespace {

/// The instruction that the host generates from a plane for that region.
isa::Linear broadcast(const view::View& view, const view::ScreenPlane& plane, const isa::Region& region) {
  isa::Segment segment{region, {}, {}};
  emit::Broadcast out(segment, view.sampling);
  const auto x = static_cast<std::int32_t>(region.x);
  const auto y = static_cast<std::int32_t>(region.y);
  const view::PixelRect corner{x, y, x, y};
  if (plane.kind == view::PlaneKind::edge) {
    out.edge(isa::Opcode::edge_negative, plane.linear, corner);
  } else {
    out.surface(isa::Opcode::edge_negative, {}, plane.linear, corner);
  }
  return segment.instructions.front().linear;
}

/// The two instructions that the host generates from a quadric's discriminant for that region.
std::pair<isa::Linear, isa::Linear> broadcast(const view::View& view, const view::ScreenQuadric& quadric,
                                              const isa::Region& region) {
  isa::Segment segment{region, {}, {}};
  emit::Broadcast out(segment, view.sampling);
  const auto x = static_cast<std::int32_t>(region.x);
  const auto y = static_cast<std::int32_t>(region.y);
  out.quadratic(isa::Opcode::edge_not_negative, {}, quadric.discriminant, quadric.discriminant_shift, {x, y, x, y});
  return {segment.instructions[0].linear, segment.instructions[1].linear};
}

/// Compares all but the width, which depends on the pixels.
bool same_plane(const isa::Linear& one, const isa::Linear& other) {
  return one.a == other.a && one.b == other.b && one.c == other.c && one.shift == other.shift;
}

ModelHalfspace in_model(const facet::PlaneTable& table, const facet::Halfspace& halfspace) {
  const facet::Plane& plane = table.planes()[halfspace.plane];
  const double sign = halfspace.positive ? 1 : -1;
  ModelHalfspace found;
  found.normal = sign * plane.normal + 0.0;  // no -0
  found.distance = sign * (glm::dot(plane.normal, table.centre()) - plane.offset) + 0.0;
  return found;
}

}  // namespace

HalfspaceFinder::HalfspaceFinder(const model::Tree& tree, const facet::Geometry& geometry, view::View view)
    : geometry_(geometry),
      view_(std::move(view)),
      sets_(csg::convex_sets(csg::make_positive_tree(tree), true)),
      set_of_(tree.primitives.size()) {
  for (std::size_t set = 0; set < sets_.size(); ++set)
    for (const std::uint32_t primitive : sets_[set]) set_of_[primitive] = set;
}

std::optional<ModelHalfspace> HalfspaceFinder::find_in(std::uint32_t primitive, const isa::Instruction& instruction,
                                                       const isa::Region& region) const {
  const std::vector<facet::Halfspace>& halfspaces = geometry_.solids[primitive].halfspaces;
  for (std::size_t i = 0; i < halfspaces.size(); ++i) {
    const view::ScreenPlane& plane = view_.planes[halfspaces[i].plane];
    if (!plane.representable || !same_plane(broadcast(view_, plane, region), instruction.linear)) continue;
    ModelHalfspace found = in_model(geometry_.planes, halfspaces[i]);
    found.primitive = primitive;
    found.index = i;
    found.count = halfspaces.size();
    return found;
  }
  return std::nullopt;
}

std::optional<ModelQuadric> HalfspaceFinder::find_in(std::uint32_t primitive, const isa::Instruction& squares,
                                                     const isa::Instruction& linear, const isa::Region& region) const {
  const std::vector<facet::QuadricSide>& sides = geometry_.solids[primitive].quadrics;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const view::ScreenQuadric& quadric = view_.quadrics[sides[i].quadric];
    if (quadric.kind == view::ScreenQuadricKind::unfit) continue;
    const auto [terms, rest] = broadcast(view_, quadric, region);
    if (!same_plane(terms, squares.linear) || !same_plane(rest, linear.linear)) continue;
    const facet::Quadric& canonical = geometry_.quadrics.quadrics()[sides[i].quadric];
    const glm::dvec3 axis = canonical.kind == facet::QuadricKind::ellipsoid ? glm::dvec3(0) : canonical.axis;
    return ModelQuadric{
        primitive, i, sides.size(), canonical.kind, canonical.origin + geometry_.quadrics.centre() + 0.0, axis};
  }
  return std::nullopt;
}

/// Applies `find_in` to the primitive of an instruction, then to those that form one convex solid with it. For a
/// comparison only the compared primitive is searched.
template <class FindIn>
auto HalfspaceFinder::find_of(const isa::Origin& origin, const FindIn& find_in) const {
  const bool compares = origin.purpose == isa::Purpose::classify && origin.node != isa::no_node;
  const std::uint32_t primitive = compares ? origin.node : origin.primitive;
  auto found = decltype(find_in(primitive))();
  if (primitive >= set_of_.size()) return found;
  found = find_in(primitive);
  if (compares) return found;
  for (const std::uint32_t other : set_of(primitive)) {
    if (found) break;
    found = find_in(other);
  }
  return found;
}

std::optional<ModelHalfspace> HalfspaceFinder::find(const isa::Instruction& instruction,
                                                    const isa::Region& region) const {
  if (instruction.linear.width == 0) return std::nullopt;
  return find_of(instruction.origin, [&](std::uint32_t primitive) { return find_in(primitive, instruction, region); });
}

std::optional<ModelQuadric> HalfspaceFinder::find(const isa::Instruction& squares, const isa::Instruction& linear,
                                                  const isa::Region& region) const {
  return find_of(linear.origin, [&](std::uint32_t primitive) { return find_in(primitive, squares, linear, region); });
}

}  // namespace csgsim::story
