#include <boost/multiprecision/cpp_int.hpp>

#include "host/commands/read.h"
#include "host/read/read.h"
#include "places.h"
#include "sim/software/convert/surface.h"
#include "tests/oracle/split_mix.h"
#include "tests/oracle/tree_rules.h"
#include "tests/support/test.h"
#include "tests/unit/convert/converted.h"
#include "tests/unit/convert/mesh_judge.h"
#include "tests/unit/software/random_tree.h"

using namespace csgsim;
using testing::Random;

namespace {

namespace convert = software::convert;

const std::string models = CSGSIM_SOURCE_DIR "/tests/unit/convert/models/";

/// Area of a regular polygon inscribed in a circle.
double polygon_area(int corners, double radius) {
  return corners / 2.0 * radius * radius * std::sin(2 * std::numbers::pi / corners);
}

double closed_volume(const convert::Surface& surface) {
  CHECK(testing::sides_fault_of(testing::judged(surface)) == "");
  return convert::measure(surface).volume;
}

}  // namespace

TEST_CASE("a drilled cube has the same volume for any length of the tool") {
  const double expected = 8000 - 20 * polygon_area(16, 2);
  for (const char* const length : {"30", "1e6", "1e9", "1e10", "1e11", "1e12", "1.9e12"}) {
    CAPTURE(length);
    const convert::Surface surface =
        testing::converted(fmt::format("difference(){{cube([20,20,20],center=true);"
                                       "cylinder($fn=16,$fa=12,$fs=2,h={},r1=2,r2=2,center=true);}}",
                                       length));
    CHECK(closed_volume(surface) == doctest::Approx(expected).epsilon(1e-9));
    CHECK(convert::measure(surface).genus() == 1);
  }
}

TEST_CASE("a small part left by subtracting huge cubes has the expected volume") {
  for (const char* const far : {"1e6", "1e9", "1e11"}) {
    CAPTURE(far);
    // The huge cube is subtracted again, except for a slab of thickness 1 whose corner the small cube partly fills.
    const convert::Surface surface = testing::converted(fmt::format(
        "difference(){{cube([{0},{0},3]);multmatrix([[1,0,0,2],[0,1,0,0],[0,0,1,-1],[0,0,0,1]])"
        "{{cube([{0},{0},5]);}}multmatrix([[1,0,0,-1],[0,1,0,2],[0,0,1,-1],[0,0,0,1]]){{cube([{0},{0},5]);}}}}",
        far));
    CHECK(closed_volume(surface) == doctest::Approx(2 * 2 * 3).epsilon(1e-12));
  }
}

TEST_CASE("a needle has the volume of its profile") {
  // Four segments of 67.5 degrees; the profile has area 2^31 and its centroid is 2 from the axis.
  const double expected = 4 * std::sin(67.5 * std::numbers::pi / 180) * 2147483648.0 * 2;
  const convert::Surface surface = testing::converted(
      "multmatrix([[0.612372,0.65974,0.435596,5],[0.612372,-0.0473672,-0.789149,5],[-0.5,0.75,-0.433013,-2],[0,0,0,1]])"
      "{rotate_extrude(angle=270,convexity=2,$fn=6,$fa=12,$fs=2){polygon(points=[[1,0],[3,0],[2,2147483648]],paths="
      "undef,"
      "convexity=1);}}");
  CHECK(closed_volume(surface) == doctest::Approx(expected).epsilon(1e-6));
}

TEST_CASE("the models of volumes.txt convert to closed meshes of the listed volumes") {
  std::ifstream file(models + "volumes.txt");
  std::string name;
  double volume = 0;
  double within = 0;
  std::string judge;
  int count = 0;
  for (; file >> name >> volume >> within >> judge; ++count) {
    CAPTURE(name);
    const convert::Surface surface = testing::converted(read::read_csg_file(models + name + ".csg"));
    CHECK(closed_volume(surface) == doctest::Approx(volume).epsilon(within));
  }
  CHECK(count == 10);
}

TEST_CASE("a model with two edges between the same points converts to a closed mesh") {
  closed_volume(testing::converted(read::read_csg_file(models + "edges_that_repeat.csg")));
}

