#include <rapidcheck.h>

#include "hw/isa/colour_format.h"
#include "hw/isa/facts.h"
#include "hw/isa/pieces.h"
#include "sim/observe/pictures.h"
#include "tests/support/test.h"
#include "tests/unit/effects/effect_picture.h"

using namespace csgsim;

namespace {

constexpr std::uint32_t width = 44;
constexpr std::uint32_t height = 36;
constexpr double alpha = 0.25;
constexpr double thickness = 2;

using Polygon = std::vector<glm::dvec2>;

/// A plate from z = 0 to `thickness`: the points inside an odd number of the polygons.
struct Plate {
  std::vector<Polygon> outlines;

  [[nodiscard]] std::string text() const {
    std::string points;
    std::string paths;
    int count = 0;
    for (const Polygon& outline : outlines) {
      std::string path;
      for (const glm::dvec2& point : outline) {
        points += fmt::format("{}[{}, {}]", points.empty() ? "" : ", ", point.x, point.y);
        path += fmt::format("{}{}", path.empty() ? "" : ", ", count++);
      }
      paths += fmt::format("{}[{}]", paths.empty() ? "" : ", ", path);
    }
    return fmt::format(
        "linear_extrude(height = {}, center = false, convexity = 1, scale = [1, 1], $fn = 0, $fa = 12, $fs = 2) "
        "{{ polygon(points = [{}], paths = [{}], convexity = 1); }}",
        thickness, points, paths);
  }

  [[nodiscard]] bool holds(const glm::dvec2& at) const {
    bool is_inside = false;
    for_edges([&](const glm::dvec2& a, const glm::dvec2& b) {
      if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)) is_inside = !is_inside;
    });
    return is_inside;
  }

  /// Parameters at which a line crosses its surface, in order.
  [[nodiscard]] std::vector<double> crossings(const glm::dvec3& origin, const glm::dvec3& along) const {
    std::vector<double> all;
    for (const double z : {0.0, thickness}) {
      const double t = (z - origin.z) / along.z;
      if (holds(glm::dvec2(origin + t * along))) all.push_back(t);
    }
    for_edges([&](const glm::dvec2& a, const glm::dvec2& b) {
      const glm::dvec2 across(b.y - a.y, a.x - b.x);
      const double t = glm::dot(a - glm::dvec2(origin), across) / glm::dot(glm::dvec2(along), across);
      const glm::dvec3 at = origin + t * along;
      const double part = glm::dot(glm::dvec2(at) - a, b - a) / glm::dot(b - a, b - a);
      if (at.z > 0 && at.z < thickness && part > 0 && part < 1) all.push_back(t);
    });
    std::sort(all.begin(), all.end());
    return all;
  }

 private:
  template <class Visit>
  void for_edges(const Visit& visit) const {
    for (const Polygon& outline : outlines)
      for (std::size_t i = 0; i < outline.size(); ++i) visit(outline[i], outline[(i + 1) % outline.size()]);
  }
};

/// Number of times that the pixel's ray enters the plate; empty if a hundredth of a pixel or a depth step could change
/// it.
std::optional<std::size_t> entries(const Plate& plate, const view::EyeSpace& eye, const glm::dvec2& place) {
  std::optional<std::size_t> count;
  for (const glm::dvec2& aside :
       {glm::dvec2{0, 0}, glm::dvec2{0.01, 0.01}, {-0.01, 0.01}, {0.01, -0.01}, {-0.01, -0.01}}) {
    const glm::dvec2 at = place + aside;
    const glm::dvec3 near = eye.to_model(eye.from_picture({at.x, at.y, 1}));
    const glm::dvec3 far = eye.to_model(eye.from_picture({at.x, at.y, 2}));
    const std::vector<double> all = plate.crossings(near, far - near);
    for (std::size_t i = 1; i < all.size(); ++i)
      if (all[i] - all[i - 1] < 1e-3) return std::nullopt;
    if (all.size() % 2 != 0 || (count && *count != all.size() / 2)) return std::nullopt;
    count = all.size() / 2;
  }
  return count;
}

testing::Setup view_of_plate(double turn, double height_of_eye, view::Projection projection) {
  testing::Setup setup =
      testing::front_view(width, height, testing::scene_of(testing::plain_colours, {"effects.transparency.layers=8"}));
  setup.camera = {{34 * std::cos(turn), 34 * std::sin(turn), height_of_eye}, {0, 0, 1}, projection};
  return setup;
}

struct Tally {
  int judged = 0;
  int through = 0;  ///< judged pixels whose rays enter more than once
  int wrong = 0;
};

