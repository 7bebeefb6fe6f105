#include "sim/judges/possible.h"

#include "sim/judges/truth.h"
#include "tests/support/test.h"

using namespace csgsim;
using namespace judges;

namespace {

/// Two primitives under one operator.
model::Tree pair(model::Operator op) {
  model::Tree tree;
  tree.primitives.resize(2);
  tree.nodes = {{true, {}, 0, {}}, {true, {}, 1, {}}, {false, op, model::no_index, {0, 1}}};
  tree.root = 2;
  return tree;
}

/// A primitive between planes `first` and `first + 1`, without edges.
Candidate between(std::uint32_t primitive, std::uint32_t first, judges::Steps front, judges::Steps back) {
  return {primitive, {}, {{first, front}}, {{first + 1, back}}, false};
}

}  // namespace

TEST_CASE("a surface must be shown at one of its possible depths") {
  const Ray ray{{between(0, 0, {10, 11}, {20, 20})}, {}};
  const model::Tree tree = pair(model::Operator::unite);
  CHECK_FALSE(can_show(tree, ray, 0, 9));
  CHECK(can_show(tree, ray, 0, 10));
  CHECK(can_show(tree, ray, 0, 11));
  CHECK_FALSE(can_show(tree, ray, 0, 12));
  CHECK_FALSE(can_show(tree, ray, 1, 10));
  CHECK_FALSE(can_show(tree, ray, nothing, 0));
}

TEST_CASE("a solid with front and back in one depth step may be missing") {
  const Ray ray{{between(0, 0, {10, 11}, {11, 12})}, {}};
  const model::Tree tree = pair(model::Operator::unite);
  CHECK(can_show(tree, ray, 0, 10));
  CHECK(can_show(tree, ray, nothing, 0));
}

TEST_CASE("the farther of two surfaces is possible only if their depths overlap") {
  const model::Tree tree = pair(model::Operator::unite);
  const Ray overlapping{{between(0, 0, {10, 12}, {90, 90}), between(1, 2, {12, 13}, {90, 90})}, {}};
  CHECK(can_show(tree, overlapping, 0, 12));
  CHECK_FALSE(can_show(tree, overlapping, 1, 13));
  const Ray second_nearer{{between(0, 0, {12, 13}, {90, 90}), between(1, 2, {10, 12}, {90, 90})}, {}};
  CHECK(can_show(tree, second_nearer, 0, 12));
  CHECK(can_show(tree, second_nearer, 1, 12));
  const Ray apart{{between(0, 0, {12, 13}, {90, 90}), between(1, 2, {10, 11}, {90, 90})}, {}};
  CHECK_FALSE(can_show(tree, apart, 0, 12));
  CHECK(can_show(tree, apart, 1, 11));
}

TEST_CASE("two fronts on one plane have equal depths and show the first primitive") {
  const Ray ray{{between(0, 0, {10, 12}, {90, 90}), {1, {}, {{0, {10, 12}}}, {{7, {80, 80}}}, false}}, {}};
  CHECK(can_show(pair(model::Operator::unite), ray, 0, 11));
  CHECK_FALSE(can_show(pair(model::Operator::unite), ray, 1, 11));
}

TEST_CASE("the farthest of several fronts is behind each of them") {
  const Candidate corner{0, {}, {{0, {10, 12}}, {1, {11, 13}}}, {{2, {80, 80}}}, false};
  const Candidate wall{1, {}, {{1, {11, 13}}}, {{3, {80, 80}}}, false};
  CHECK_FALSE(can_show(pair(model::Operator::intersect), {{corner, wall}, {}}, nothing, 0));
}

TEST_CASE("a subtracted solid with a flush front leaves no membrane") {
  const Ray ray{{between(0, 0, {10, 12}, {90, 90}), {1, {}, {{0, {10, 12}}}, {{7, {80, 81}}}, false}}, {}};
  const model::Tree tree = pair(model::Operator::subtract);
  CHECK_FALSE(can_show(tree, ray, 0, 11));
  CHECK(can_show(tree, ray, 1, 80));
  CHECK_FALSE(can_show(tree, ray, nothing, 0));
}

TEST_CASE("touching solids have an empty intersection") {
  const Ray ray{{between(0, 0, {10, 12}, {20, 22}), {1, {}, {{1, {20, 22}}}, {{7, {80, 81}}}, false}}, {}};
  const model::Tree tree = pair(model::Operator::intersect);
  CHECK(can_show(tree, ray, nothing, 0));
  CHECK_FALSE(can_show(tree, ray, 0, 12));
  CHECK_FALSE(can_show(tree, ray, 1, 21));
}

TEST_CASE("exactly one of two solids on both sides of an undecided edge is present") {
  Candidate left = between(0, 0, {10, 10}, {20, 20});
  Candidate right = between(1, 0, {10, 10}, {20, 20});
  left.edges = {{5, true}};
  right.edges = {{5, false}};
  const Ray ray{{left, right}, {5}};
  const model::Tree both = pair(model::Operator::unite);
  CHECK(can_show(both, ray, 0, 10));
  CHECK(can_show(both, ray, 1, 10));
  CHECK_FALSE(can_show(both, ray, nothing, 0));
  CHECK_FALSE(can_show(pair(model::Operator::intersect), ray, 0, 10));
  CHECK(can_show(both, {{left}, {5}}, nothing, 0));
}

TEST_CASE("a doubtful primitive may be shown or missing but hides nothing") {
  Candidate doubtful = between(0, 0, {10, 10}, {20, 20});
  doubtful.is_doubtful = true;
  const Ray ray{{doubtful, between(1, 2, {15, 15}, {30, 30})}, {}};
  const model::Tree tree = pair(model::Operator::unite);
  CHECK(can_show(tree, ray, 0, 10));
  CHECK(can_show(tree, ray, 1, 15));
  CHECK_FALSE(can_show(tree, ray, nothing, 0));
}