TEST_CASE("models with slivers below the coordinate resolution convert to closed meshes") {
  for (const char* const name : {"slivers_at_corners", "points_at_one_place", "ends_within_a_plane"}) {
    CAPTURE(name);
    const convert::Surface surface = testing::converted(read::read_csg_file(models + name + ".csg"));
    closed_volume(surface);
    CHECK(convert::has_sure_volume(convert::measure(surface)));
  }
}

TEST_CASE("a sheet thinner than the coordinate resolution has no reliable volume") {
  // An extrusion of 1.5 scaled by 0.10291, of a polygon with nine corners and height 2.
  const double expected = 0.10291 * 1.5 * 2 * polygon_area(9, 5);
  const convert::Surface surface = testing::converted(read::read_csg_file(models + "sheet.csg"));
  const convert::Measures measures = convert::measure(surface);
  CHECK(testing::sides_fault_of(testing::judged(surface)) == "");
  CHECK(std::abs(measures.volume - expected) <= measures.volume_error);
  CHECK_FALSE(convert::has_sure_volume(measures));
}

TEST_CASE("a self-intersecting sweep converts to a closed mesh") {
  std::ifstream file(models + "sweep_that_crosses_itself.jan");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  const convert::Surface surface = testing::converted(commands::read_text(text, "sweep.jan"));
  CHECK(closed_volume(surface) > 0);
}

namespace {

using Whole = boost::multiprecision::cpp_int;

/// A box with coordinates that are multiples of 2^-10.
struct Box {
  std::array<std::int64_t, 3> low{};
  std::array<std::int64_t, 3> high{};
};

struct Boxes {
  model::Tree tree;
  std::vector<Box> boxes;
};

constexpr double step = 0x1p-10;

/// Boxes from 2^-10 to 2^38 wide that sometimes share corners, edges and faces.
Boxes boxes_of_scales(Random& random) {
  Boxes made{testing::random_tree(random, 2 + static_cast<unsigned>(random.below(9))), {}};
  for (model::Primitive& primitive : made.tree.primitives) {
    Box box;
    const auto scale = std::array<unsigned, 4>{0, 10, 25, 46}.at(random.below(4));
    glm::dvec3 size(0);
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      box.low[i] = (static_cast<std::int64_t>(random.below(7)) - 3) << scale;
      box.high[i] = box.low[i] + (static_cast<std::int64_t>(1 + random.below(4)) << scale);
      size[axis] = static_cast<double>(box.high[i] - box.low[i]) * step;
      primitive.transform[3][axis] = static_cast<double>(box.low[i]) * step;
    }
    primitive.shape = model::Cube{size, false};
    made.boxes.push_back(box);
  }
  return made;
}

/// Sums the cells between all planes of the boxes.
Whole steps_in(const Boxes& made) {
  std::array<std::vector<std::int64_t>, 3> places;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const Box& box : made.boxes) {
      places[axis].push_back(box.low[axis]);
      places[axis].push_back(box.high[axis]);
    }
    std::ranges::sort(places[axis]);
  }
  const testing::TreeRules rules(made.tree);
  Whole sum = 0;
  std::vector<bool> held(made.boxes.size());
  for (std::size_t x = 0; x + 1 < places[0].size(); ++x) {
    for (std::size_t y = 0; y + 1 < places[1].size(); ++y) {
      for (std::size_t z = 0; z + 1 < places[2].size(); ++z) {
        const std::array<std::int64_t, 3> at{places[0][x], places[1][y], places[2][z]};
        for (std::size_t i = 0; i < held.size(); ++i) {
          held[i] = true;
          for (std::size_t axis = 0; axis < 3; ++axis)
            held[i] = held[i] && made.boxes[i].low[axis] <= at[axis] && at[axis] < made.boxes[i].high[axis];
        }
        if (rules.holds(held))
          sum += Whole(places[0][x + 1] - at[0]) * (places[1][y + 1] - at[1]) * (places[2][z + 1] - at[2]);
      }
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("boxes of scales up to 10^14 apart have closed meshes of exact volume") {
  const int cases = testing::cases(300, 30);
  int full = 0;
  for (int seed = 0; seed < cases; ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const Boxes made = boxes_of_scales(random);
    const convert::Surface surface = testing::converted(made.tree);
    const double expected = steps_in(made).convert_to<double>() * step * step * step;
    CHECK(closed_volume(surface) == doctest::Approx(expected).epsilon(1e-9));
    if (expected > 0) ++full;
  }
  CHECK(full > cases / 3);  // the seeds are fixed
}
