#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include "host/effects/rows.h"
#include "host/effects/texels.h"
#include "host/read/read.h"
#include "host/scene/read.h"
#include "hw/isa/colour_format.h"
#include "hw/pixel_square/kind.h"
#include "hw/scan_line/kind.h"
#include "tests/oracle/random_model.h"
#include "tests/oracle/ray_picture.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

constexpr std::uint32_t width = 64;
constexpr std::uint32_t height = 48;

scene::Scene scene_of(const std::string& text) { return scene::read_scene(text, "scene", {}, effects::sections()); }

testing::Setup setup_of(const std::string& scene, const view::Camera& camera) {
  testing::Setup setup{camera, {}, 256};
  setup.sampling.width = width;
  setup.sampling.height = height;
  setup.options.scene = scene_of(scene);
  setup.options.effects = effects::all();
  return setup;
}

/// A texture computed directly.
struct Pattern {
  std::vector<std::vector<glm::dvec3>> texels;
  double size = 1;
  glm::dvec2 corner{0};

  [[nodiscard]] glm::dvec3 at(double u, double v) const {
    const auto place = [&](double along, std::size_t count) {
      const double n = static_cast<double>(count);
      const double whole = std::floor(along / size);
      return static_cast<std::size_t>(whole - n * std::floor(whole / n));
    };
    const std::vector<glm::dvec3>& row = texels[place(v - corner.y, texels.size())];
    return row[place(u - corner.x, row.size())];
  }

  [[nodiscard]] std::string text() const {
    std::string rows;
    for (const auto& row : texels) {
      rows += "[";
      for (const glm::dvec3& one : row) rows += fmt::format("[{}, {}, {}],", one.r, one.g, one.b);
      rows += "],";
    }
    return fmt::format("[[effects.textures]]\npattern = 'table'\ntexels = [{}]\nsize = {}\nu0 = {}\nv0 = {}\n", rows,
                       size, corner.x, corner.y);
  }
};

/// Intersection of the ray through a point of the picture with a plane.
glm::dvec3 ray_intersection(const view::EyeSpace& space, const facet::Plane& plane, const glm::dvec3& centre,
                            glm::dvec2 at) {
  const glm::dvec3 a = space.to_model(space.from_picture({at.x, at.y, 1}));
  const glm::dvec3 b = space.to_model(space.from_picture({at.x, at.y, 2}));
  const double from = glm::dot(plane.normal, a - centre) + plane.offset;
  const double to = glm::dot(plane.normal, b - centre) + plane.offset;
  return a + (b - a) * (from / (from - to));
}

glm::dvec2 on_facet(const glm::dvec3& point, const glm::dvec3& normal) {
  const glm::dvec3 n = glm::abs(normal) + glm::dvec3(2e-6, 1e-6, 0);  // the first axis wins a tie
  if (n.x > n.y && n.x > n.z) return {point.y, point.z};
  if (n.y > n.z) return {point.x, point.z};
  return {point.x, point.y};
}

bool takes_textures(const model::Primitive& primitive, const glm::dvec3& normal) {
  if (std::holds_alternative<model::Cylinder>(primitive.shape)) {
    const glm::dvec3 x(primitive.transform[0]);
    const glm::dvec3 y(primitive.transform[1]);
    return std::abs(glm::dot(glm::normalize(glm::cross(x, y)), normal)) > 1 - 1e-7;
  }
  return !std::holds_alternative<model::Sphere>(primitive.shape);
}

bool is_rounded(std::uint8_t level, double channel) { return std::abs(level - 255.0 * channel) <= 0.5 + 1e-6; }

struct Tally {
  int textured = 0;
  int near_boundary = 0;
  int plain = 0;
  int wrong = 0;
};

