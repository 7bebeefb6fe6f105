#include "tests/m68000/traversal.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <vector>

#include "tests/m68000/random_tree.h"

using namespace csgsim::m68000;

namespace {

const std::vector<Method> methods{Method::standard, Method::early_out, Method::status_tree};
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

TEST_CASE("programs of all methods, by hand and compiled, classify points of random trees as the tree says") {
  rc::check([](std::uint32_t seed) {
    const RandomTree random(seed);
    const std::size_t primitives = random.primitives();
    for (const Method method : methods) {
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
}

// Clocks of the instructions in the order of programs.s, by the tables of the MC68000 User's Manual.

TEST_CASE("the standard traversal takes the clocks that its instructions add up to") {
  const std::uint64_t leaf = 8 + 10 + 12 + 14 + 16;
  const std::uint64_t both = 8 + 8 + 12 + 16 + 18 + leaf + 12 + 8 + 16 + 18 + leaf + 8 + 12 + 12;
  for (const std::vector<std::uint16_t>& in : {std::vector<std::uint16_t>{}, {0}, {1}, {0, 1}}) {
    CHECK(clocks_of_evaluation(Method::standard, NodeKind::set_union, in) == both + 10 + 4 + 16);
    CHECK(clocks_of_evaluation(Method::standard, NodeKind::difference, in) == both + 8 + 10 + 4 + 4 + 16);
    CHECK(clocks_of_evaluation(Method::standard, NodeKind::intersection, in) == both + 8 + 8 + 4 + 16);
  }
}

TEST_CASE("early out takes a node's right side only where the left one does not decide") {
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

TEST_CASE("a status tree takes a flip up to where nothing changes") {
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

TEST_CASE("what depends on the tree alone costs the same at every point, and a primitive alone has no node") {
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

TEST_CASE("a tree of too many nodes is refused") {
  M68000Traversal traversal(Method::standard);
  Tree tree;
  tree.nodes.resize(2048);
  CHECK_THROWS_AS(traversal.load(tree), std::out_of_range);
}
