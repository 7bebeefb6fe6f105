#include "sim/software/convert/division.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace csgsim::software::convert {

namespace {

/// If at least this number of bodies cut a region, it is halved first, so that cuts do not extend into parts where they
/// are irrelevant.
constexpr std::size_t max_cutting = 6;

std::vector<Known> knowns(const std::vector<Operand>& operands) {
  std::vector<Known> all;
  all.reserve(operands.size());
  for (const Operand& operand : operands) all.push_back(operand.known);
  return all;
}

std::vector<bool> differing(const std::vector<Operand>& operands) {
  std::vector<bool> all;
  all.reserve(operands.size());
  for (const Operand& operand : operands) all.push_back(operand.is_coplanar && !operand.owns);
  return all;
}

constexpr Known outside{true, {false, false}};

std::vector<bool> used_operands(const LocalTree& tree, std::size_t count) {
  std::vector<bool> is_used(count, false);
  for (const LocalTree::Node& node : tree.nodes())
    if (node.kind == LocalTree::Node::Kind::leaf) is_used[node.operand] = true;
  return is_used;
}

/// Removes the operands that no longer affect the result.
void drop_unused(LocalTree& tree, std::vector<Operand>& operands) {
  std::vector<bool> is_kept = used_operands(tree, operands.size());
  for (std::size_t i = 0; i < operands.size(); ++i)
    is_kept[i] = !operands[i].known.is_known && (is_kept[i] || operands[i].owns);
  keep_operands(is_kept, tree, operands);
}

}  // namespace

void keep_operands(const std::vector<bool>& is_kept, LocalTree& tree, std::vector<Operand>& operands) {
  std::vector<std::uint32_t> numbers(operands.size(), 0);
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (!is_kept[i]) continue;
    numbers[i] = kept;
    if (kept != i) operands[kept] = std::move(operands[i]);
    ++kept;
  }
  operands.resize(kept);
  tree.renumber(numbers);
}

Known Division::value_in(const Operand& operand) const {
  if (!operand.is_coplanar) return {true, {true, true}};
  return {true, {operand.is_behind, !operand.is_behind}};
}

/// Whether the region is inside or outside the operand; if neither, stores the planes that intersect the region.
Known Division::look(const Region& region, const Bounds& bounds, Operand& operand) const {
  const Body& body = bodies_.bodies[operand.body];
  if (are_apart(body.box, bounds.box)) return outside;
  Numbers crossing;
  work_.charge(1 + operand.tests.size() / 4, converting);
  for (const std::uint32_t face : operand.tests) {
    const facet::Halfspace halfspace = body.faces[face].halfspace;
    if (halfspace.plane == sheet_.plane()) continue;
    const double out = bodies_.planes.height(halfspace, bounds.middle);
    if (out < -bounds.radius - place_error) continue;
    if (out > bounds.radius + place_error) return outside;
    const Sheet::Sides sides = sheet_.sides(region, halfspace);
    if (!sides.any_in) return outside;
    if (sides.any_out) crossing.push_back(face);
  }
  if (crossing.empty()) return value_in(operand);
  operand.tests = std::move(crossing);
  return {};
}

Division::Fate Division::keep_operands(const Region& region, Fate fate) {
  if (fate != Fate::none) parts_.push_back({region, fate});
  return fate;
}

/// The part of the region inside the operand; operand.tests must hold all relevant planes.
Region Division::section(const Region& region, const Operand& operand) {
  Region part = region;
  for (const std::uint32_t face : operand.tests) {
    work_.charge(part.corners.size(), converting);
    part = sheet_.clip(part, bodies_.bodies[operand.body].faces[face].halfspace);
    if (part.empty()) break;
  }
  return part;
}