/// Draws white models with textures: the visible colour is the texel's colour times the light.
void compare(const std::string& model, const Pattern& pattern, const view::Camera& camera, Tally& tally) {
  const std::string white = "[[materials]]\ncolour = [1, 1, 1]\n";
  const testing::Setup setup = setup_of(white + pattern.text(), camera);
  const auto compiled = testing::compile_text(model, setup);
  const observe::Frame frame = testing::draw(compiled.program);
  const auto lit = testing::ray_picture(compiled.tree, compiled.scene, scene_of(white), {camera, width, height});
  const view::EyeSpace space = view::eye_space(camera, setup.sampling);
  for (std::size_t i = 0; i < lit.size(); ++i) {
    if (!lit[i].is_certain || lit[i].primitive == model::no_index) continue;
    const facet::Convex& solid = compiled.scene.solids[lit[i].primitive];
    const facet::Plane& plane = compiled.scene.planes.planes()[solid.halfspaces[lit[i].halfspace].plane];
    glm::dvec3 expected = lit[i].colour;
    if (takes_textures(compiled.tree.primitives[lit[i].primitive], plane.normal)) {
      const auto texel = [&](double aside, double below) {
        const glm::dvec2 at(static_cast<double>(i % width) + aside, static_cast<double>(i / width) + below);
        const glm::dvec2 uv =
            on_facet(ray_intersection(space, plane, compiled.scene.planes.centre(), at), plane.normal);
        return pattern.at(uv.x, uv.y);
      };
      const glm::dvec3 here = texel(0, 0);
      const double e = effects::boundary_error;
      ++tally.textured;
      if (here != texel(e, e) || here != texel(e, -e) || here != texel(-e, e) || here != texel(-e, -e)) {
        ++tally.near_boundary;
        continue;
      }
      expected *= here;
    } else {
      ++tally.plain;
    }
    const std::array<std::uint8_t, 3> colour = isa::unpack_colour(frame.colour[i], isa::max_colour_bits);
    if (is_rounded(colour[0], expected.r) && is_rounded(colour[1], expected.g) && is_rounded(colour[2], expected.b))
      continue;
    ++tally.wrong;
    MESSAGE("column ", i % width, ", row ", i / width, ": ", int{colour[0]}, " ", int{colour[1]}, " ", int{colour[2]},
            " for ", 255 * expected.r, " ", 255 * expected.g, " ", 255 * expected.b);
  }
}

const std::array<Pattern, 4> some_patterns{
    Pattern{{{{1, 0.2, 0.1}, {0.1, 0.3, 1}}, {{0.1, 0.3, 1}, {1, 0.2, 0.1}}}, 1.3, {0.2, -0.7}},
    Pattern{{{{1, 0.5, 0}, {0, 0.5, 1}}}, 0.9, {11, 0}},
    Pattern{{{{0.9, 0, 0}, {0, 0.9, 0}, {0, 0, 0.9}, {0.9, 0, 0}}, {{0.9, 0.9, 0}, {0, 0, 0.9}, {1, 1, 1}, {0, 0, 0}}},
            2.1,
            {-40.3, 7.7}},
    Pattern{{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{1, 1, 0}}, {{1, 0, 1}}, {{0, 1, 1}}, {{1, 1, 1}}, {{0, 0, 0}}},
            0.7,
            {0, 0.35}}};

Tally compare_random(view::Projection projection) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    CAPTURE(seed);
    const std::string model = testing::random_model(seed, 1 + static_cast<unsigned>(seed % 7));
    const facet::Box box = facet::make_geometry(read::read_csg_text(model, "random")).box;
    if (box.empty()) continue;
    const double turn = 0.7 * static_cast<double>(seed);
    Pattern pattern = some_patterns.at(seed % some_patterns.size());
    pattern.size *= glm::length(box.high - box.low) / 16;
    compare(model, pattern,
            view::view_all({{std::cos(turn), std::sin(turn), 0.63}, {0, 0, 0}, projection}, box, width, height), tally);
  }
  return tally;
}

void check(const Tally& tally) {
  CAPTURE(tally.textured);
  CAPTURE(tally.near_boundary);
  CHECK(tally.wrong == 0);
  CHECK(tally.textured > 3000);
  CHECK(tally.plain > 500);
  CHECK(tally.near_boundary < tally.textured / 4);
}

const view::Camera from_above{{0, 0, 100}, {0, 0, 0}, view::Projection::orthographic};

std::string error_with(const std::string& scene, const std::string& model, const view::Camera& camera = from_above) {
  return testing::error_of([&] { testing::compile_text(model, setup_of(scene, camera)); });
}

std::uint32_t colour_at(const observe::Frame& frame, std::uint32_t x, std::uint32_t y) {
  return frame.colour[std::size_t{y} * width + x];
}

}  // namespace

TEST_CASE("every pixel shows the texel that its ray hits in orthographic views") {
  check(compare_random(view::Projection::orthographic));
}

TEST_CASE("every pixel shows the texel that its ray hits in perspective views") {
  check(compare_random(view::Projection::perspective));
}

TEST_CASE("a facet next to the eye is textured up to its horizon") {
  Tally tally;
  const std::string floor =
      "multmatrix([[1, 0, 0, -50], [0, 1, 0, -50], [0, 0, 1, -2], [0, 0, 0, 1]])"
      "{ cube(size = [100, 100, 1]); }";
  compare(floor, {some_patterns[0].texels, 4, {0, 0}}, {{0, -30, 3}, {0, 0, 0}, view::Projection::perspective}, tally);
  CHECK(tally.textured > 500);
  CHECK(tally.wrong == 0);
}

