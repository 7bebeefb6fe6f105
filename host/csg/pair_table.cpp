#include "host/csg/pair_table.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

namespace csgsim::csg {

namespace {

/// Steps of a usual search, for estimating its price.
constexpr double usual_steps = 8;

std::uint64_t key_of(std::uint32_t one, std::uint32_t other) {
  constexpr unsigned index_bits = 32;
  return std::uint64_t{std::min(one, other)} << index_bits | std::max(one, other);
}

glm::dvec3 centre(const Hull& hull) { return hull.low() + (hull.high() - hull.low()) / 2.0; }

}  // namespace

void PairTable::begin_frame() {
  work_ = {};
  is_in_first_frame_ = false;
}

PairTable::Solid& PairTable::solid(std::uint32_t primitive) {
  const auto [found, is_new] = solids_.try_emplace(primitive, Solid{Hull(geometry_.solids[primitive].vertices)});
  Solid& solid = found->second;
  if (!is_new) return solid;
  work_.supports += solid.hull.points().size();
  for (const glm::dvec3& point : solid.hull.points())
    solid.radius = std::max(solid.radius, glm::distance(point, centre(solid.hull)));
  return solid;
}

std::optional<Gap> PairTable::between_spheres(const Solid& one, const Solid& other) const {
  const double half = (glm::distance(centre(one.hull), centre(other.hull)) - one.radius - other.radius) / 2;
  if (!(half > 0)) return std::nullopt;
  return Gap{half, half + 2 * one.radius, half + 2 * other.radius};
}

std::optional<Gap> PairTable::search(std::uint32_t one, std::uint32_t other) {
  Solid& first = solid(one);
  Solid& second = solid(other);
  if (first.hull.points().empty() || second.hull.points().empty()) return std::nullopt;
  ++work_.supports;
  if (const std::optional<Gap> gap = between_spheres(first, second); gap && gap->is_wide()) return gap;
  return find_gap(first.hull, second.hull, Counted(work_));
}

bool PairTable::are_apart(std::uint32_t one, std::uint32_t other, const view::View& view, const Counted& counted) {
  const auto [first, second] = std::minmax(one, other);
  const auto [found, is_new] = results_.try_emplace(key_of(one, other));
  if (is_new) found->second.gap = search(first, second);
  found->second.program = program_;
  const std::optional<Gap>& gap = found->second.gap;
  if (!gap) return false;
  counted.add(&isa::Preparation::supports);
  return gap->half > view.extents[first].looseness * gap->far_first &&
         gap->half > view.extents[second].looseness * gap->far_second;
}

double PairTable::price(std::uint32_t one, std::uint32_t other, const Prices& prices) const {
  const auto found = results_.find(key_of(one, other));
  if (found != results_.end() && found->second.program == program_) return found->second.gap ? prices.support : 0;
  const auto points = [&](std::uint32_t primitive) {
    return static_cast<double>(geometry_.solids[primitive].vertices.size());
  };
  return usual_steps * (points(one) + points(other)) * prices.support;
}

}  // namespace csgsim::csg
