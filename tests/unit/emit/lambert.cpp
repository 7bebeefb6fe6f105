#include "tests/unit/emit/lambert.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "hw/isa/colour_format.h"
#include "hw/isa/depth_scale.h"
#include "tests/support/drawing.h"

namespace csgsim::testing {

namespace {

/// Factors of the two causes of the cosine's error, its unit and a depth step; see law().
constexpr double unit_part = 1.3;
constexpr double step_part = 1.6;

/// Intersection of a pixel's ray with the solid.
struct Place {
  glm::dvec3 normal;  ///< in eye axes
  double to_cap;      ///< distance along the ray to the plane of a cylinder's end
};

/// Empty if the ray misses the sphere or the curved side.
std::optional<Place> place_at(const Solid& solid, const view::EyeSpace& space, double x, double y) {
  const glm::dmat3 back = glm::transpose(solid.axes);
  const glm::dvec3 origin = back * (space.to_model(space.from_picture({x, y, 0})) - solid.at);
  const glm::dvec3 along = back * space.axes.forward;
  const bool is_round = solid.height > 0;
  const glm::dvec3 across = is_round ? glm::dvec3(along.x, along.y, 0) : along;
  const glm::dvec3 from = is_round ? glm::dvec3(origin.x, origin.y, 0) : origin;
  const double a = glm::dot(across, across);
  const double b = glm::dot(across, from);
  const double d = b * b - a * (glm::dot(from, from) - solid.radius * solid.radius);
  if (!(d > 0) || !(a > 1e-3)) return std::nullopt;
  const double t = (-b - std::sqrt(d)) / a;
  const double to_end = solid.height / 2 - std::abs(origin.z + t * along.z);
  if (is_round && to_end < 0) return std::nullopt;
  const glm::dvec3 normal = solid.axes * ((from + across * t) / solid.radius);
  return Place{
      {glm::dot(normal, space.axes.right), glm::dot(normal, space.axes.up), glm::dot(normal, space.axes.forward)},
      is_round ? to_end / std::abs(along.z) : std::numeric_limits<double>::infinity()};
}

/// The normal, or empty if the point is so close to the outline or a rim that rounding decides what is visible. Near a
/// rim the curved side and the end plane reach the same depth step: each is off by less than a step and a half.
std::optional<glm::dvec3> normal_at(const Solid& solid, const view::EyeSpace& space, double steps, double x, double y) {
  constexpr std::array<std::array<double, 2>, 4> around{{{0.75, 0}, {-0.75, 0}, {0, 0.75}, {0, -0.75}}};
  const auto place = place_at(solid, space, x, y);
  if (!place || place->to_cap * steps < 3) return std::nullopt;
  const bool is_inside = std::all_of(around.begin(), around.end(), [&](const auto& by) {
    return place_at(solid, space, x + by[0], y + by[1]).has_value();
  });
  return is_inside ? std::optional(place->normal) : std::nullopt;
}

struct Law {
  double level;    ///< level of the channel
  double slack;    ///< tolerance in levels
  bool is_bright;  ///< every light contributes at least 0.2 of its maximum
};

/// Depth steps per unit of length.
double steps_of(const Case& one, const view::View& view) {
  return isa::depth_steps(one.z_bits) / (view.depth.far - view.depth.near);
}

/// Tolerance: half a level for the ambient light. Each light adds half a level for its digits, half for truncating the
/// sum and half for truncating its parts, doubled if it is so bright that it is added in two parts; and an error of the
/// cosine with a unit of at most 1 / 2^width, or of a depth step if that is larger. Depth is off by one step and its
/// two floors by half a unit each, or by one floor if the unit is a step; rounded coefficients add a tenth of a unit
/// over 48 pixels. Depth terms below two units are omitted: one unit, and half a unit at half the size.
Law law(const Case& one, double steps, const glm::dvec3& normal, int channel, unsigned widest) {
  const unsigned width = isa::channel_widths(one.colour_bits).at(static_cast<std::size_t>(channel));
  const double top = std::exp2(width) - 1;
  const glm::dvec3 colour = one.colour.value_or(glm::dvec3(0.976, 0.843, 0.173));
  double sum = colour[channel] * one.ambient;
  double slack = 0.5;
  bool is_bright = true;
  for (const scene::Light& light : one.lights) {
    const double cosine = glm::dot(-glm::normalize(light.direction), normal);
    is_bright = is_bright && cosine > 0.2;
    const double brightness = colour[channel] * light.colour[channel] * light.intensity;
    if (brightness == 0) continue;
    sum += brightness * std::max(0.0, cosine);
    const double parts = brightness > 5.5 ? 2 : 1;
    const double unit = std::exp2(-static_cast<double>(widest));
    slack += 1.5 * parts + top * brightness * (unit_part * unit + step_part / (one.solid.radius * steps));
  }
  return {top * std::min(sum, 1.0), slack, is_bright};
}

Setup setup_of(const Case& one) {
  Setup setup{{one.eye, {0, 0, 0}, view::Projection::orthographic}, {}, 256};
  setup.exact_curves = true;
  setup.sampling.width = setup.sampling.height = 48;
  setup.sampling.z_bits = one.z_bits;
  setup.options.colour_bits = one.colour_bits;
  setup.options.scene.ambient.intensity = one.ambient;
  setup.options.scene.lights = one.lights;
  setup.options.scene.background.colour = glm::dvec3(0);
  return setup;
}

}  // namespace

std::string Solid::text() const {
  const std::string shape =
      height > 0 ? fmt::format("cylinder($fn=0,$fa=12,$fs=2,h={},r1={},r2={},center=true);", height, radius, radius)
                 : fmt::format("sphere($fn=0,$fa=12,$fs=2,r={});", radius);
  std::string rows;
  for (int row = 0; row < 3; ++row)
    rows += fmt::format("[{},{},{},{}],", axes[0][row], axes[1][row], axes[2][row], at[row]);
  return fmt::format("multmatrix([{}[0,0,0,1]]){{{}}}", rows, shape);
}

scene::Light light(const glm::dvec3& shines, const glm::dvec3& colour, double intensity) {
  return {.axes = scene::Axes::camera, .direction = shines, .colour = colour, .intensity = intensity};
}

void measure(const Case& one, Errors& errors) {
  const Setup setup = setup_of(one);
  std::string text = one.solid.text();
  if (one.colour) text = fmt::format("color([{},{},{},1]){{{}}}", one.colour->r, one.colour->g, one.colour->b, text);
  const Compiled compiled = compile_text(text + one.beside, setup);
  const observe::Frame frame = draw(compiled.program);
  const view::EyeSpace space = view::eye_space(setup.camera, setup.sampling);
  const double steps = steps_of(one, compiled.view);
  const std::array<unsigned, 3> widths = isa::channel_widths(one.colour_bits);
  const unsigned widest = *std::max_element(widths.begin(), widths.end());
  for (std::uint32_t y = 0; y < setup.sampling.height; ++y) {
    for (std::uint32_t x = 0; x < setup.sampling.width; ++x) {
      const auto normal = normal_at(one.solid, space, steps, x, y);
      if (!normal) continue;
      ++errors.checked;
      std::uint32_t packed = frame.colour[y * setup.sampling.width + x];
      for (int channel = 2; channel >= 0; --channel) {
        const unsigned width = widths.at(static_cast<std::size_t>(channel));
        const double top = std::exp2(width) - 1;
        const double level = packed & ((1U << width) - 1);
        packed >>= width;
        const Law expected = law(one, steps, *normal, channel, widest);
        const double error = std::abs(level - expected.level);
        errors.levels = std::max(errors.levels, error);
        errors.part = std::max(errors.part, error / expected.slack);
        if (level > 0 && level < top) ++errors.lit;
        if (!expected.is_bright) continue;
        errors.sum += level - expected.level;
        ++errors.summed;
      }
    }
  }
}

}  // namespace csgsim::testing