Division::Fate Division::divide(const Region& region, const LocalTree& tree, std::vector<Operand> operands) {
  const Bounds bounds = sheet_.bounds(region);
  const std::vector<bool> is_used = used_operands(tree, operands.size());
  std::size_t cutting = 0;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    Operand& operand = operands[i];
    if (operand.known.is_known || !(is_used[i] || operand.owns)) continue;
    Known known = look(region, bounds, operand);
    if (operand.owns && known.is_known && known.value != SideValues{}) return Fate::none;
    operand.known = known;
    if (!known.is_known) ++cutting;
  }
  // Elsewhere, the parts owned by other bodies are outside the operands that own them.
  std::vector<Known> known = knowns(operands);
  for (std::size_t i = 0; i < operands.size(); ++i)
    if (operands[i].owns) known[i] = outside;
  LocalTree left = tree.reduced(known, differing(operands));
  if (left.value().is_known && left.value().value.behind == left.value().value.before) return Fate::none;
  if (!left.value().is_known && !left.may_differ()) return Fate::none;
  drop_unused(left, operands);
  Fate fate = Fate::none;
  if (cutting > max_cutting && halve(region, bounds, left, operands, fate)) return fate;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (!operands[i].owns || operands[i].known.is_known) continue;
    const Region within = section(region, operands[i]);
    if (!within.empty()) return split(region, left, operands, i, within);
    operands[i].known = outside;
  }
  if (left.value().is_known) return keep_operands(region, left.value().value.behind ? Fate::front : Fate::back);
  // The operand nearest to the root may decide most.
  for (std::size_t i = left.nodes().size(); i-- > 0;) {
    const LocalTree::Node& node = left.nodes()[i];
    if (node.kind != LocalTree::Node::Kind::leaf) continue;
    const Region within = section(region, operands[node.operand]);
    if (!within.empty()) return split(region, left, operands, node.operand, within);
    operands[node.operand].known = outside;
    return divide(region, left, std::move(operands));
  }
  return Fate::none;
}

/// Divides the region along the sides of its intersection with an operand.
Division::Fate Division::split(const Region& region, const LocalTree& tree, const std::vector<Operand>& operands,
                               std::size_t by, const Region& section) {
  const std::size_t before = parts_.size();
  std::vector<Operand> operands_there = operands;
  Fate all = Fate::mixed;
  bool is_first = true;
  const auto handle = [&](const Region& part, Known known) {
    operands_there[by].known = known;
    const Fate fate = divide(part, tree, operands_there);
    all = is_first || all == fate ? fate : Fate::mixed;
    is_first = false;
  };
  Region rest = region;
  const Body& body = bodies_.bodies[operands[by].body];
  for (const std::uint32_t face : operands[by].tests) {
    const facet::Halfspace halfspace = body.faces[face].halfspace;
    if (std::ranges::find(section.planes, halfspace.plane) == section.planes.end()) continue;
    work_.charge(rest.corners.size(), converting);
    Parts parts = sheet_.cut(rest, halfspace);
    if (!parts.out.empty()) handle(parts.out, outside);
    rest = std::move(parts.in);
  }
  if (!operands[by].owns) {
    handle(rest, value_in(operands[by]));
  } else {
    all = is_first || all == Fate::none ? Fate::none : Fate::mixed;
  }
  if (all == Fate::mixed || all == Fate::none) return all;
  parts_.resize(before);
  return keep_operands(region, all);
}

/// Divides the region by a wall if each side then has fewer operands; returns whether it did, and sets `fate`.
bool Division::halve(const Region& region, const Bounds& bounds, const LocalTree& tree,
                     const std::vector<Operand>& operands, Fate& fate) {
  const glm::dvec3 size = bounds.box.high - bounds.box.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  std::vector<double> places;
  for (const Operand& operand : operands) {
    if (operand.known.is_known) continue;
    const UnitBox& box = bodies_.bodies[operand.body].box;
    places.push_back((std::max(box.low[axis], bounds.box.low[axis]) + std::min(box.high[axis], bounds.box.high[axis])) /
                     2.0);
  }
  if (places.empty()) return false;
  const auto middle = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
  std::ranges::nth_element(places, middle);
  const std::uint32_t wall = bodies_.planes.wall_near(axis, *middle);
  const double place = bodies_.planes.place_of(wall);
  std::size_t lower = 0;
  std::size_t higher = 0;
  for (const Operand& operand : operands) {
    if (operand.known.is_known) continue;
    const UnitBox& box = bodies_.bodies[operand.body].box;
    if (box.low[axis] <= place) ++lower;
    if (box.high[axis] >= place) ++higher;
  }
  if (4 * std::max(lower, higher) > 3 * places.size()) return false;
  const std::size_t before = parts_.size();
  const Parts parts = sheet_.cut(region, {wall, true});
  if (parts.in.empty() || parts.out.empty()) return false;
  const Fate one = divide(parts.in, tree, operands);
  const Fate other = divide(parts.out, tree, operands);
  fate = one == other ? one : Fate::mixed;
  if (fate == Fate::front || fate == Fate::back) {
    parts_.resize(before);
    keep_operands(region, fate);
  }
  return true;
}

void Division::operator()(std::uint32_t body, const BodyFace& face, const Region& region, const LocalTree& tree,
                          std::vector<Operand> operands) {
  parts_.clear();
  divide(region, tree, std::move(operands));
  const std::span<const BodySide> sides = bodies_.bodies[body].sides_of(face);
  for (const Part& part : parts_)
    found_.push_back(fragment_of(sheet_, part.region, part.fate == Fate::front, body, sides));
}

}  // namespace csgsim::software::convert
