#include "sim/observe/primitive_costs.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <tuple>

#include "hw/base/text.h"
#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/isa/pieces.h"

namespace csgsim::observe {

namespace {

/// A half-space or quadric in picture coordinates, independent of a segment's origin: the rank of its primitive among
/// the most expensive, the coefficients of x^2, x*y, y^2, x, y and 1, and the shift.
using PictureSurface = std::tuple<std::uint32_t, std::array<std::uint64_t, 6>, std::uint16_t>;

/// The surface with coefficients relative to the picture's origin. They may wrap around, alike in every segment.
PictureSurface in_picture(std::uint32_t place, const isa::Linear& squares, const isa::Linear& linear,
                          const isa::Region& region) {
  const auto number = [](std::int64_t value) { return static_cast<std::uint64_t>(value); };
  const std::uint64_t xx = number(squares.a);
  const std::uint64_t xy = number(squares.b);
  const std::uint64_t yy = number(squares.c);
  const std::uint64_t x = region.x;
  const std::uint64_t y = region.y;
  const std::uint64_t a = number(linear.a);
  const std::uint64_t b = number(linear.b);
  const std::uint64_t c = number(linear.c) - a * x - b * y + (xx * x + xy * y) * x + yy * y * y;
  return {place, {xx, xy, yy, a - 2 * xx * x - xy * y, b - xy * x - 2 * yy * y, c}, linear.shift};
}

/// Whether the expression is a side of the rectangle of pixels to which a surface is clipped first, or equals one.
bool is_pixel_edge(const isa::Linear& linear) {
  return linear.shift == 0 && std::abs(linear.a) + std::abs(linear.b) == 1;
}

/// Whether the instruction scan-converts a half-space of a drawn surface or, with the squares before it, a quadric. An
/// expression that a root is added to or subtracted from also belongs to the quadric.
bool is_halfspace(const isa::Instruction& one) {
  const isa::Origin& origin = one.origin;
  const bool is_other = one.opcode == isa::Opcode::squares || one.opcode == isa::Opcode::linear_plus ||
                        one.opcode == isa::Opcode::linear_minus;
  return one.linear.width > 0 && !is_other && origin.purpose == isa::Purpose::render &&
         origin.primitive != isa::no_primitive && origin.effect == isa::no_effect;
}

constexpr std::uint32_t not_listed = ~std::uint32_t{0};

/// Rank of each primitive among the most expensive.
std::vector<std::uint32_t> expense_ranks(const std::vector<PrimitiveCost>& most_expensive, std::size_t primitives) {
  std::vector<std::uint32_t> places(primitives, not_listed);
  for (std::uint32_t i = 0; i < most_expensive.size(); ++i) places[most_expensive[i].primitive] = i;
  return places;
}

/// Counts each half-space once, no matter how many segments and pieces have it.
void count_halfspaces(const isa::Program& program, std::vector<PrimitiveCost>& most_expensive) {
  const std::vector<std::uint32_t> places = expense_ranks(most_expensive, program.facts->primitives.size());
  std::vector<PictureSurface> found;
  for (const isa::Segment& segment : program.segments) {
    for (std::size_t i = 0; i < segment.instructions.size(); ++i) {
      const isa::Instruction& one = segment.instructions[i];
      const isa::Instruction* const squares = isa::pending_squares(segment, i);
      if (!is_halfspace(one) || (squares == nullptr && is_pixel_edge(one.linear))) continue;
      const std::uint32_t place = places[isa::primitive_of(*program.facts, one.origin.primitive)];
      if (place != not_listed)
        found.push_back(
            in_picture(place, squares == nullptr ? isa::Linear{} : squares->linear, one.linear, segment.region));
    }
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  for (const PictureSurface& one : found) ++most_expensive[std::get<0>(one)].halfspaces;
}

std::vector<std::uint32_t> by_clocks(const std::vector<Cost>& costs) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < costs.size(); ++i)
    if (costs[i].clocks > 0) order.push_back(i);
  std::ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) { return costs[a].clocks > costs[b].clocks; });
  return order;
}

std::uint64_t sum_of(const std::vector<Cost>& costs) {
  return std::accumulate(costs.begin(), costs.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const Cost& cost) { return sum + cost.clocks; });
}

std::vector<EffectCost> effects_of(const isa::Program& program, const Stats& stats) {
  std::vector<EffectCost> effects;
  const std::vector<std::string>& names = program.facts->compile.effects;
  for (std::size_t i = 1; i < names.size(); ++i) {
    if (stats.by_effect[i].clocks > 0) effects.push_back({printable(names[i]), stats.by_effect[i].clocks});
  }
  return effects;
}

}  // namespace

std::string source_position(const std::string& primitive_name) {
  const std::size_t at = primitive_name.rfind('@');
  return at == std::string::npos ? "" : primitive_name.substr(at + 1);
}

ClockShares clock_shares(const isa::Program& program, const engine::RunResult& result, const Stats& stats) {
  ClockShares shares;
  shares.whole = stats.total.clocks + result.latency_clocks;
  const std::vector<Cost>& costs = stats.plain_by_primitive;
  const std::vector<std::uint32_t> order = by_clocks(costs);
  const std::size_t shown = std::min(order.size(), max_listed_primitives);
  for (std::size_t i = 0; i < shown; ++i) {
    const std::uint32_t index = order[i];
    const std::string name = printable(program.facts->primitives[index]);
    shares.most_expensive.push_back({index, name, source_position(name), costs[index].clocks,
                                     static_cast<double>(costs[index].clocks) / static_cast<double>(shares.whole),
                                     isa::pieces_of(*program.facts, index).count, 0});
  }
  count_halfspaces(program, shares.most_expensive);
  shares.other_primitives = order.size() - shown;
  for (std::size_t i = shown; i < order.size(); ++i) shares.other_clocks += costs[order[i]].clocks;
  shares.effects = effects_of(program, stats);
  shares.rest = shares.whole - sum_of(costs);
  for (const EffectCost& effect : shares.effects) shares.rest -= effect.clocks;
  return shares;
}

std::vector<std::uint64_t> visible_pixel_counts(const Frame& frame, const isa::Program& program) {
  std::vector<std::uint64_t> pixels(program.facts->primitives.size());
  for (const std::uint32_t piece : frame.owner) {
    if (piece == no_owner) continue;
    const std::uint32_t primitive = isa::primitive_of(*program.facts, piece);
    if (primitive < pixels.size()) ++pixels[primitive];
  }
  return pixels;
}

}  // namespace csgsim::observe
