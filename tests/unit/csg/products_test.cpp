#include "host/csg/products.h"

#include <rapidcheck.h>

#include "host/facet/geometry.h"
#include "host/read/read.h"
#include "host/view/projection.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

using namespace csg;

ActiveNode leaf(std::uint32_t primitive) { return {true, false, PositiveOperator::unite, primitive, 0, {}, {}}; }

ActiveNode node(PositiveOperator op, std::vector<std::uint32_t> children) {
  return {false, false, op, model::no_index, 0, std::move(children), {}};
}

/// All products by repeated traversal, as lists of primitives.
std::vector<std::vector<std::uint32_t>> traverse(const std::vector<ActiveNode>& nodes, std::uint32_t root) {
  std::vector<std::vector<std::uint32_t>> products;
  csg::ProductTraversal traversal(nodes, root);
  do {
    products.emplace_back();
    for (const std::uint32_t at : traversal.leaves()) products.back().push_back(nodes[at].primitive);
  } while (traversal.next());
  return products;
}

/// Products by restructuring (thesis 6.3): the leaves of product number `index` of a node from left to right, found by
/// division of the number. The rightmost union varies fastest.
std::vector<std::uint32_t> restructured(const std::vector<ActiveNode>& nodes, const std::vector<std::uint64_t>& counts,
                                        std::uint32_t root, std::uint64_t index) {
  struct Part {
    std::uint32_t node;
    std::uint64_t index;
  };
  std::vector<Part> open{{root, index}};
  std::vector<std::uint32_t> leaves;
  while (!open.empty()) {
    Part part = open.back();
    open.pop_back();
    const ActiveNode& node = nodes[part.node];
    if (node.is_leaf) {
      leaves.push_back(part.node);
    } else if (node.op == PositiveOperator::unite) {
      for (const std::uint32_t child : node.children) {
        if (part.index < counts[child]) {
          open.push_back({child, part.index});
          break;
        }
        part.index -= counts[child];
      }
    } else {
      // The last operand varies fastest; it is pushed first and therefore popped last.
      for (std::size_t i = node.children.size(); i-- > 0;) {
        const std::uint32_t child = node.children[i];
        open.push_back({child, part.index % counts[child]});
        part.index /= counts[child];
      }
    }
  }
  return leaves;
}

/// A random tree with the given number of leaves; its root is the last node.
std::vector<ActiveNode> random_tree(std::uint32_t leaves) {
  std::vector<ActiveNode> nodes;
  std::vector<std::uint32_t> roots;
  for (std::uint32_t i = 0; i < leaves; ++i) {
    nodes.push_back(leaf(i));
    roots.push_back(i);
  }
  while (roots.size() > 1) {
    const auto first = static_cast<std::size_t>(*rc::gen::inRange<std::size_t>(0, roots.size() - 1));
    const std::size_t most = std::min<std::size_t>(3, roots.size() - first);
    const auto count = static_cast<std::ptrdiff_t>(*rc::gen::inRange<std::size_t>(2, most + 1));
    const auto begin = roots.begin() + static_cast<std::ptrdiff_t>(first);
    const auto op = *rc::gen::arbitrary<bool>() ? PositiveOperator::unite : PositiveOperator::intersect;
    nodes.push_back(node(op, {begin, begin + count}));
    *begin = static_cast<std::uint32_t>(nodes.size() - 1);
    roots.erase(begin + 1, begin + count);
  }
  return nodes;
}

std::string cube(double x, double y, double size) {
  return "multmatrix([[1,0,0," + std::to_string(x) + "],[0,1,0," + std::to_string(y) +
         "],[0,0,1,0],[0,0,0,1]]){cube(size=" + std::to_string(size) + ",center=true);}";
}

}  // namespace

TEST_CASE("the active tree of P in thesis fig. 6.2 has the products QS and QT and RS and RT") {
  enum : std::uint32_t { Q, R, S, T };
  const std::vector<ActiveNode> nodes{leaf(Q),
                                      leaf(R),
                                      leaf(S),
                                      leaf(T),
                                      node(PositiveOperator::unite, {0, 1}),
                                      node(PositiveOperator::unite, {2, 3}),
                                      node(PositiveOperator::intersect, {4, 5})};
  const std::vector<std::vector<std::uint32_t>> expected{{Q, S}, {Q, T}, {R, S}, {R, T}};
  CHECK(traverse(nodes, 6) == expected);
  const std::vector<std::uint64_t> counts = csg::count_products(nodes);
  CHECK(counts[6] == 4);
  for (std::uint64_t i = 0; i < 4; ++i) CHECK(restructured(nodes, counts, 6, i) == expected[i]);
}

