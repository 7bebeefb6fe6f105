#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "hw/isa/colour_format.h"
#include "tests/support/drawing.h"

// The judge is Lambert's law in doubles, at the point where a pixel's ray meets the ball or the round side.

using namespace csgsim;

namespace {

/// A sphere, or a cylinder about its middle.
struct Solid {
  glm::dvec3 at{0};
  glm::dmat3 axes{1};
  double radius = 1;
  double height = 0;  ///< 0: a sphere

  [[nodiscard]] std::string text() const {
    const std::string shape =
        height > 0 ? fmt::format("cylinder($fn=0,$fa=12,$fs=2,h={},r1={},r2={},center=true);", height, radius, radius)
                   : fmt::format("sphere($fn=0,$fa=12,$fs=2,r={});", radius);
    std::string rows;
    for (int row = 0; row < 3; ++row)
      rows += fmt::format("[{},{},{},{}],", axes[0][row], axes[1][row], axes[2][row], at[row]);
    return fmt::format("multmatrix([{}[0,0,0,1]]){{{}}}", rows, shape);
  }
};

struct Case {
  Solid solid;
  std::optional<glm::dvec3> colour;
  std::vector<scene::Light> lights;
  double ambient = 0.3;
  glm::dvec3 eye{0, 0.04, 40};
  unsigned colour_bits = 24;
  unsigned z_bits = 20;
};

scene::Light light(const glm::dvec3& shines, const glm::dvec3& colour, double intensity) {
  return {.axes = scene::Axes::camera, .direction = shines, .colour = colour, .intensity = intensity};
}

/// Where the ray of a pixel comes in, if it is a place of the ball or of the round side: the normal, in the axes of the
/// eye.
std::optional<glm::dvec3> normal_at(const Solid& solid, const view::EyeSpace& space, double x, double y) {
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
  if (is_round && std::abs(origin.z + t * along.z) > solid.height / 2) return std::nullopt;
  const glm::dvec3 normal = solid.axes * ((from + across * t) / solid.radius);
  return glm::dvec3(glm::dot(normal, space.axes.right), glm::dot(normal, space.axes.up),
                    glm::dot(normal, space.axes.forward));
}

/// Not so near to a limb or rim that rounding decides what is there.
bool is_inside(const Solid& solid, const view::EyeSpace& space, double x, double y) {
  constexpr std::array<std::array<double, 2>, 4> around{{{0.75, 0}, {-0.75, 0}, {0, 0.75}, {0, -0.75}}};
  return std::all_of(around.begin(), around.end(),
                     [&](const auto& by) { return normal_at(solid, space, x + by[0], y + by[1]).has_value(); });
}

/// How far the picture is from the law.
struct Errors {
  double levels = 0;  ///< of a channel, the most
  double part = 0;    ///< of what is promised, the most
  int looked_at = 0;
  int lit = 0;  ///< of these, channels that are neither ambient light alone nor saturated
};

struct Law {
  double level;  ///< of the channel
  double slack;  ///< levels
};

/// Half a level is lost in the ambient light. Of each light half a level by digits, half where the sum is cut off and
/// half where its parts are, twice if it is so bright that it is
/// added in two parts; and an error of the cosine: a unit, of which 1 has 2^width at least, and of depth a step
/// and a half.
Law law(const Case& one, const view::View& view, const glm::dvec3& normal, int channel, unsigned widest) {
  const unsigned width = isa::channel_widths(one.colour_bits).at(static_cast<std::size_t>(channel));
  const double top = std::exp2(width) - 1;
  const glm::dvec3 colour = one.colour.value_or(glm::dvec3(0.976, 0.843, 0.173));
  const double steps = (std::exp2(one.z_bits) - 4.0) / (view.depth.far - view.depth.near);
  double sum = colour[channel] * one.ambient;
  double slack = 0.5;
  for (const scene::Light& light : one.lights) {
    const glm::dvec3 to_light = -glm::normalize(light.direction);
    const double brightness = colour[channel] * light.colour[channel] * light.intensity;
    if (brightness == 0) continue;
    sum += brightness * std::max(0.0, glm::dot(to_light, normal));
    const double parts = brightness > 5.5 ? 2 : 1;
    slack +=
        1.5 * parts + top * brightness * (std::exp2(-static_cast<double>(widest)) + 1.5 / (one.solid.radius * steps));
  }
  return {top * std::min(sum, 1.0), slack};
}

testing::Setup setup_of(const Case& one) {
  testing::Setup setup{{one.eye, {0, 0, 0}, view::Projection::orthographic}, {}, 256};
  setup.exact_curves = true;
  setup.sampling.width = setup.sampling.height = 48;
  setup.sampling.z_bits = one.z_bits;
  setup.options.colour_bits = one.colour_bits;
  setup.options.scene.ambient.intensity = one.ambient;
  setup.options.scene.lights = one.lights;
  setup.options.scene.background.colour = glm::dvec3(0);
  return setup;
}

void measure(const Case& one, Errors& errors) {
  const testing::Setup setup = setup_of(one);
  std::string text = one.solid.text();
  if (one.colour) text = fmt::format("color([{},{},{},1]){{{}}}", one.colour->r, one.colour->g, one.colour->b, text);
  const testing::Compiled compiled = testing::compile_text(text, setup);
  const sim::Frame frame = testing::draw(compiled.program);
  const view::EyeSpace space = view::eye_space(setup.camera, setup.sampling);
  const std::array<unsigned, 3> widths = isa::channel_widths(one.colour_bits);
  const unsigned widest = *std::max_element(widths.begin(), widths.end());
  for (std::uint32_t y = 0; y < setup.sampling.height; ++y) {
    for (std::uint32_t x = 0; x < setup.sampling.width; ++x) {
      const auto normal = normal_at(one.solid, space, x, y);
      if (!normal || !is_inside(one.solid, space, x, y)) continue;
      ++errors.looked_at;
      std::uint32_t packed = frame.colour[y * setup.sampling.width + x];
      for (int channel = 2; channel >= 0; --channel) {
        const unsigned width = widths.at(static_cast<std::size_t>(channel));
        const double top = std::exp2(width) - 1;
        const double level = packed & ((1U << width) - 1);
        packed >>= width;
        const Law expected = law(one, compiled.view, *normal, channel, widest);
        const double error = std::abs(level - expected.level);
        errors.levels = std::max(errors.levels, error);
        errors.part = std::max(errors.part, error / expected.slack);
        if (level > 0 && level < top) ++errors.lit;
      }
    }
  }
}

const std::vector<scene::Light> usual{light({0.36, -0.56, 0.75}, {1, 1, 1}, 0.7)};
const std::vector<scene::Light> two{light({0.36, -0.56, 0.75}, {1, 1, 1}, 0.7),
                                    light({-0.6, 0.2, 0.4}, {1, 0.4, 0}, 0.5)};
const std::vector<scene::Light> three{light({0.36, -0.56, 0.75}, {1, 1, 1}, 0.5),
                                      light({-0.6, 0.2, 0.4}, {1, 0.4, 0}, 0.5),
                                      light({0, 0.9, -0.1}, {0.1, 0.3, 1}, 0.8)};

const Solid ball{{0.3, -0.2, 0.1}, glm::dmat3(1), 6};
const Solid rod{{0.3, -0.2, 0.1}, {{0.6, 0, -0.8}, {0, 1, 0}, {0.8, 0, 0.6}}, 3, 9};

}  // namespace

