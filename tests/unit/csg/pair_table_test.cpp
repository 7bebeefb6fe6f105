#include "host/csg/pair_table.h"

#include <fmt/format.h>

#include "host/read/read.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

std::string ball(double x, double y, double z) {
  return fmt::format(
      "multmatrix([[1, 0, 0, {}], [0, 1, 0, {}], [0, 0, 1, {}], [0, 0, 0, 1]])"
      "{{ sphere($fn = 12, $fa = 12, $fs = 2, r = 5); }}",
      x, y, z);
}

struct Seen {
  model::Tree tree;
  facet::Geometry scene;
  view::View view;
};

Seen seen_from(const glm::dvec3& eye, view::Projection projection, const std::string& solids) {
  Seen seen{read::read_csg_text("group() {" + solids + "}", "test"), facet::Geometry{{}, {{}, 1}, {}}, {}};
  seen.scene = facet::make_geometry(seen.tree);
  seen.view =
      view::make_view(seen.scene, seen.tree, {eye, {0, 0, 0}, projection}, {.width = 128, .height = 128, .near = {}});
  return seen;
}

std::uint64_t supports(const csg::PairTable& pairs) { return pairs.work().supports; }

}  // namespace

TEST_CASE("PairTable searches a pair once for both orders and for every camera") {
  // The boxes of the balls meet.
  const std::string two = ball(0, 0, 0) + ball(8, 8, 8);
  const Seen first = seen_from({60, -40, 30}, view::Projection::orthographic, two);
  const Seen second = seen_from({-30, -70, 10}, view::Projection::perspective, two);
  csg::PairTable pairs(first.scene);
  isa::Preparation counted;
  CHECK(pairs.are_apart(0, 1, first.view, csg::Counted(counted)));
  const std::uint64_t searched = supports(pairs);
  const std::uint64_t points = first.scene.solids[0].vertices.size() + first.scene.solids[1].vertices.size();
  // All points in each step, and the boxes of both once for each plane that separates them.
  CHECK(searched >= points + 2);
  CHECK(searched <= 64 * (points + 2));
  CHECK(counted.supports == 1);
  CHECK(pairs.are_apart(1, 0, first.view, csg::Counted(counted)));
  CHECK(pairs.are_apart(1, 0, second.view, csg::Counted(counted)));
  CHECK(supports(pairs) == searched);
  CHECK(counted.supports == 3);
  CHECK(counted == isa::Preparation{.supports = 3});
}

TEST_CASE("PairTable finds no plane between solids that touch or meet") {
  const std::string cube = "cube(size = [10, 10, 10], center = true);";
  const std::string beside = "multmatrix([[1, 0, 0, 10], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {" + cube + "}";
  const Seen seen = seen_from({60, -40, 30}, view::Projection::orthographic, cube + beside + ball(4, 0, 0));
  csg::PairTable pairs(seen.scene);
  CHECK(!pairs.are_apart(0, 1, seen.view, {}));
  CHECK(!pairs.are_apart(0, 2, seen.view, {}));
}

TEST_CASE("PairTable estimates a search, and nothing for a pair known to have no plane") {
  const Seen seen = seen_from({60, -40, 30}, view::Projection::orthographic, ball(0, 0, 0) + ball(1, 0, 0));
  csg::PairTable pairs(seen.scene);
  const csg::Prices prices{.support = 2};
  const auto points = static_cast<double>(seen.scene.solids[0].vertices.size() + seen.scene.solids[1].vertices.size());
  CHECK(pairs.price(0, 1, prices) == 8 * points * 2);
  CHECK(!pairs.are_apart(0, 1, seen.view, {}));
  CHECK(pairs.price(1, 0, prices) == 0);
}

TEST_CASE("PairTable counts no search of an earlier frame and estimates as a new table does") {
  const Seen seen = seen_from({60, -40, 30}, view::Projection::orthographic, ball(0, 0, 0) + ball(8, 8, 8));
  csg::PairTable pairs(seen.scene);
  const csg::Prices prices{.support = 2};
  const double price = pairs.price(0, 1, prices);
  CHECK(pairs.is_in_first_frame());
  CHECK(pairs.are_apart(0, 1, seen.view, {}));
  CHECK(pairs.price(0, 1, prices) == prices.support);
  pairs.begin_frame();
  pairs.begin_program();
  CHECK(!pairs.is_in_first_frame());
  CHECK(pairs.work() == isa::Preparation{});
  CHECK(pairs.price(0, 1, prices) == price);
  CHECK(pairs.are_apart(1, 0, seen.view, {}));
  CHECK(pairs.work() == isa::Preparation{});
  CHECK(pairs.price(0, 1, prices) == prices.support);
}

TEST_CASE("a test is worthwhile if it takes at most half of the time its success saves") {
  const csg::Prices all{.instruction = 100};
  CHECK(all.is_worthwhile(1, 1e9));
  const csg::Prices weighed{.are_weighed = true, .instruction = 100};
  CHECK(weighed.is_worthwhile(4, 200));
  CHECK(!weighed.is_worthwhile(4, 200.1));
  CHECK(weighed.is_worthwhile(0, 0));
}