TEST_CASE("a texture is projected along the first of the axes nearest to the facet's normal") {
  const std::string across_x = "multmatrix([[1, 0, 0, 0], [0, 0.6, -0.6, 0], [0, 0.6, 0.6, 0], [0, 0, 0, 1]])";
  const std::string across_z = "multmatrix([[0.6, -0.6, 0, 0], [0.6, 0.6, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])";
  const std::string both =
      across_x + "{ cube(size = [9, 9, 9]); }" + across_z + "{ cube(size = [4, 4, 40], center = true); }";
  Tally tally;
  compare(both, {some_patterns[2].texels, 1.7, {0.4, 0.9}}, {{30, -60, 70}, {4, 2, 4}, view::Projection::orthographic},
          tally);
  CHECK(tally.wrong == 0);
  CHECK(tally.textured > 300);
}

TEST_CASE("a checker texture starts at u0 and v0 with its first colour") {
  // A pixel is a tenth of a unit, the top of the cube is 4 x 4 units, u points right and v up.
  const double distance = 0.1 * height / 2 / view::half_height_per_distance();
  const view::Camera camera{{0, 0, distance}, {0, 0, 0}, view::Projection::orthographic};
  const std::string cube = "cube(size = [4, 4, 4], center = true);";
  const std::string lights = "[ambient]\nintensity = 1\n[[lights]]\ndirection = [0, 0, -1]\nintensity = 0\n";
  const auto compiled = testing::compile_text(
      cube,
      setup_of(lights + "[[effects.textures]]\nfirst = [1, 0, 0]\nsecond = [0, 0, 1]\nsize = 1\nu0 = -2\nv0 = -2\n",
               camera));
  const observe::Frame frame = testing::draw(compiled.program);
  for (std::uint32_t column = 0; column < 4; ++column) {
    for (std::uint32_t row = 0; row < 4; ++row) {
      const std::uint32_t x = width / 2 - 20 + 10 * column + 5;
      const std::uint32_t y = height / 2 + 20 - 10 * row - 5;
      CHECK(colour_at(frame, x, y) == ((column + row) % 2 == 0 ? 0xff0000U : 0x0000ffU));
    }
  }
}

TEST_CASE("a texel that starts at the centres of a facet's last pixels is visible") {
  // A pixel of this frontal view is half a unit; the one in column x and row y has its centre at ((x - 31.5) / 2, (23.5
  // - y) / 2).
  const double distance = 0.5 * height / 2 / view::half_height_per_distance();
  const view::Camera camera{{0, 0, distance}, {0, 0, 0}, view::Projection::perspective};
  const std::string plate =
      "multmatrix([[1, 0, 0, -4.4], [0, 1, 0, -4.4], [0, 0, 1, -1], [0, 0, 0, 1]]) { cube(size = [8.8, 8.8, 1]); }";
  const std::string lights = "[ambient]\nintensity = 1\n[[lights]]\ndirection = [0, 0, -1]\nintensity = 0\n";
  const auto drawn = [&](const std::string& texels) {
    const std::string texture =
        "[[effects.textures]]\npattern = 'table'\nsize = 16\nu0 = -11.75\nv0 = -11.75\ntexels = " + texels + "\n";
    return testing::draw(testing::compile_text(plate, setup_of(lights + texture, camera)).program);
  };
  const observe::Frame columns = drawn("[[[1, 0, 0], [0, 0, 1]]]");
  const observe::Frame rows = drawn("[[[1, 0, 0]], [[0, 0, 1]]]");
  for (std::uint32_t i = 23; i <= 40; ++i) {
    CAPTURE(i);
    CHECK(colour_at(columns, i, 24) == (i == 40 ? 0x0000ffU : 0xff0000U));
    const std::uint32_t row = i - 8;
    CHECK(colour_at(rows, 31, row) == (row == 15 ? 0x0000ffU : 0xff0000U));
  }
}

