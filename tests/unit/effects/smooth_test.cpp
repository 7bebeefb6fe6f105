#include "tests/support/test.h"
#include "tests/unit/effects/effect_picture.h"

using namespace csgsim;
using testing::front_view;
using testing::scene_of;

namespace {

constexpr std::uint32_t side = 64;
constexpr double radius = 28;
const glm::dvec3 to_light = glm::normalize(glm::dvec3(-0.6, -0.7, 0.2));

/// A white material, lit from the left.
std::string lit(double intensity) {
  return fmt::format(
      "[ambient]\nintensity = 0.1\n[[lights]]\ndirection = [{}, {}, {}]\nintensity = {}\n[[materials]]\n"
      "colour = [1, 1, 1]\n",
      -to_light.x, -to_light.y, -to_light.z, intensity);
}

/// A curved solid in the middle of the picture, seen from the front.
std::string cylinder(int facets) {
  return fmt::format(
      "multmatrix([[1,0,0,32],[0,1,0,50],[0,0,1,-70],[0,0,0,1]]){{cylinder($fn={},$fa=12,$fs=2,h=80,r1={},r2={},"
      "center=false);}}",
      facets, radius, radius);
}

std::string ball(int facets) {
  return fmt::format("multmatrix([[1,0,0,32],[0,1,0,50],[0,0,1,-32],[0,0,0,1]]){{sphere($fn={},$fa=12,$fs=2,r={});}}",
                     facets, radius);
}

/// Levels of green in row order.
std::vector<int> draw(const std::string& model, const std::string& scene) {
  const testing::Compiled compiled = testing::compile_text(model, front_view(side, side, scene_of(scene)));
  std::vector<int> levels;
  for (const std::uint32_t colour : testing::draw(compiled.program).colour)
    levels.push_back(static_cast<int>(colour >> 8U & 0xffU));
  return levels;
}

/// Level of the light that the true surface reflects to the pixel; negative outside it and at its rim, where the facets
/// end earlier.
double true_level(bool is_ball, std::uint32_t x, std::uint32_t y, double intensity) {
  const double across = (x + 0.5 - 32) / radius;
  const double down = is_ball ? (32 - (y + 0.5)) / radius : 0;
  const double forward = 1 - across * across - down * down;
  if (forward < 0.12) return -1;
  const double cosine = std::max(0.0, glm::dot(to_light, glm::dvec3(across, -std::sqrt(forward), down)));
  return 255 * std::min(1.0, 0.1 + intensity * cosine);
}

/// Root mean square error of the levels compared with the true surface.
double error_of(const std::vector<int>& levels, bool is_ball, double intensity) {
  double sum = 0;
  int count = 0;
  for (std::uint32_t y = 0; y < side; ++y) {
    for (std::uint32_t x = 0; x < side; ++x) {
      const double level = true_level(is_ball, x, y, intensity);
      if (level < 0) continue;
      sum += (levels[y * side + x] - level) * (levels[y * side + x] - level);
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

}  // namespace

TEST_CASE("16 smooth-shaded facets match a curved solid better than more flat-shaded ones") {
  const std::string flat = lit(0.85);
  const std::string smooth = flat + "[effects.smooth]\n";
  for (const bool is_ball : {false, true}) {
    const auto solid = [&](int facets) { return is_ball ? ball(facets) : cylinder(facets); };
    const double smooth_16 = error_of(draw(solid(16), smooth), is_ball, 0.85);
    const double flat_16 = error_of(draw(solid(16), flat), is_ball, 0.85);
    const double flat_more = error_of(draw(solid(is_ball ? 32 : 64), flat), is_ball, 0.85);
    MESSAGE(std::string(is_ball ? "ball" : "cylinder"), ": 16 smooth ", smooth_16, ", 16 flat ", flat_16,
            ", more flat ones ", flat_more);
    CHECK(smooth_16 < flat_more);
    CHECK(smooth_16 < flat_16 / 2);
    CHECK(smooth_16 > 0);
  }
}

TEST_CASE("the shades of a smooth cylinder have no steps between facets") {
  const std::vector<int> levels = draw(cylinder(16), lit(0.85) + "[effects.smooth]\n");
  for (std::uint32_t x = 8; x + 9 < side; ++x) {
    CAPTURE(x);
    const double slope = std::abs(true_level(false, x + 1, 0, 0.85) - true_level(false, x, 0, 0.85));
    CHECK(std::abs(levels[20 * side + x + 1] - levels[20 * side + x]) <= 1.5 * slope + 4);
  }
}

TEST_CASE("the shades of smooth solids saturate and do not overflow") {
  const std::vector<int> dim = draw(cylinder(16), lit(0.5) + "[effects.smooth]\n");
  const std::vector<int> glaring = draw(cylinder(16), lit(5) + "[effects.smooth]\n");
  for (std::size_t i = 0; i < dim.size(); ++i) CHECK(glaring[i] >= dim[i] - 1);
  CHECK(std::count(glaring.begin(), glaring.end(), 255) > static_cast<int>(side * side / 4));
}

TEST_CASE("smooth shading leaves flat solids unchanged") {
  const std::string box = testing::box_text({10, 5, -50}, {50, 40, -10});
  CHECK(draw(box, lit(0.7)) == draw(box, lit(0.7) + "[effects.smooth]\n"));
}