TEST_CASE("operands that do not touch P in thesis fig. 6.2 are pruned from its tree") {
  // Object = X u ((P n (Q u R u W)) n ((S u T) - V)), with W, V and X away from P.
  const std::string text = "union(){" + cube(90, 0, 2) + "intersection(){intersection(){" + cube(0, 0, 4) + "union(){" +
                           cube(-1, 0, 4) + cube(1, 0, 4) + cube(60, 0, 2) + "}}difference(){union(){" +
                           cube(0, -1, 4.5) + cube(0, 1, 4.5) + "}" + cube(0, 60, 2) + "}}}";
  enum : std::uint32_t { X, P, Q, R, W, S, T, V };
  const model::Tree tree = read::read_csg_text(text, "test");
  const facet::Geometry scene = facet::make_geometry(tree);
  const view::View view = view::make_view(scene, tree, {{30, -40, 400}, {0, 0, 0}, view::Projection::orthographic}, {});
  const csg::PositiveTree positive = csg::make_positive_tree(tree);
  csg::PairTable pairs(scene);
  const csg::Pruner pruner(scene, view, positive, pairs);
  const csg::ConvexSet set{P};
  const csg::ActiveTree active = pruner.active_tree(set, pruner.surface_block(set, {0, 0, 511, 511}));
  REQUIRE(active.operands.size() == 2);
  const auto union_of = [&](std::uint32_t operand) {
    const ActiveNode& at = active.nodes[operand];
    CHECK(at.op == PositiveOperator::unite);
    std::vector<std::uint32_t> primitives;
    for (const std::uint32_t child : at.children) primitives.push_back(active.nodes[child].primitive);
    return primitives;
  };
  CHECK(union_of(active.operands[0]) == std::vector<std::uint32_t>{Q, R});
  CHECK(union_of(active.operands[1]) == std::vector<std::uint32_t>{S, T});
  CHECK(active.depth() == 3);
}

TEST_CASE("restructuring and repeated traversal give the same products in order") {
  CHECK(rc::check([] {
    const auto leaves = *rc::gen::inRange<std::uint32_t>(1, 14);
    const std::vector<ActiveNode> nodes = random_tree(leaves);
    const auto root = static_cast<std::uint32_t>(nodes.size() - 1);
    const std::vector<std::uint64_t> counts = csg::count_products(nodes);
    const auto products = traverse(nodes, root);
    RC_ASSERT(products.size() == counts[root]);
    for (std::uint64_t i = 0; i < products.size(); ++i) {
      RC_ASSERT(restructured(nodes, counts, root, i) == products[i]);
    }
  }));
}

TEST_CASE("the sum of a tree's products has the tree's value for all assignments") {
  CHECK(rc::check([] {
    const auto leaves = *rc::gen::inRange<std::uint32_t>(1, 12);
    const std::vector<ActiveNode> nodes = random_tree(leaves);
    const auto in = *rc::gen::container<std::vector<bool>>(leaves, rc::gen::arbitrary<bool>());
    std::vector<bool> value;
    for (const ActiveNode& at : nodes) {
      bool result = at.is_leaf ? in[at.primitive] : at.op == PositiveOperator::intersect;
      for (const std::uint32_t child : at.children) {
        result = at.op == PositiveOperator::intersect ? result && value[child] : result || value[child];
      }
      value.push_back(result);
    }
    bool sum = false;
    for (const auto& product : traverse(nodes, static_cast<std::uint32_t>(nodes.size() - 1))) {
      sum = sum || std::all_of(product.begin(), product.end(), [&](std::uint32_t p) { return in[p]; });
    }
    RC_ASSERT(sum == value.back());
  }));
}

TEST_CASE("a number of products that overflows is reported as countless") {
  std::vector<ActiveNode> nodes;
  std::vector<std::uint32_t> pairs;
  for (std::uint32_t i = 0; i < 64; ++i) {
    nodes.push_back(leaf(2 * i));
    nodes.push_back(leaf(2 * i + 1));
    nodes.push_back(node(PositiveOperator::unite, {3 * i, 3 * i + 1}));
    pairs.push_back(3 * i + 2);
  }
  nodes.push_back(node(PositiveOperator::intersect, pairs));
  nodes.push_back(node(PositiveOperator::unite, {static_cast<std::uint32_t>(nodes.size() - 1), 0}));
  CHECK(csg::count_products(nodes)[nodes.size() - 2] == csg::countless);
  CHECK(csg::count_products(nodes).back() == csg::countless);
  nodes[nodes.size() - 2].children.pop_back();
  CHECK(csg::count_products(nodes)[nodes.size() - 2] == 1ULL << 63U);
}
