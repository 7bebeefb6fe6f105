#include "host/read/read.h"
#include "hw/isa/colour_format.h"
#include "tests/oracle/random_model.h"
#include "tests/oracle/ray_picture.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

constexpr std::uint32_t width = 64;
constexpr std::uint32_t height = 48;

/// Comparison of a machine's picture with the oracle's.
struct Tally {
  int pixels = 0;
  int covered = 0;  ///< pixels that the oracle covers
  int doubtful = 0;
  int wrong = 0;  ///< owner or colour, of the certain pixels
};

/// Whether the 8-bit level is the rounded channel; halves may round either way.
bool is_rounded(std::uint8_t level, double channel) { return std::abs(level - 255.0 * channel) <= 0.5 + 1e-6; }

void compare(const testing::Compiled& compiled, const observe::Frame& frame,
             const std::vector<testing::RayColour>& expected, Tally& tally) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const testing::RayColour& pixel = expected[i];
    ++tally.pixels;
    const bool is_covered = pixel.primitive != model::no_index;
    tally.covered += is_covered ? 1 : 0;
    tally.doubtful += pixel.is_certain ? 0 : 1;
    if (!pixel.is_certain) continue;
    const std::array<std::uint8_t, 3> colour = isa::unpack_colour(frame.colour[i], isa::max_colour_bits);
    const bool is_owner = frame.owner[i] == pixel.primitive;
    const bool is_right = is_owner && is_rounded(colour[0], pixel.colour.x) && is_rounded(colour[1], pixel.colour.y) &&
                          is_rounded(colour[2], pixel.colour.z);
    if (is_right) continue;
    ++tally.wrong;
    MESSAGE(compiled.tree.file, ": column ", i % width, ", row ", i / width, ": owner ", frame.owner[i], " for ",
            pixel.primitive, ", colour ", int{colour[0]}, " ", int{colour[1]}, " ", int{colour[2]}, " for ",
            255 * pixel.colour.x, " ", 255 * pixel.colour.y, " ", 255 * pixel.colour.z);
  }
}

Tally draw_both(std::uint64_t first_seed, view::Projection projection, const scene::Scene& scene) {
  Tally tally;
  for (std::uint64_t seed = first_seed; seed < first_seed + 30; ++seed) {
    CAPTURE(seed);
    const double turn = 0.7 * static_cast<double>(seed);
    const std::string model = testing::random_model(seed, 1 + static_cast<unsigned>(seed % 13));
    const facet::Box box = facet::make_geometry(read::read_csg_text(model, "random")).box;
    if (box.empty()) continue;
    const view::Camera direction{{std::cos(turn), std::sin(turn), 0.63}, {0, 0, 0}, projection};
    testing::Setup setup{view::view_all(direction, box, width, height), {}, 256};
    setup.sampling.width = width;
    setup.sampling.height = height;
    setup.options.scene = scene;
    const auto compiled = testing::compile_text(model, setup);
    compare(compiled, testing::draw(compiled.program),
            testing::ray_picture(compiled.tree, compiled.scene, scene, {setup.camera, width, height}), tally);
  }
  return tally;
}

void check(const Tally& tally) {
  CAPTURE(tally.pixels);
  CAPTURE(tally.covered);
  CAPTURE(tally.doubtful);
  CHECK(tally.wrong == 0);
  CHECK(tally.doubtful < tally.covered / 10);
  CHECK(tally.covered > tally.pixels / 10);
}

scene::Light lamp(const glm::dvec3& position, scene::Axes axes) {
  scene::Light light;
  light.kind = scene::LightKind::point;
  light.axes = axes;
  light.position = position;
  light.colour = {0.9, 0.6, 0.8};
  light.intensity = 0.5;
  return light;
}

/// Two point lights and a directional light, and materials that differ by line of the file.
scene::Scene many_lights() {
  scene::Scene scene;
  scene.ambient = {{0.8, 0.9, 1}, 0.25};
  scene.background.colour = glm::dvec3(0.1, 0.2, 0.3);
  scene.lights = {lamp({12, -15, 18}, scene::Axes::model), lamp({-9, 4, 11}, scene::Axes::camera), {}};
  scene.lights.back().direction = {-1, 0.5, -2};
  scene.lights.back().intensity = 0.4;
  scene::MaterialRule shiny;
  shiny.material = {.ambient = 0.9, .diffuse = 0.6, .specular = 0.5, .shininess = 12};
  scene::MaterialRule dull;
  dull.from_line = 4;
  dull.to_line = 6;
  dull.colour = glm::dvec3(0.3, 0.5, 0.9);
  dull.material = {.ambient = 0.5, .diffuse = 1, .specular = 0, .shininess = 1};
  scene.materials = {shiny, dull};
  return scene;
}

}  // namespace

TEST_CASE("random models in the default light match the ray oracle (orthographic)") {
  check(draw_both(1, view::Projection::orthographic, {}));
}
TEST_CASE("random models in the default light match the ray oracle (perspective)") {
  check(draw_both(101, view::Projection::perspective, {}));
}
TEST_CASE("random models in several point lights match the ray oracle (orthographic)") {
  check(draw_both(201, view::Projection::orthographic, many_lights()));
}
TEST_CASE("random models in several point lights match the ray oracle (perspective)") {
  check(draw_both(301, view::Projection::perspective, many_lights()));
}
