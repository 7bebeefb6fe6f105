#include "tests/m68000/traversal.h"

#include <rapidcheck.h>

#include "tests/m68000/developed_tree.h"
#include "tests/m68000/random_tree.h"
#include "tests/support/test.h"

using namespace csgsim::m68000;

namespace {

const std::vector<Method> methods{Method::standard, Method::early_out, Method::status_tree, Method::bit_parallel,
                                  Method::positional};
const std::vector<Written> written_in{Written::by_hand, Written::compiled_plainly, Written::compiled_optimised};

bool value_of(const Tree& tree, std::size_t index, const std::vector<bool>& statuses) {
  const TreeNode& node = tree.nodes[index];
  if (node.kind == NodeKind::primitive) return statuses[node.primitive];
  const bool left = value_of(tree, node.left, statuses);
  const bool right = value_of(tree, node.right, statuses);
  if (node.kind == NodeKind::set_union) return left || right;
  return left && (node.kind == NodeKind::difference ? !right : right);
}

Tree tree_of_two(NodeKind kind) {
  return {{{NodeKind::primitive, 0, 0, 0}, {NodeKind::primitive, 1, 0, 0}, {kind, 0, 0, 1}}, 2};
}

std::uint64_t clocks_of_evaluation(Method method, NodeKind kind, const std::vector<std::uint16_t>& in) {
  M68000Traversal traversal(method);
  traversal.load(tree_of_two(kind));
  for (const std::uint16_t primitive : in) traversal.flip(primitive);
  traversal.evaluate();
  return traversal.last_clocks();
}

std::uint64_t clocks_of_last_flip(NodeKind kind, const std::vector<std::uint16_t>& flips) {
  M68000Traversal traversal(Method::status_tree);
  traversal.load(tree_of_two(kind));
  for (const std::uint16_t primitive : flips) traversal.flip(primitive);
  return traversal.last_clocks();
}

}  // namespace

TEST_CASE("every method's program classifies points as the random tree does") {
  unsigned of_bits = 0;
  rc::check([&of_bits](std::uint32_t seed, bool is_small) {
    const RandomTree random(seed, is_small ? 20 : 60);
    const std::size_t primitives = random.primitives();
    const bool bits_fit = levels_of(random.tree()) <= most_levels;
    of_bits += bits_fit ? 1 : 0;
    for (const Method method : methods) {
      if (method == Method::bit_parallel && !bits_fit) continue;
      for (const Written written : written_in) {
        M68000Traversal traversal(method, written);
        traversal.load(random.tree());
        std::vector<bool> statuses(primitives);
        RC_ASSERT(!traversal.evaluate());
        std::uint64_t clocks = traversal.clocks();
        for (const std::uint16_t primitive : random.flips()) {
          traversal.flip(primitive);
          clocks += traversal.last_clocks();
          statuses[primitive] = !statuses[primitive];
          RC_ASSERT(traversal.evaluate() == value_of(random.tree(), random.tree().root, statuses));
          clocks += traversal.last_clocks();
        }
        RC_ASSERT(traversal.clocks() == clocks);
      }
    }
  });
  if (csgsim::testing::draws_usual_cases()) CHECK(of_bits > 20);
}

TEST_CASE("reloading a tree starts outside every primitive with zero clocks") {
  for (const Method method : methods) {
    M68000Traversal traversal(method);
    for (const NodeKind kind : {NodeKind::set_union, NodeKind::difference}) {
      traversal.load(tree_of_two(kind));
      CHECK(traversal.clocks() == 0);
      CHECK(!traversal.evaluate());
      traversal.flip(0);
      CHECK(traversal.evaluate());
    }
  }
}

// Clocks of the instructions in the order of programs.s, from the tables of the MC68000 User's Manual.

