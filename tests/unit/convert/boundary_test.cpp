#include "sim/software/convert/surface.h"
#include "tests/support/test.h"
#include "tests/unit/convert/converted.h"
#include "tests/unit/convert/mesh_judge.h"

using namespace csgsim;
using testing::converted;
using testing::fault_of;
using testing::judged;

namespace {

software::convert::Measures measures_of(const std::string& csg) {
  const software::convert::Surface surface = converted(csg);
  CAPTURE(csg);
  CHECK(fault_of(judged(surface)) == "");
  const software::convert::Measures measures = software::convert::measure(surface);
  CHECK(measures.shells == testing::part_count(judged(surface)));
  CHECK(measures.volume == doctest::Approx(testing::volume_of(judged(surface))).epsilon(1e-12));
  return measures;
}

std::string moved(double x, double y, double z, const std::string& what) {
  return "multmatrix([[1,0,0," + std::to_string(x) + "],[0,1,0," + std::to_string(y) + "],[0,0,1," + std::to_string(z) +
         "],[0,0,0,1]]){" + what + "}";
}

}  // namespace

TEST_CASE("a cube converts to eight points and twelve triangles") {
  const software::convert::Surface surface = converted("cube([1,2,3]);");
  CHECK(surface.points.size() == 8);
  CHECK(surface.triangles.size() == 12);
  const software::convert::Measures measures = measures_of("cube([1,2,3]);");
  CHECK(measures.volume == doctest::Approx(6).epsilon(1e-14));
  CHECK(measures.area == doctest::Approx(22).epsilon(1e-14));
  CHECK(measures.euler == 2);
  CHECK(measures.genus() == 0);
}

TEST_CASE("cubes with a common face merge without a trace of it") {
  const software::convert::Surface surface = converted("cube([1,2,3]);" + moved(1, 0, 0, "cube([1,2,3]);"));
  CHECK(surface.points.size() == 8);
  CHECK(surface.triangles.size() == 12);
  CHECK(testing::volume_of(judged(surface)) == doctest::Approx(12).epsilon(1e-14));
}

TEST_CASE("a hole makes a torus and a cavity makes a second shell") {
  const software::convert::Measures hole =
      measures_of("difference(){cube([3,3,3]);" + moved(1, 1, -1, "cube([1,1,5]);") + "}");
  CHECK(hole.genus() == 1);
  CHECK(hole.shells == 1);
  CHECK(hole.volume == doctest::Approx(24).epsilon(1e-14));
  CHECK(hole.area == doctest::Approx(54 - 2 + 12).epsilon(1e-14));
  const software::convert::Measures cavity =
      measures_of("difference(){cube([3,3,3]);" + moved(1, 1, 1, "cube([1,1,1]);") + "}");
  CHECK(cavity.genus() == 0);
  CHECK(cavity.shells == 2);
  CHECK(cavity.volume == doctest::Approx(26).epsilon(1e-14));
}

TEST_CASE("cubes touching at an edge or corner are two shells with separate points") {
  for (const char* const shift : {"1,1,0", "1,1,1"}) {
    const std::string at(shift);
    const double z = at.back() - '0';
    const software::convert::Measures measures = measures_of("cube([1,1,1]);" + moved(1, 1, z, "cube([1,1,1]);"));
    CHECK(measures.shells == 2);
    CHECK(measures.volume == doctest::Approx(2).epsilon(1e-14));
    CHECK(converted("cube([1,1,1]);" + moved(1, 1, z, "cube([1,1,1]);")).points.size() == 16);
  }
}

TEST_CASE("solids that touch themselves along an edge keep consistent faces") {
  // Two holes with a common corner in the middle of a plate: their rims touch, and the plate is one shell.
  const software::convert::Measures measures = measures_of(
      "difference(){cube([4,4,1]);" + moved(1, 1, -1, "cube([1,1,3]);") + moved(2, 2, -1, "cube([1,1,3]);") + "}");
  CHECK(measures.volume == doctest::Approx(14).epsilon(1e-14));
  CHECK(measures.shells == 1);
}

TEST_CASE("an empty model converts to an empty surface") {
  CHECK(converted("difference(){cube([1,1,1]);cube([1,1,1]);}").triangles.empty());
  CHECK(converted("intersection(){cube([1,1,1]);" + moved(1, 0, 0, "cube([1,1,1]);") + "}").triangles.empty());
}

TEST_CASE("converting splits a side at every corner of other faces on it") {
  // A bar across the top of a block meets its edges in the middle.
  const software::convert::Measures measures =
      measures_of("cube([4,4,2]);" + moved(1, -1, 1, "cube([1,6,1]);") + moved(0, 1, 2, "cube([4,1,1]);"));
  CHECK(measures.volume == doctest::Approx(32 + 2 + 4).epsilon(1e-14));
  CHECK(measures.shells == 1);
}

TEST_CASE("concentric spheres and cylinders with coincident corners are closed") {
  const std::string round = "$fn=24,$fa=12,$fs=2";
  for (const char* const op : {"union", "difference", "intersection"}) {
    CAPTURE(op);
    measures_of(std::string(op) + "(){sphere(" + round + ",r=5);cylinder(" + round + ",h=12,r1=3,r2=3,center=true);" +
                "multmatrix([[1,0,0,0],[0,0,-1,0],[0,1,0,0],[0,0,0,1]]){cylinder(" + round +
                ",h=12,r1=3,r2=3,center=true);}}");
  }
}
