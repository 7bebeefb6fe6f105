#include "hw/isa/colour_format.h"
#include "hw/isa/program_file.h"
#include "tests/budgets/measure.h"
#include "tests/support/test.h"

// The pictures are checked with geometry in doubles: rays through pixel centres against triangles and spheres whose
// parameters are repeated here, independent of any instructions.

using namespace csgsim;
using budgets::Triangle;

namespace {

constexpr std::uint32_t side = 512;
constexpr std::uint32_t background = 0xffffff;
constexpr std::uint32_t background_depth = (1U << 20U) - 1;  ///< depth of the triangles' background
constexpr double far_away = 512;

const std::vector<Triangle> triangles{
    Triangle{{{30, 430, 120, {60, 140, 60}}, {490.25, 470.5, 150, {130, 210, 90}}, {300, 30.75, 420, {40, 90, 120}}}},
    Triangle{{{200.5, 60, 250, {220, 180, 60}}, {420, 180, 260, {240, 120, 40}}, {330, 420.25, 270, {150, 60, 30}}}},
    Triangle{{{120, 150.5, 60, {230, 40, 40}}, {300.75, 190, 80, {40, 60, 230}}, {190, 330, 50, {240, 230, 60}}}}};

struct Point {
  double x, y, z;
};

/// Inside, outside, or so close to the boundary (a thousandth of the triangle) that the pixel is not checked.
enum class Side : std::uint8_t { inside, outside, close };

Side side_of(const Triangle& triangle, double x, double y) {
  const std::array<double, 3> of = budgets::barycentric_coordinates(triangle, x, y);
  const double least = std::min({of[0], of[1], of[2]});
  if (std::abs(least) < 1e-3) return Side::close;
  return least > 0 ? Side::inside : Side::outside;
}

double depth_at(const Triangle& triangle, double x, double y) {
  return budgets::interpolate(triangle, {triangle[0].z, triangle[1].z, triangle[2].z}, x, y);
}

struct Seen {
  std::size_t triangle = 0;
  double z = far_away;
};

/// The first triangle that the ray through (x, y) meets; empty if that is too close to call.
std::optional<Seen> look(double x, double y) {
  Seen seen{triangles.size(), far_away};
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Side where = side_of(triangles[i], x, y);
    if (where == Side::close) return std::nullopt;
    if (where == Side::outside) continue;
    const double z = depth_at(triangles[i], x, y);
    if (std::abs(z - seen.z) < 0.1) return std::nullopt;
    if (z < seen.z) seen = {i, z};
  }
  return seen;
}

/// Whether another triangle blocks the light from the point; empty if that is too close to call.
std::optional<bool> shadowed(const Point& point, std::size_t own) {
  const Point light{0.6, 0.4, 1};
  bool found = false;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (i == own) continue;
    // Back towards the light, the distance behind the triangle's plane decreases linearly.
    const auto behind = [&](double way) {
      const double x = point.x - way * light.x;
      const double y = point.y - way * light.y;
      return point.z - way * light.z - depth_at(triangles[i], x, y);
    };
    const double way = behind(0) / (behind(0) - behind(1));
    const Side where = side_of(triangles[i], point.x - way * light.x, point.y - way * light.y);
    if (where == Side::outside) continue;
    if (where == Side::close || std::abs(way) < 0.1) return std::nullopt;
    found = found || way > 0;
  }
  return found;
}

/// Whether the pixel has the interpolated colour of the corners, or half of it.
bool colour_is(std::uint32_t colour, const Triangle& triangle, double x, double y, bool dark) {
  const std::array<std::uint8_t, 3> levels = isa::unpack_colour(colour, 24);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double full =
        budgets::interpolate(triangle, {triangle[0].colour[i], triangle[1].colour[i], triangle[2].colour[i]}, x, y);
    // Tolerance: half a level for rounded coefficients, and one level for each floor, here and in halving.
    const double off = levels[i] - (dark ? full / 2 : full);
    if (off > 0.5 || off < (dark ? -1.25 : -1.5)) return false;
  }
  return true;
}

struct Tally {
  std::uint32_t judged = 0;
  std::uint32_t wrong = 0;
  std::uint32_t dark = 0;
};

void judge_pixel(const observe::Frame& frame, std::uint32_t pixel, bool with_shadows, Tally& tally) {
  const double x = pixel % side + 0.5;
  const double y = std::floor(pixel / side) + 0.5;
  const std::optional<Seen> seen = look(x, y);
  if (!seen) return;
  const bool nothing = seen->triangle == triangles.size();
  const std::optional<bool> dark =
      with_shadows && !nothing ? shadowed({x, y, seen->z}, seen->triangle) : std::optional(false);
  if (!dark) return;
  ++tally.judged;
  if (*dark) ++tally.dark;
  const std::uint32_t depth = frame.depth[pixel];
  const std::uint32_t colour = frame.colour[pixel];
  const double off = depth - (1 + seen->z * (background_depth - 3) / far_away);
  const bool right = nothing ? depth == background_depth && colour == background
                             : off < 0.1 && off > -1.1 && colour_is(colour, triangles[seen->triangle], x, y, *dark);
  if (!right) ++tally.wrong;
}

