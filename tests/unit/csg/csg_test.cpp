#include <rapidcheck.h>

#include "host/csg/active_tree.h"
#include "host/csg/positive_tree.h"
#include "host/facet/geometry.h"
#include "host/read/read.h"
#include "host/view/projection.h"
#include "tests/oracle/random_model.h"
#include "tests/oracle/tree_rules.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

bool evaluate(const csg::PositiveTree& tree, const std::vector<bool>& in) {
  std::vector<bool> value(tree.nodes.size());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const csg::PositiveNode& node = tree.nodes[i];
    if (node.is_leaf) {
      value[i] = in[node.primitive] != node.complemented;
      continue;
    }
    bool result = node.op == csg::PositiveOperator::intersect;
    for (const std::uint32_t child : node.children) {
      result = node.op == csg::PositiveOperator::intersect ? result && value[child] : result || value[child];
    }
    value[i] = result;
  }
  return value[tree.root];
}

struct Prepared {
  model::Tree tree;
  facet::Geometry scene;
  view::View view;
  csg::PositiveTree positive;

  /// The active tree for the whole picture.
  [[nodiscard]] csg::ActiveTree active_tree(std::uint32_t primitive, const csg::Pruning& pruning = {}) const {
    csg::PairTable pairs(scene);
    const csg::Pruner pruner(scene, view, positive, pairs, {pruning});
    const csg::Block block = pruner.surface_block({&primitive, 1}, {0, 0, 511, 511});
    return pruner.active_tree({&primitive, 1}, block);
  }
};

Prepared prepare(const std::string& text) {
  model::Tree tree = read::read_csg_text(text, "test");
  facet::Geometry scene = facet::make_geometry(tree);
  view::View view = view::make_view(scene, tree, {{30, -40, 20}, {0, 0, 0}, view::Projection::orthographic}, {});
  csg::PositiveTree positive = csg::make_positive_tree(tree);
  return {std::move(tree), std::move(scene), std::move(view), std::move(positive)};
}

std::string box(double x, double size) {
  return "multmatrix([[1,0,0," + std::to_string(x) +
         "],[0,1,0,0],[0,0,1,0],[0,0,0,1]]){cube(size=" + std::to_string(size) + ",center=true);}";
}

}  // namespace

TEST_CASE("the positive form of a tree has its value for every state of the primitives") {
  CHECK(rc::check([] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const model::Tree tree =
        read::read_csg_text(testing::random_model(seed, static_cast<unsigned>(*rc::gen::inRange(1, 20))), "test");
    const csg::PositiveTree positive = csg::make_positive_tree(tree);
    const auto in = *rc::gen::container<std::vector<bool>>(tree.primitives.size(), rc::gen::arbitrary<bool>());
    RC_ASSERT(testing::TreeRules(tree).holds(in) == evaluate(positive, in));
  }));
}

TEST_CASE("primitives joined only by unions have active trees without operands") {
  const Prepared p = prepare("union(){" + box(0, 2) + box(1, 2) + box(2, 2) + "}");
  for (std::uint32_t i = 0; i < 3; ++i) {
    CHECK_FALSE(p.active_tree(i).nothing);
    CHECK(p.active_tree(i).operands.empty());
  }
}

TEST_CASE("pruning removes disjoint operands and primitives that become empty") {
  const Prepared p =
      prepare("union(){difference(){" + box(0, 2) + box(30, 2) + "}intersection(){" + box(0, 2) + box(30, 2) + "}}");
  CHECK(p.active_tree(0).operands.empty());
  CHECK_FALSE(p.active_tree(0).nothing);
  CHECK(p.active_tree(1).nothing);
  CHECK(p.active_tree(2).nothing);
  CHECK(p.active_tree(3).nothing);
}

TEST_CASE("pruning removes an operand that surrounds a primitive") {
  const Prepared p = prepare("intersection(){" + box(0, 2) + box(0, 20) + "}");
  CHECK_FALSE(p.active_tree(0).nothing);
  CHECK(p.active_tree(0).operands.empty());
}

TEST_CASE("a primitive inside a subtracted solid is pruned") {
  const Prepared p = prepare("difference(){" + box(0, 2) + box(0, 20) + "}");
  CHECK(p.active_tree(0).nothing);
}

TEST_CASE("a chain needs one stack bit because the deepest operand is evaluated first") {
  std::string chain = "union(){" + box(0, 4) + box(0.5, 4) + "}";
  for (int i = 0; i < 6; ++i) {
    chain = "intersection(){" + box(0.1 * i, 4) + "union(){" + box(0.2 * i, 3) + chain + "}}";
  }
  const Prepared p = prepare("intersection(){" + box(0.3, 4.1) + chain + "}");
  CHECK(p.active_tree(0).bits() == 1);
}