TEST_CASE("balls and rods of several colours under one, two and three lights are lit as Lambert's law says") {
  Errors errors;
  for (const Solid& solid : {ball, rod})
    for (const auto& colour : std::array<std::optional<glm::dvec3>, 5>{
             std::nullopt, glm::dvec3(0), glm::dvec3(1), glm::dvec3(1, 0, 0.4), glm::dvec3(0.2, 0.6, 0.01)})
      for (const auto& lights : {usual, two, three})
        for (const unsigned colour_bits : {24U, 18U, 12U, 8U}) {
          Errors here;
          measure({solid, colour, lights, 0.3, {0, -12, 30}, colour_bits}, here);
          CAPTURE(colour_bits);
          CAPTURE(lights.size());
          CAPTURE(solid.height);
          CHECK(here.part <= 1);
          errors.levels = std::max(errors.levels, here.levels);
          errors.part = std::max(errors.part, here.part);
          errors.looked_at += here.looked_at;
          errors.lit += here.lit;
        }
  MESSAGE(errors.looked_at, " pixels, ", errors.levels, " levels off at most, ", errors.part, " of what is promised");
  CHECK(errors.looked_at > 80'000);
  CHECK(errors.lit > 60'000);
}

TEST_CASE(
    "light that is too bright saturates a channel and never wraps round, however bright and in however few bits") {
  Errors errors;
  for (const double intensity : {1.0, 6.5, 7.5, 10.0})
    for (const unsigned colour_bits : {24U, 15U, 3U})
      for (const unsigned z_bits : {20U, 8U, 4U}) {
        Errors here;
        std::vector<scene::Light> lights = two;
        for (scene::Light& one : lights) one.intensity = intensity;
        measure({ball, glm::dvec3(1, 0.9, 0.2), lights, 0.3, {0, -12, 30}, colour_bits, z_bits}, here);
        CAPTURE(intensity);
        CAPTURE(colour_bits);
        CAPTURE(z_bits);
        CAPTURE(here.levels);
        CHECK(here.part <= 1);
        errors.looked_at += here.looked_at;
      }
  CHECK(errors.looked_at > 20'000);
}