TEST_CASE("the standard traversal takes the sum of its instructions' clocks") {
  const std::uint64_t leaf = 8 + 10 + 12 + 14 + 16;
  const std::uint64_t both = 8 + 8 + 12 + 16 + 18 + leaf + 12 + 8 + 16 + 18 + leaf + 8 + 12 + 12;
  for (const std::vector<std::uint16_t>& in : {std::vector<std::uint16_t>{}, {0}, {1}, {0, 1}}) {
    CHECK(clocks_of_evaluation(Method::standard, NodeKind::set_union, in) == both + 10 + 4 + 16);
    CHECK(clocks_of_evaluation(Method::standard, NodeKind::difference, in) == both + 8 + 10 + 4 + 4 + 16);
    CHECK(clocks_of_evaluation(Method::standard, NodeKind::intersection, in) == both + 8 + 8 + 4 + 16);
  }
}

TEST_CASE("early out evaluates a node's right side only if the left one does not decide") {
  const std::uint64_t leaf = 8 + 10 + 12 + 14 + 16;
  const std::uint64_t left = 8 + 8 + 12 + 16 + 18 + leaf + 12 + 12;
  const std::uint64_t right = 16 + 18 + leaf;
  CHECK(clocks_of_evaluation(Method::early_out, NodeKind::set_union, {0}) == left + 10 + 4 + 10 + 16);
  CHECK(clocks_of_evaluation(Method::early_out, NodeKind::set_union, {1}) == left + 10 + 4 + 8 + right + 16);
  CHECK(clocks_of_evaluation(Method::early_out, NodeKind::difference, {}) == left + 8 + 10 + 4 + 10 + 16);
  CHECK(clocks_of_evaluation(Method::early_out, NodeKind::difference, {0}) == left + 8 + 10 + 4 + 8 + right + 4 + 16);
  CHECK(clocks_of_evaluation(Method::early_out, NodeKind::intersection, {1}) == left + 8 + 8 + 4 + 10 + 16);
  CHECK(clocks_of_evaluation(Method::early_out, NodeKind::intersection, {0}) == left + 8 + 8 + 4 + 8 + 10 + right + 16);
}

TEST_CASE("a status tree propagates a flip up to the first unchanged node") {
  const std::uint64_t leaf = 4 + 4 + 18 + 16;
  const std::uint64_t up = 16 + 8 + 4 + 16 + 12 + 16 + 12;
  const std::uint64_t united = 10 + 12 + 12;
  const std::uint64_t intersected = 8 + 10 + 12 + 10 + 12;
  const std::uint64_t subtracted = 8 + 8 + 4 + 12 + 10 + 12;
  const std::uint64_t changed = 8 + 12 + 10 + 16 + 10 + 16;
  const std::uint64_t unchanged = 10 + 16;
  CHECK(clocks_of_last_flip(NodeKind::set_union, {0}) == leaf + up + united + changed);
  CHECK(clocks_of_last_flip(NodeKind::set_union, {0, 1}) == leaf + up + united + unchanged);
  CHECK(clocks_of_last_flip(NodeKind::intersection, {0}) == leaf + up + intersected + unchanged);
  CHECK(clocks_of_last_flip(NodeKind::intersection, {0, 1}) == leaf + up + intersected + changed);
  CHECK(clocks_of_last_flip(NodeKind::difference, {1}) == leaf + up + subtracted + unchanged);
  CHECK(clocks_of_last_flip(NodeKind::difference, {1, 0}) == leaf + up + subtracted + unchanged);
  CHECK(clocks_of_last_flip(NodeKind::difference, {0, 1}) == leaf + up + subtracted + changed);
}