TEST_CASE("a balanced tree of alternating operators needs one stack bit per level") {
  const auto pair = [](double x) { return "intersection(){" + box(x, 4) + box(x + 0.1, 4) + "}"; };
  const std::string four = "union(){" + pair(0) + pair(0.3) + "}";
  const std::string other = "union(){" + pair(0.2) + pair(0.4) + "}";
  const Prepared p = prepare("intersection(){" + box(0.05, 4.1) + "union(){intersection(){" + four + other +
                             "}intersection(){" + other + four + "}}}");
  csg::Pruning each_alone;
  each_alone.sets = false;
  CHECK(p.active_tree(0, each_alone).bits() == 4);
}

TEST_CASE("a tree ten thousand levels deep is pruned without exhausting the stack") {
  std::string text;
  constexpr int depth = 10'000;
  for (int i = 0; i < depth; ++i) text += i % 2 == 0 ? "difference(){" : "intersection(){";
  text += box(0, 1);
  for (int i = 0; i < depth; ++i) text += box(i % 3 == 0 ? 100 : 0.1, 2) + "}";
  const Prepared p = prepare(text);
  CHECK(p.tree.primitives.size() == depth + 1);
  CHECK_NOTHROW(static_cast<void>(p.active_tree(0)));
}

TEST_CASE("the I-tree has all operands of a primitive and the active tree the near ones") {
  // A tree like that of the thesis's figure 6.1: ((((P u A) n B) - (C - D)) u (E - F)), with D away from P.
  const Prepared p =
      prepare("union(){difference(){intersection(){union(){" + box(0, 2) + box(9, 2) + "}" + box(0.5, 2) +
              "}difference(){" + box(1, 2) + box(9.5, 2) + "}}difference(){" + box(0.1, 2) + box(0.2, 2) + "}}");
  enum : std::uint32_t { P, A, B, C, D, E, F };
  std::vector<bool> complemented;
  for (const std::uint32_t leaf : p.positive.leaf_of) complemented.push_back(p.positive.nodes[leaf].complemented);
  CHECK(complemented == std::vector<bool>{false, false, false, true, false, false, true});

  const csg::ActiveTree i_tree = p.active_tree(P, csg::Pruning::none());
  REQUIRE(i_tree.operands.size() == 2);
  CHECK(i_tree.nodes[i_tree.operands[0]].primitive == B);
  const csg::ActiveNode& hollow = i_tree.nodes[i_tree.operands[1]];
  CHECK(hollow.op == csg::PositiveOperator::unite);
  REQUIRE(hollow.children.size() == 2);
  CHECK(i_tree.nodes[hollow.children[0]].primitive == C);
  CHECK(i_tree.nodes[hollow.children[0]].complemented);
  CHECK(i_tree.nodes[hollow.children[1]].primitive == D);
  CHECK_FALSE(i_tree.nodes[hollow.children[1]].complemented);

  const csg::ActiveTree active = p.active_tree(P);
  REQUIRE(active.operands.size() == 2);
  CHECK(active.nodes[active.operands[0]].primitive == B);
  CHECK(active.nodes[active.operands[1]].primitive == C);
  CHECK(active.nodes[active.operands[1]].complemented);
}

TEST_CASE("primitives joined only by intersections are one convex set") {
  const Prepared p =
      prepare("difference(){intersection(){" + box(0, 2) + "intersection(){" + box(0.5, 2) + box(1, 2) + "}union(){" +
              box(0, 3) + box(1, 3) + "}}intersection(){" + box(0, 1) + box(0.5, 1) + "}}");
  using Sets = std::vector<csg::ConvexSet>;
  CHECK(csg::convex_sets(p.positive, true) == Sets{{0, 1, 2}, {3}, {4}, {5}, {6}});
  CHECK(csg::convex_sets(p.positive, false) == Sets{{0}, {1}, {2}, {3}, {4}, {5}, {6}});
}

TEST_CASE("primitives separated by a complemented one are not drawn as one") {
  const Prepared p =
      prepare("intersection(){difference(){" + box(0, 2) + box(0.5, 1) + "}" + box(0, 3) + box(1, 3) + "}");
  CHECK(csg::convex_sets(p.positive, true) == std::vector<csg::ConvexSet>{{0}, {1}, {2, 3}});
}

TEST_CASE("fifty subtracted intersections are one leaf each and have a single product") {
  std::string text = "difference(){" + box(0, 10);
  for (int i = 0; i < 50; ++i) text += "intersection(){" + box(0.01 * i, 2) + box(0.5 + 0.01 * i, 2) + "}";
  const Prepared p = prepare(text + "}");
  const csg::ActiveTree active = p.active_tree(0);
  REQUIRE(active.operands.size() == 50);
  for (const std::uint32_t operand : active.operands) {
    CHECK(active.nodes[operand].complemented);
    CHECK(active.nodes[operand].primitives() == 2);
  }
  CHECK(active.bits() == 0);
}