Tally judge_triangles(const std::string& name, bool with_shadows) {
  const observe::Frame frame = budgets::measure(isa::load_program(budgets::source_path(name))).frame;
  Tally tally;
  for (std::uint32_t pixel = 0; pixel < side * side; ++pixel) judge_pixel(frame, pixel, with_shadows, tally);
  return tally;
}

struct Sphere {
  int column, row, front;                 ///< in pixels
  double radius;                          ///< in pixels
  std::array<double, 3> front_levels;     ///< levels of the components where the sphere is nearest
  std::array<double, 3> levels_a_radius;  ///< decrease at the limb, and half of that to the right and down
  int terms = 1;                          ///< rounded-down terms in addition to the linear expression
};

const std::vector<Sphere> spheres{{176, 296, 100, 128, {120, 120, 225}, {64, 64, 128}},
                                  {306, 196, 120, 64, {225, 120, 62}, {128, 64, 32}},
                                  {356, 276, 105, 64, {62, 120, 225}, {32, 64, 128}},
                                  {266, 286, 95, 32, {120, 225, 62}, {64, 128, 32}}};
const Sphere of_another_radius{276, 226, 100, 51.2, {225, 120, 62}, {102.4, 51.2, 25.6}, 2};

/// Depth of the paraboloid that touches the sphere in front and at the limb, in whole steps of a 64th of a pixel; empty
/// outside.
std::optional<int> depth_of(const Sphere& sphere, int x, int y) {
  const int dx = x - sphere.column;
  const int dy = y - sphere.row;
  const int square = dx * dx + dy * dy;
  if (square >= sphere.radius * sphere.radius) return std::nullopt;
  return 1 + 64 * sphere.front + static_cast<int>(std::floor(64 * square / sphere.radius));
}

double level(const Sphere& sphere, std::size_t component, int x, int y) {
  const double dx = (x - sphere.column) / sphere.radius;
  const double dy = (y - sphere.row) / sphere.radius;
  return sphere.front_levels.at(component) - sphere.levels_a_radius.at(component) * (dx * dx + dy * dy + (dx + dy) / 2);
}

/// Whether each component is 255 minus terms that were rounded down by less than a level each.
bool shaded_right(const Sphere& sphere, std::uint32_t colour, int x, int y) {
  const std::array<std::uint8_t, 3> levels = isa::unpack_colour(colour, 24);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double off = levels[i] - level(sphere, i, x, y);
    if (off < -1e-9 || off >= sphere.terms + 1) return false;
  }
  return true;
}

bool sphere_pixel_is(const std::vector<Sphere>& drawn, const observe::Frame& frame, std::uint32_t pixel) {
  const int x = static_cast<int>(pixel % side);
  const int y = static_cast<int>(pixel / side);
  const Sphere* nearest = nullptr;
  int depth = (1 << 15) - 1;
  for (const Sphere& sphere : drawn) {
    const std::optional<int> own = depth_of(sphere, x, y);
    if (!own || *own >= depth) continue;
    depth = *own;
    nearest = &sphere;
  }
  const int off = static_cast<int>(frame.depth[pixel]) - depth;
  if (nearest == nullptr) return off == 0 && frame.colour[pixel] == background;
  return off <= 0 && off > -nearest->terms && shaded_right(*nearest, frame.colour[pixel], x, y);
}

std::uint32_t wrong_pixels(const std::string& name, const std::vector<Sphere>& drawn) {
  const observe::Frame frame = budgets::measure(isa::load_program(budgets::source_path(name))).frame;
  std::uint32_t wrong = 0;
  for (std::uint32_t pixel = 0; pixel < side * side; ++pixel) {
    if (!sphere_pixel_is(drawn, frame, pixel)) ++wrong;
  }
  return wrong;
}

}  // namespace

TEST_CASE("triangles cover the right pixels with the right depths and interpolated colours") {
  const Tally tally = judge_triangles("triangle.csgt", false);
  CHECK(tally.wrong == 0);
  CHECK(tally.judged > side * side * 97 / 100);
}

TEST_CASE("a pixel is in shadow if the ray from its surface to the light meets a triangle") {
  const Tally tally = judge_triangles("shadow.csgt", true);
  CHECK(tally.wrong == 0);
  CHECK(tally.judged > side * side * 97 / 100);
  CHECK(tally.dark > 5000);
}

TEST_CASE("spheres are exact circles with paraboloid depths and shades within two levels") {
  CHECK(wrong_pixels("sphere.csgt", spheres) == 0);
}

TEST_CASE("a sphere whose radius is not a power of two is off by at most a depth step") {
  CHECK(wrong_pixels("sphere_radius.csgt", {of_another_radius}) == 0);
}