TEST_CASE("the bit-parallel method takes clocks for each level and each bit of its shifts") {
  // The union of 0 and (1 minus 2), with one extra level.
  const Tree tree{{{NodeKind::primitive, 0, 0, 0},
                   {NodeKind::primitive, 1, 0, 0},
                   {NodeKind::primitive, 2, 0, 0},
                   {NodeKind::difference, 0, 1, 2},
                   {NodeKind::set_union, 0, 0, 3}},
                  4};
  const DevelopedTree developed = develop(tree);
  CHECK(developed.inverted == std::vector<std::uint32_t>{0x5000'0000, 0xa000'0000});
  CHECK(developed.bits ==
        std::vector<std::pair<std::uint16_t, std::uint32_t>>{{0, 0x8000'0000}, {1, 0x2000'0000}, {2, 0x1000'0000}});
  M68000Traversal traversal(Method::bit_parallel);
  traversal.load(tree);
  traversal.flip(1);
  CHECK(traversal.last_clocks() == 4 + 4 + 18 + 20 + 16);
  CHECK(traversal.evaluate());
  const std::uint64_t level = 12 + 8 + 4 + 8 + 8 + 8 + 4;
  CHECK(traversal.last_clocks() == 12 + 8 + 4 + (level + 2 + 10) + (level + 4 + 14) + 16);
}

TEST_CASE("positional coding takes the clocks of its list and of the nodes on the path") {
  M68000Traversal traversal(Method::positional);
  traversal.load(tree_of_two(NodeKind::set_union));
  CHECK(!traversal.evaluate());
  CHECK(traversal.last_clocks() == 8 + 12 + 8 + 4 + 16);
  traversal.flip(0);
  const std::uint64_t moved = 12 + 8 + 8 + 4 + 8 + 10;
  CHECK(traversal.last_clocks() == 4 + 14 + 8 + 4 + 8 + 8 + moved + 12 + 8 + 10 + 16);
  CHECK(traversal.evaluate());
  const std::uint64_t leaf = 8 + 10 + 8 + 4 + 16;
  const std::uint64_t left = 8 + 8 + 12 + 8 + 12 + 16 + 18 + leaf + 12 + 4 + 8 + 12 + 10 + 4 + 10 + 12 + 8 + 16;
  CHECK(traversal.last_clocks() == 8 + 12 + 10 + left);
  traversal.flip(0);
  CHECK(traversal.last_clocks() == 4 + 14 + 8 + 4 + 8 + 10 + 8 + 12 + 8 + 8 + 16);
}

TEST_CASE("costs that depend on the tree alone are equal at every point") {
  const RandomTree random(7);
  M68000Traversal traversal(Method::standard);
  traversal.load(random.tree());
  traversal.evaluate();
  const std::uint64_t clocks = traversal.last_clocks();
  for (const std::uint16_t primitive : random.flips()) {
    traversal.flip(primitive);
    CHECK(traversal.last_clocks() == 4 + 18 + 16);
    traversal.evaluate();
    CHECK(traversal.last_clocks() == clocks);
  }
  M68000Traversal one(Method::status_tree);
  one.load({{{NodeKind::primitive, 0, 0, 0}}, 0});
  one.flip(0);
  CHECK(one.last_clocks() == 4 + 4 + 18 + 16 + 16 + 10 + 16);
  CHECK(one.evaluate());
  CHECK(one.last_clocks() == 12 + 16);
}

TEST_CASE("rejects a tree with too many nodes or levels") {
  M68000Traversal traversal(Method::standard);
  Tree tree;
  tree.nodes.resize(2048);
  CHECK_THROWS_AS(traversal.load(tree), std::out_of_range);
  Tree chain = tree_of_two(NodeKind::set_union);
  M68000Traversal bits(Method::bit_parallel);
  for (std::uint16_t primitive = 2; primitive < 6; ++primitive) {
    chain.nodes.push_back({NodeKind::primitive, primitive, 0, 0});
    chain.nodes.push_back({NodeKind::set_union, 0, chain.root, chain.nodes.size() - 1});
    chain.root = chain.nodes.size() - 1;
  }
  CHECK_NOTHROW(bits.load(chain));
  chain.nodes.push_back({NodeKind::primitive, 6, 0, 0});
  chain.nodes.push_back({NodeKind::set_union, 0, chain.root, chain.nodes.size() - 1});
  chain.root = chain.nodes.size() - 1;
  CHECK_THROWS_AS(bits.load(chain), std::out_of_range);
}