TEST_CASE("the last enabled texture that applies to a primitive is used") {
  const std::string lights = "[ambient]\nintensity = 1\n[[lights]]\ndirection = [0, 0, -1]\nintensity = 0\n";
  const auto one_colour = [](const std::string& colour, const std::string& rest) {
    return fmt::format("[[effects.textures]]\nfirst = {0}\nsecond = {0}\n{1}\n", colour, rest);
  };
  const std::string model = "color([0, 1, 0, 1]) { cube(size = [40, 40, 4], center = true); }";
  const auto middle = [&](const std::string& textures) {
    const view::Camera camera{{0, 0, 200}, {0, 0, 0}, view::Projection::orthographic};
    return colour_at(testing::draw(testing::compile_text(model, setup_of(lights + textures, camera)).program),
                     width / 2, height / 2);
  };
  const std::string red = one_colour("[1, 0, 0]", "of_colour = [0, 1, 0]");
  const std::string blue = one_colour("[0, 0, 1]", "");
  CHECK(middle(red + blue) == 0x0000ffU);
  CHECK(middle(blue + red) == 0xff0000U);
  CHECK(middle(blue + red + "on = false\n") == 0x0000ffU);
  CHECK(middle(blue + one_colour("[1, 0, 0]", "from_line = 2")) == 0x0000ffU);
  CHECK(middle(red + "on = false\n") == 0x00ff00U);
}

TEST_CASE("a textured picture is identical for all machines and colourings") {
  for (const view::Projection projection : {view::Projection::orthographic, view::Projection::perspective}) {
    const std::string model = testing::random_model(5, 6);
    const facet::Box box = facet::make_geometry(read::read_csg_text(model, "random")).box;
    const view::Camera camera = view::view_all({{1, -2, 1.3}, {0, 0, 0}, projection}, box, width, height);
    testing::Setup setup = setup_of(some_patterns[2].text(), camera);
    const observe::Frame whole = testing::draw(testing::compile_text(model, setup).program);
    setup.options.colouring = emit::Colouring::field;
    CHECK(testing::draw(testing::compile_text(model, setup).program).colour == whole.colour);
    setup.kind = &scan_line::kind;
    CHECK(testing::draw(testing::compile_text(model, setup).program).colour == whole.colour);
    setup.kind = &pixel_square::kind;
    setup.square = {16, 16};
    setup.options.colouring = emit::Colouring::rebroadcast;
    CHECK(testing::draw(testing::compile_text(model, setup).program).colour == whole.colour);
  }
}

TEST_CASE("a texture skips a sphere but is rejected if it selects the sphere by line") {
  const std::string sphere = "sphere($fn = 8, $fa = 12, $fs = 2, r = 5);";
  const std::string error = error_with("[[effects.textures]]\nfrom_line = 1\n", sphere);
  CHECK(error.find("test:1:1: textures are only for flat facets, and this is a sphere") != error.npos);
  CHECK(error_with("[[effects.textures]]\n", sphere).empty());
}

TEST_CASE("too many texels in perspective are an error that suggests a size") {
  const view::Camera camera{{50, -80, 60}, {0, 0, 0}, view::Projection::perspective};
  const std::string cube = "cube(size = [30, 30, 30], center = true);";
  const std::string error = error_with("[[effects.textures]]\nsize = 0.1\n", cube, camera);
  CHECK(error.find("598 lines") != error.npos);
  CHECK(error.find("size 0.118 or larger") != error.npos);
  CHECK(error_with("[[effects.textures]]\nsize = 0.118\n", cube, camera).empty());
  CHECK(error_with("[[effects.textures]]\nsize = 0.1\npattern = 'stripes'\n", cube, camera).empty());
}

TEST_CASE("an invalid table of texels or range of lines of a texture is rejected") {
  const std::string cube = "cube(size = [30, 30, 30], center = true);";
  const auto error = [&](const std::string& keys) { return error_with("[[effects.textures]]\n" + keys, cube); };
  CHECK(error("pattern = 'table'").find("needs colours") != std::string::npos);
  CHECK(error("pattern = 'table'\ntexels = [[[1,0,0],[1,0,0],[1,0,0]]]").find("1 rows of 3 colours") !=
        std::string::npos);
  CHECK(error("pattern = 'table'\ntexels = [[[1,0,0]],[[1,0,0],[0,0,0]]]").find("equally long") != std::string::npos);
  CHECK(error("pattern = 'table'\ntexels = [[1,0,0]]").find("a colour of effects.textures.texels is an integer") !=
        std::string::npos);
  CHECK(error("pattern = 'table'\ntexels = [[[1,0,2]]]").find("it must be 0 to 1") != std::string::npos);
  CHECK(error("texels = [[[1,0,0]]]").find("texels need pattern = \"table\"") != std::string::npos);
  CHECK(error("to_line = 3").find("add from_line") != std::string::npos);
}

TEST_CASE("textures are rejected on a machine that divides the model") {
  testing::Setup setup = setup_of("[[effects.textures]]\n", from_above);
  setup.machine = "multi-processor";
  const std::string error =
      testing::error_of([&] { testing::compile_text("cube(size = [30, 30, 30], center = true);", setup); });
  CHECK(error.find("take its tables [[effects.textures]] out of the scene") != error.npos);
}