void judge(const Plate& plate, const testing::Setup& setup, Tally& tally) {
  const auto compiled = testing::compile_text(testing::tinted({1, 1, 1}, alpha, plate.text()), setup);
  RC_PRE(compiled.tree.primitives.size() > 1);
  RC_ASSERT(compiled.program.facts->primitives.size() == 1);
  const observe::Frame frame = observe::with_primitive_owners(testing::draw(compiled.program), *compiled.program.facts);
  const view::EyeSpace eye = view::eye_space(setup.camera, setup.sampling);
  for (std::size_t i = 0; i < frame.colour.size(); ++i) {
    const glm::dvec2 place(static_cast<double>(i % width), static_cast<double>(i / width));
    const std::optional<std::size_t> count = entries(plate, eye, place);
    if (!count) continue;
    ++tally.judged;
    tally.through += *count > 1 ? 1 : 0;
    const double level = 255 * (1 - std::pow(1 - alpha, static_cast<double>(*count)));
    const double off = std::abs(isa::unpack_colour(frame.colour[i], isa::max_colour_bits)[0] - level);
    const bool is_owner = frame.owner[i] == (*count > 0 ? 0 : observe::no_owner);
    if (off <= static_cast<double>(*count) && is_owner) continue;
    ++tally.wrong;
    MESSAGE("column ", i % width, " row ", i / width, ": entered ", *count, " times, off by ", off);
  }
}

Polygon star(int points, double least, double most) {
  Polygon polygon;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * (i + *rc::gen::inRange(0, 60) / 100.0) / points;
    const double radius = least + (most - least) * *rc::gen::inRange(0, 1001) / 1000.0;
    polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return polygon;
}

}  // namespace

TEST_CASE("a transparent plate of many convex pieces has no seams") {
  Tally tally;
  const bool holds = rc::check("each pixel shows one pane for each entry of its ray", [&tally] {
    Plate plate{{star(*rc::gen::inRange(5, 12), 4, 11)}};
    if (*rc::gen::arbitrary<bool>()) plate.outlines.push_back(star(*rc::gen::inRange(3, 7), 1, 3));
    const double turn = *rc::gen::inRange(0, 628) / 100.0;
    const double eye = *rc::gen::inRange(2, 40);
    const auto projection =
        *rc::gen::arbitrary<bool>() ? view::Projection::perspective : view::Projection::orthographic;
    judge(plate, view_of_plate(turn, eye, projection), tally);
    RC_ASSERT(tally.wrong == 0);
  });
  CHECK(holds);
  MESSAGE(tally.judged, " pixels judged, ", tally.through, " through several walls");
  CHECK((!testing::draws_usual_cases() || tally.through > 500));
}

TEST_CASE("overlapping pieces of glass cut by the near plane appear as one solid") {
  // A cross of two bars as a Minkowski sum with overlapping pieces, and the same shape as a plate.
  const std::string bars = "minkowski(convexity = 0) { union() { " + testing::box_text({-8, -1, 0}, {7, 0, 1}) +
                           testing::box_text({-1, -8, 0}, {0, 7, 1}) + " } cube(size = [1, 2, 1], center = false); }";
  const Plate cross{
      {{{-8, -1}, {-1, -1}, {-1, -8}, {1, -8}, {1, -1}, {8, -1}, {8, 2}, {1, 2}, {1, 9}, {-1, 9}, {-1, 2}, {-8, 2}}}};
  const testing::Setup whole = view_of_plate(0.7, 30, view::Projection::perspective);
  testing::Setup cut_open = whole;
  cut_open.sampling.near = 34.0;
  testing::Setup from_above = whole;  // all front faces have the same depth
  from_above.camera = {{0, 0, 34}, {0, 0, 1}, view::Projection::orthographic};
  for (const testing::Setup& setup : {whole, cut_open, from_above}) {
    CAPTURE(setup.camera.eye.z);
    CAPTURE(setup.sampling.near.value_or(0));
    const auto drawn = [&](const std::string& csg) {
      return testing::draw(testing::compile_text(testing::tinted({1, 1, 1}, alpha, csg), setup).program);
    };
    const observe::Frame sum = drawn(bars);
    const observe::Frame plate = drawn(cross.text());
    int differing = 0;
    for (std::size_t i = 0; i < sum.colour.size(); ++i) differing += sum.colour[i] == plate.colour[i] ? 0 : 1;
    CHECK(differing == 0);
    CHECK(std::count(sum.colour.begin(), sum.colour.end(), 0U) < width * height * 9 / 10);
  }
}
