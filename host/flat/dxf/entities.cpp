#include "host/flat/dxf/entities.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>

#include "host/model/degrees.h"
#include "host/model/fragments.h"
#include "host/model/hypotenuse.h"
#include "hw/base/error.h"

namespace csgsim::flat::dxf {

namespace {

constexpr double full_turn = 360;
constexpr double full_turn_in_radians = 2 * std::numbers::pi;

/// Maximum number of turns of an arc.
constexpr double max_turns = 2;

/// Maximum magnitude of an angle.
constexpr double max_degrees = 1e6;

/// Angle from `start` to `stop`, with whole turns added if `stop` is less than `start`.
double sweep(double start, double stop, double turn) {
  const double most = max_degrees * turn / full_turn;
  const double angle = stop < start ? stop - start + turn * std::ceil((start - stop) / turn) : stop - start;
  if (!(std::abs(start) <= most) || !(angle <= max_turns * turn)) {
    throw InputError("an arc exceeds two turns, or starts beyond a million degrees; correct its angles");
  }
  return angle;
}

/// The number of a circle's fragments that an arc covers.
std::uint32_t steps(double radius, double sweep, double turn, const model::FacetControl& facets) {
  return static_cast<std::uint32_t>(std::ceil(model::fragments(radius, facets) * sweep / turn));
}

void draw_line(const Entity& entity, const model::FacetControl& /*facets*/, const Draw& draw_segment) {
  draw_segment({point(entity, 0), point(entity, 1)});
}

void draw_polyline(const Entity& entity, const model::FacetControl& /*facets*/, const Draw& draw_segment) {
  const std::size_t count = std::max(entity.xs.size(), entity.ys.size());
  for (std::size_t i = 1; i < count; ++i) draw_segment({point(entity, i - 1), point(entity, i)});
  const bool closed = (entity.flags & 1) != 0;
  if (closed && count > 0) draw_segment({point(entity, count - 1), point(entity, 0)});
}

/// Draws a part of a circle, starting at the angle `from`, in `count` steps.
void draw_part(const Entity& entity, double from, double degrees, std::uint32_t count, const Draw& draw_segment) {
  const glm::dvec2 centre = point(entity, 0);
  const auto corner = [&](std::uint32_t i) {
    const double angle = from + degrees * i / count;
    return entity.size * glm::dvec2(model::cos_degrees(angle), model::sin_degrees(angle)) + centre;
  };
  for (std::uint32_t i = 0; i < count; ++i) draw_segment({corner(i), corner(i + 1)});
}

void draw_circle(const Entity& entity, const model::FacetControl& facets, const Draw& draw_segment) {
  draw_part(entity, 0, full_turn, model::fragments(entity.size, facets), draw_segment);
}

void draw_arc(const Entity& entity, const model::FacetControl& facets, const Draw& draw_segment) {
  const double degrees = sweep(entity.start, entity.stop, full_turn);
  draw_part(entity, entity.start, degrees, steps(entity.size, degrees, full_turn, facets), draw_segment);
}

/// As in OpenSCAD, the end of the major axis, although a vector, is translated and scaled like a point, and the ratio
/// of the radii is scaled too.
void draw_ellipse(const Entity& entity, const model::FacetControl& facets, const Draw& draw_segment) {
  const glm::dvec2 centre = point(entity, 0);
  const glm::dvec2 major = point(entity, 1);
  const glm::dvec2 minor = entity.size * glm::dvec2(-major.y, major.x);
  const double angle = sweep(entity.first, entity.second, full_turn_in_radians);
  const std::uint32_t count = steps(model::hypotenuse(major.x, major.y), angle, full_turn_in_radians, facets);
  const auto corner = [&](std::uint32_t i) {
    const double at = entity.first + angle * i / count;
    return centre + major * std::cos(at) + minor * std::sin(at);
  };
  for (std::uint32_t i = 0; i < count; ++i) draw_segment({corner(i), corner(i + 1)});
}

using Function = void (*)(const Entity&, const model::FacetControl&, const Draw&);

const std::map<std::string, Function>& functions() {
  static const std::map<std::string, Function> table{{"ARC", draw_arc},
                                                     {"CIRCLE", draw_circle},
                                                     {"ELLIPSE", draw_ellipse},
                                                     {"LINE", draw_line},
                                                     {"LWPOLYLINE", draw_polyline}};
  return table;
}

}  // namespace

glm::dvec2 point(const Entity& entity, std::size_t index) {
  if (index >= entity.xs.size() || index >= entity.ys.size()) {
    throw InputError("a " + entity.type + " lacks a point (groups 10, 20 or 11, 21); add it");
  }
  return {entity.xs[index], entity.ys[index]};
}

bool is_drawn(const std::string& type) { return functions().contains(type); }

void draw(const Entity& entity, const model::FacetControl& facets, const Draw& draw_segment) {
  functions().at(entity.type)(entity, facets, draw_segment);
}

}  // namespace csgsim::flat::dxf
