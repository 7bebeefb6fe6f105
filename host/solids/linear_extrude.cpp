#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "host/flat/parts.h"
#include "host/model/hypotenuse.h"
#include "host/solids/bent_slices.h"
#include "host/solids/extrusion.h"
#include "host/solids/side_lines.h"

namespace csgsim::solids {

namespace {

/// The lower and upper ends of a frustum.
struct Ends {
  double low = 0;
  double high = 0;
  double scale = 1;  ///< scale of the upper end
};

/// The plane through a line in the lower end and the scaled line in the upper end.
glm::dvec4 side_plane(const glm::dvec3& line, const Ends& ends) {
  const double slope = -line.z * (1.0 - ends.scale) / (ends.high - ends.low);
  const double length = model::hypotenuse(1.0, slope);
  return glm::dvec4(line.x, line.y, slope, line.z - slope * ends.low) / length;
}

model::Polyhedron frustum(const flat::Outline& part, const Ends& ends, SideLines& lines) {
  const auto count = static_cast<std::uint32_t>(part.size());
  const bool is_pyramid = ends.scale == 0.0;
  model::Polyhedron piece;
  std::vector<std::uint32_t> bottom(count);
  std::vector<std::uint32_t> top(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    bottom[i] = i;
    top[i] = is_pyramid ? count : count + i;
    piece.points.emplace_back(part[i], ends.low);
  }
  if (is_pyramid) piece.points.emplace_back(0, 0, ends.high);
  for (std::uint32_t i = 0; i < count && !is_pyramid; ++i) piece.points.emplace_back(ends.scale * part[i], ends.high);
  piece.faces.emplace_back(bottom.rbegin(), bottom.rend());
  piece.planes.emplace_back(0, 0, -1, ends.low);
  if (!is_pyramid) {
    piece.faces.push_back(top);
    piece.planes.emplace_back(0, 0, 1, -ends.high);
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    piece.faces.push_back({bottom[i], bottom[next], top[next]});
    if (!is_pyramid) piece.faces.back().push_back(top[i]);
    piece.planes.push_back(side_plane(lines(part[i], part[next]), ends));
  }
  return piece;
}

/// Clamps the scale to 0 and above; empty if the extrusion is empty.
std::optional<LinearExtrude> normalized(const flat::Area& area, LinearExtrude extrusion) {
  extrusion.scale = glm::max(extrusion.scale, glm::dvec2(0));
  if (area.empty() || !(extrusion.height > 0.0)) return std::nullopt;
  return extrusion;
}

bool is_straight(const LinearExtrude& extrusion) {
  return extrusion.twist == 0.0 && extrusion.scale.x == extrusion.scale.y;
}

Ends make_ends(const LinearExtrude& extrusion) {
  const double low = extrusion.center ? -extrusion.height / 2.0 : 0.0;
  return {low, extrusion.center ? extrusion.height / 2.0 : extrusion.height, extrusion.scale.x};
}

/// The outline as a counter-clockwise convex polygon; empty if it is not convex.
std::optional<flat::Outline> as_convex(flat::Outline outline, bool is_hole) {
  if (is_hole) std::reverse(outline.begin(), outline.end());
  std::vector<flat::Outline> parts = flat::convex_parts({{std::move(outline)}});
  if (parts.size() != 1) return std::nullopt;
  return std::move(parts.front());
}

/// The outer outline, then the holes. Empty unless there is exactly one outer outline, at least one hole, and all are
/// convex.
std::vector<flat::Outline> convex_outlines(const flat::Area& area) {
  std::vector<flat::Outline> found;
  std::size_t outer = 0;
  for (const flat::Outline& outline : area.outlines) {
    const bool is_hole = signed_area(outline) < 0.0;
    std::optional<flat::Outline> convex = as_convex(outline, is_hole);
    if (!convex || (!is_hole && ++outer > 1)) return {};
    found.insert(is_hole ? found.end() : found.begin(), *std::move(convex));
  }
  return outer == 1 && found.size() > 1 ? found : std::vector<flat::Outline>{};
}

/// Number of half-spaces of prisms over the outlines.
std::size_t halfspaces_over(const std::vector<flat::Outline>& outlines) {
  std::size_t count = 0;
  for (const flat::Outline& outline : outlines) count += outline.size() + 2;
  return count;
}

}  // namespace

std::vector<model::Polyhedron> linear_extrude(const flat::Area& area, const LinearExtrude& extrusion,
                                              const Work& work) {
  const std::optional<LinearExtrude> made = normalized(area, extrusion);
  if (!made) return {};
  if (!is_straight(*made)) return extrude_bent(area, *made, work);
  std::vector<model::Polyhedron> pieces;
  SideLines lines(area);
  for (const flat::Outline& part : flat::convex_parts(area)) pieces.push_back(frustum(part, make_ends(*made), lines));
  return pieces;
}

std::optional<HoledPrism> make_holed_prism(const flat::Area& area, const LinearExtrude& extrusion) {
  const std::optional<LinearExtrude> made = normalized(area, extrusion);
  if (!made || area.outlines.size() < 2 || !is_straight(*made)) return std::nullopt;
  const std::vector<flat::Outline> outlines = convex_outlines(area);
  if (outlines.empty() || 2 * halfspaces_over(outlines) > halfspaces_over(flat::convex_parts(area)))
    return std::nullopt;
  SideLines lines(area);
  HoledPrism prism{frustum(outlines.front(), make_ends(*made), lines), {}};
  for (std::size_t i = 1; i < outlines.size(); ++i) {
    prism.holes.push_back(frustum(outlines[i], make_ends(*made), lines));
  }
  return prism;
}

}  // namespace csgsim::solids
