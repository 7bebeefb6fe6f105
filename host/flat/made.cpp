#include "host/flat/made.h"

#include <cmath>
#include <string>

#include "host/flat/clipping.h"
#include "host/model/degrees.h"
#include "host/model/fragments.h"
#include "hw/base/error.h"

namespace csgsim::flat {

namespace {

bool is_size(double size) { return size > 0 && std::isfinite(size); }

Outline to_outline(std::span<const glm::dvec2> points, const std::vector<std::uint32_t>& path, std::size_t number) {
  Outline outline;
  outline.reserve(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path[i] >= points.size()) {
      throw InputError("paths[" + std::to_string(number) + "][" + std::to_string(i) + "] of polygon() is " +
                       std::to_string(path[i]) + ", but there are " + std::to_string(points.size()) +
                       " points; count them from 0");
    }
    outline.push_back(points[path[i]]);
  }
  return outline;
}

}  // namespace

Area square(const glm::dvec2& size, bool center) {
  if (!is_size(size.x) || !is_size(size.y)) return {};
  const glm::dvec2 low = center ? -size / 2.0 : glm::dvec2(0);
  const glm::dvec2 high = center ? size / 2.0 : size;
  return {{{low, {high.x, low.y}, high, {low.x, high.y}}}};
}

Area circle(double radius, const model::FacetControl& facets) {
  if (!is_size(radius)) return {};
  const std::uint32_t count = model::fragments(radius, facets);
  Outline outline;
  outline.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 360.0 * i / count;
    outline.emplace_back(radius * model::cos_degrees(angle), radius * model::sin_degrees(angle));
  }
  return {{std::move(outline)}};
}

Area polygon(std::span<const glm::dvec2> points, std::span<const std::vector<std::uint32_t>> paths, const Work& work) {
  Area area;
  if (paths.empty()) area.outlines.emplace_back(points.begin(), points.end());
  for (std::size_t i = 0; i < paths.size(); ++i) area.outlines.push_back(to_outline(points, paths[i], i));
  return even_odd_area(to_paths(area), work);
}

}  // namespace csgsim::flat
