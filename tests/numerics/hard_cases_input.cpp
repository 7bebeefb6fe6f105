#include "tests/numerics/hard_case.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"

using namespace csgsim::testing;

namespace {

constexpr Projection orthographic = Projection::orthographic;
constexpr Projection perspective = Projection::perspective;

const std::string cube = box({0, 0, 0}, {10, 10, 10});
const std::string body =
    subtract({box({0, 0, 0}, {10, 6, 4}), box({2, -1, 2}, {5, 7, 5}), cylinder({8, 3, 0}, 4, 1.5, 1, 14)});

void check_empty(const std::string& csg) { CHECK(look_obliquely(csg).covered == 0); }

void check_seen(const std::string& csg) {
  const Verdict verdict = look_obliquely(csg);
  CHECK(verdict.wrong == 0);
  CHECK(verdict.covered > 1000);
}

/// Checks that both models give the same, correct picture.
void check_same(const std::string& a, const std::string& b) {
  check_seen(a);
  for (const Projection projection : {orthographic, perspective}) {
    const csgsim::view::Camera camera{{31, -42, 27}, {4, 5, 3}, projection};
    const csgsim::observe::Frame one = picture_of(a, camera);
    CHECK(same_depths(one, picture_of(b, camera)));
    CHECK(covered_pixels(one, 20) > 500);
  }
}

std::string error_of(const std::string& csg, const csgsim::view::Camera& camera, const Look& how = {}) {
  try {
    compile_text(csg, {camera, how.sampling, how.memory_bits});
  } catch (const csgsim::InputError& error) {
    return error.what();
  }
  return "";
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a mirrored solid is drawn correctly and not inside out") {
  check_seen(with_transform("[[-1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", body));
  check_seen(with_transform("[[1,0,0,0],[0,1,0,0],[0,0,-1,0],[0,0,0,1]]", body));
  check_seen(subtract({cube, with_transform("[[-1,0,0,10],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", body)}));
}
TEST_CASE("a solid mirrored twice is the solid") {
  const std::string mirror = "[[-1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]";
  check_same(body, with_transform(mirror, with_transform(mirror, body)));
}
TEST_CASE("skewed solids are drawn correctly") {
  check_seen(with_transform("[[1,0.5,-0.3,0],[0.2,1,0.4,0],[0,0.7,1,0],[0,0,0,1]]", body));
  CHECK(look_obliquely(with_transform("[[1,40,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", body)).wrong == 0);
}
TEST_CASE("unevenly scaled solids are drawn correctly") {
  check_seen(with_transform(scaling({1000, 1, 100}), ball({0, 0, 0}, 5, 20)));
  check_seen(with_transform(rotation(20, 30), with_transform(scaling({1, 1, 0.01}), ball({0, 0, 0}, 5, 20))));
}
TEST_CASE("a singular matrix flattens a solid to nothing") {
  check_empty(with_transform("[[1,0,0,0],[0,1,0,0],[0,0,0,0],[0,0,0,1]]", body));
  check_empty(with_transform("[[1,2,3,0],[2,4,6,0],[0,0,1,0],[0,0,0,1]]", body));
  check_seen(subtract({cube, with_transform("[[1,0,0,0],[0,0,0,0],[0,0,1,0],[0,0,0,1]]", cube)}));
}
TEST_CASE("a nearly singular matrix gives a thin solid that is drawn within the bounds") {
  for (const double thin : {1e-4, 1e-7, 1e-9}) {
    look_obliquely(with_transform(fmt::format("[[1,1,0,0],[1,{},0,0],[0,0,1,0],[0,0,0,1]]", 1.0 + thin), body));
  }
}
TEST_CASE("matrices with numbers that are not finite give nothing") {
  check_empty(with_transform("[[1,0,0,nan],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", body));
  check_empty(with_transform("[[inf,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", body));
}
TEST_CASE("sizes that are zero or negative or not finite give nothing") {
  for (const char* size : {"0", "-1", "nan", "inf", "-inf"}) {
    CAPTURE(size);
    check_empty(fmt::format("cube(size=[{},1,1],center=false);\n", size));
    check_empty(fmt::format("sphere($fn=9,$fa=12,$fs=2,r={});\n", size));
    check_empty(fmt::format("cylinder($fn=9,$fa=12,$fs=2,h={},r1=1,r2=1,center=false);\n", size));
    check_seen(unite({cube, fmt::format("sphere($fn=9,$fa=12,$fs=2,r={});\n", size)}));
  }
  check_empty("cylinder($fn=9,$fa=12,$fs=2,h=1,r1=0,r2=0,center=false);\n");
  check_empty("cylinder($fn=9,$fa=12,$fs=2,h=1,r1=-1,r2=1,center=false);\n");
}
TEST_CASE("an empty operand empties an intersection and does not affect union or difference") {
  const std::string empty = "cube(size=[0,0,0],center=false);\n";
  check_empty(intersect({cube, empty}));
  check_empty(subtract({empty, cube}));
  check_seen(subtract({cube, empty, body}));
  check_seen(unite({empty, body, "group();\n"}));
  check_empty(unite({empty, intersect({body, "group();\n"})}));
  check_empty("group();\n");
}
TEST_CASE("an intersection of disjoint solids is empty and subtracting it changes nothing") {
  const std::string disjoint = intersect({cube, box({20, 20, 20}, {30, 30, 30})});
  check_empty(disjoint);
  check_seen(subtract({body, disjoint}));
}
TEST_CASE("coefficients that do not fit are an error that names the primitive") {
  // Faces ever closer to edge-on, which the picture still has to show as surfaces.
  Look how;
  how.sampling.z_bits = 30;
  how.sampling.fraction_bits = 20;
  how.sampling.edge_on_fraction = 1e-9;
  how.memory_bits = 100;
  std::size_t errors = 0;
  std::size_t drawn = 0;
  for (int exponent = 1; exponent <= 12; ++exponent) {
    const std::string leaning =
        with_transform(fmt::format("[[1,{},0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", std::pow(10.0, -exponent)),
                       box({-8, 0, 0}, {0, 8, 8}));
    for (const Projection projection : {orthographic, perspective}) {
      const csgsim::view::Camera camera{{0, -60, 4}, {0, 4, 4}, projection};
      const std::string error = error_of(leaning, camera, how);
      if (error.empty()) {
        ++drawn;
        look(leaning, camera, how);
      } else {
        ++errors;
        CHECK(holds(error, "test:1:"));
        CHECK(holds(error, "do not fit"));
      }
    }
  }
  CHECK(errors > 4);
  CHECK(drawn > 4);
}
TEST_CASE("an error reports a size that no double holds or a camera that sees nothing") {
  CHECK(holds(error_of("cube(size=[1e400,1,1],center=false);\n", {{0, -9, 0}, {0, 0, 0}, orthographic}), "test:1:"));
  CHECK_FALSE(error_of(cube, {{1, 2, 3}, {1, 2, 3}, perspective}).empty());
}
TEST_CASE("an error states the memory needed if it exceeds that of the machine") {
  std::string deep = cube;
  for (int i = 0; i < 5; ++i)
    deep = subtract({box({0, 0, 0}, {9.0 - i, 9, 9}), intersect({unite({deep, body}), cube})});
  Look how;
  how.memory_bits = 66;
  CHECK(holds(error_of(deep, {{31, -42, 27}, {4, 5, 3}, orthographic}, how), "memory bits"));
}
