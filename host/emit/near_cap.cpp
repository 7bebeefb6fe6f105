#include "host/emit/near_cap.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <optional>

namespace csgsim::emit {

namespace {

/// Tolerance in pixels of positions in double precision.
constexpr double integer_slack = 1e-6;

using Polygon = std::vector<glm::dvec2>;

Polygon corners(const view::PixelRect& pixels) {
  const glm::dvec2 low{pixels.x0, pixels.y0};
  const glm::dvec2 high{pixels.x1, pixels.y1};
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

/// The part of a convex polygon where `value`, a linear function, is at most 0.
template <class Value>
Polygon clip(const Polygon& polygon, const Value& value) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2& here = polygon[i];
    const glm::dvec2& next = polygon[(i + 1) % polygon.size()];
    const double at_here = value(here);
    const double at_next = value(next);
    if (at_here <= 0) kept.push_back(here);
    if ((at_here <= 0) != (at_next <= 0)) kept.push_back(here + (next - here) * (at_here / (at_here - at_next)));
  }
  return kept;
}

bool has_integer(double low, double high) { return std::ceil(low - integer_slack) <= std::floor(high + integer_slack); }

}  // namespace

bool may_reach_near(const Context& context, const std::vector<Facet>& fronts, const csg::Block& block) {
  if (fronts.empty()) return true;
  if (block.z_low > 0) return false;
  if (!context.options.pruning.near) {
    return std::none_of(fronts.begin(), fronts.end(), [&](const Facet& front) {
      return context.depth_range(front.halfspace, block.pixels).low >= 1;
    });
  }
  Polygon polygon = corners(block.pixels);
  const double step = std::ldexp(1.0, static_cast<int>(context.view.sampling.fraction_bits));
  for (const Facet& front : fronts) {
    const view::FixedLinear& plane = context.linear_plane(front.halfspace);
    const auto a = static_cast<double>(plane.a);
    const auto b = static_cast<double>(plane.b);
    const double beyond = static_cast<double>(plane.c) - step;
    polygon = clip(polygon, [&](const glm::dvec2& place) {
      return a * place.x + b * place.y + beyond - integer_slack * (std::abs(a) + std::abs(b) + step);
    });
  }
  if (polygon.empty()) return false;
  const auto [left, right] =
      std::minmax_element(polygon.begin(), polygon.end(), [](const auto& p, const auto& q) { return p.x < q.x; });
  const auto [top, bottom] =
      std::minmax_element(polygon.begin(), polygon.end(), [](const auto& p, const auto& q) { return p.y < q.y; });
  return has_integer(left->x, right->x) && has_integer(top->y, bottom->y);
}

namespace {

std::optional<facet::Halfspace> first_front(const Context& context, std::uint32_t primitive) {
  const std::vector<facet::Halfspace>& halfspaces = context.geometry.solids[primitive].halfspaces;
  const auto front = std::find_if(halfspaces.begin(), halfspaces.end(), [&](const facet::Halfspace& halfspace) {
    return view::side_of(context.view.planes[halfspace.plane], halfspace) == view::Side::front;
  });
  return front == halfspaces.end() ? std::nullopt : std::optional(*front);
}

}  // namespace

bool is_near_facet(const Context& context, const QuadricBound& bound) {
  return !context.view.extents[bound.primitive].cut_by_near && !first_front(context, bound.primitive) &&
         visible_facet(bound, false).has_value();
}

Facet near_facet(const Context& context, std::uint32_t primitive) {
  for (const QuadricBound& bound : quadric_bounds(context, primitive))
    if (is_near_facet(context, bound)) return *visible_facet(bound, false);
  const std::optional<facet::Halfspace> front = first_front(context, primitive);
  const bool cut = context.view.extents[primitive].cut_by_near || !front;
  return {primitive, cut ? facet::Halfspace{} : *front, cut ? At::cap : At::near};
}

}  // namespace csgsim::emit
