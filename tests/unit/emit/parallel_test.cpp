#include "host/emit/parallel.h"

#include <rapidcheck.h>

#include "host/csg/products.h"
#include "hw/isa/opcodes.h"
#include "hw/machines/clocks.h"
#include "hw/pixel_planes/kind.h"
#include "sim/reference/reference_array.h"
#include "tests/support/test.h"
#include "tests/unit/csg/list_trees.h"

using namespace csgsim;
using namespace csgsim::testing;

namespace {

constexpr unsigned base = 3;  ///< base of the string in pixel memory
constexpr unsigned alu_widths[] = {1, 2, 3, 8, 24, 32};

/// Values of the leaves at each pixel.
using Assignments = std::vector<std::vector<bool>>;

isa::Segment levels_of(const csg::BitString& string, std::size_t pixels, unsigned alu_bits) {
  isa::Segment segment;
  segment.region = {0, 0, static_cast<std::uint32_t>(pixels), 1};
  emit::Broadcast out(segment, {});
  emit::emit_string_levels(out, string, base, alu_bits);
  return segment;
}

/// Value of the root at each pixel, computed by the reference engine.
std::vector<bool> evaluate_string(const csg::RootedTree& tree, const Assignments& pixels, unsigned alu_bits) {
  const csg::BitString string = csg::make_bit_string(tree.nodes, tree.root);
  const auto width = static_cast<std::uint32_t>(pixels.size());
  const auto memory_bits = static_cast<std::uint32_t>(base + string.leaves.size());
  reference::ReferenceArray array(isa::ArrayShape{width, 1, memory_bits});
  array.execute({isa::Opcode::enable_all, {}, {}, 0, {}});
  for (std::uint32_t x = 0; x < width; ++x) {
    for (std::size_t i = 0; i < string.leaves.size(); ++i) {
      const isa::Field bit{static_cast<std::uint16_t>(base + i), 1};
      array.write(bit, x, 0, pixels[x][tree.nodes[string.leaves[i]].primitive] ? 1 : 0);
    }
  }
  for (const isa::Instruction& instruction : levels_of(string, width, alu_bits).instructions) {
    isa::validate(instruction, memory_bits);
    array.execute(instruction);
  }
  std::vector<bool> results;
  for (std::uint32_t x = 0; x < width; ++x) results.push_back((array.read({base, 1}, x, 0) == 1) != string.inverted);
  return results;
}

std::vector<bool> expected(const ActiveTree& tree, const Assignments& pixels) {
  std::vector<bool> results;
  for (const std::vector<bool>& in : pixels) results.push_back(evaluate(tree, in));
  return results;
}

Assignments every_assignment(std::size_t leaves) {
  Assignments pixels;
  for (std::uint32_t assignment = 0; assignment < 1U << leaves; ++assignment) {
    pixels.emplace_back();
    for (std::size_t i = 0; i < leaves; ++i) pixels.back().push_back((assignment >> i & 1U) != 0);
  }
  return pixels;
}

/// Leaves are true with a probability of 1/8, 1/2 or 7/8, so that deep trees take both values.
Assignments some_assignments(std::size_t leaves, std::size_t count) {
  std::mt19937 engine(*rc::gen::arbitrary<std::uint32_t>());
  Assignments pixels(count);
  for (std::size_t x = 0; x < count; ++x) {
    for (std::size_t i = 0; i < leaves; ++i) pixels[x].push_back(engine() % 8 < (x % 3 == 0 ? 1 : x % 3 == 1 ? 4 : 7));
  }
  return pixels;
}

std::uint64_t clocks_of(const csg::BitString& string, unsigned written_for, unsigned alu_bits) {
  machines::Machine machine = machines::blank_machine(pixel_planes::kind);
  machine.alu_bits = alu_bits;
  std::uint64_t clocks = 0;
  for (const isa::Instruction& instruction : levels_of(string, 1, written_for).instructions) {
    clocks += machines::clocks(instruction, machine);
  }
  return clocks;
}

}  // namespace

TEST_CASE("strategy parallel evaluates A - (B and C) of the thesis's fig. 4.13") {
  ActiveTree tree;
  const std::uint32_t a = add_leaf(tree, 0);
  const std::uint32_t b = add_leaf(tree, 1, true);
  const std::uint32_t c = add_leaf(tree, 2, true);
  tree.operands = {a, add_operator(tree, PositiveOperator::unite, {b, c})};
  const csg::RootedTree rooted = csg::make_rooted_tree(tree);
  CHECK(evaluate_string(rooted, {{true, false, true}}, 1) == std::vector<bool>{true});
  // B and C both in, or A out: the pixel is out.
  CHECK(evaluate_string(rooted, {{true, true, true}, {false, false, true}}, 1) == std::vector<bool>{false, false});
}

TEST_CASE("strategy parallel matches Boolean evaluation for random trees") {
  CHECK(rc::check([] {
    const ActiveTree tree = any_tree(8);
    const Assignments pixels = every_assignment(leaves_of(tree));
    const csg::RootedTree rooted = csg::make_rooted_tree(tree);
    for (const unsigned alu_bits : alu_widths) {
      RC_ASSERT(evaluate_string(rooted, pixels, alu_bits) == expected(tree, pixels));
    }
  }));
}

TEST_CASE("strategy parallel matches Boolean evaluation for bit strings of several fields") {
  CHECK(rc::check([] {
    const ActiveTree tree = any_tree(300);
    const Assignments pixels = some_assignments(leaves_of(tree), 24);
    const csg::RootedTree rooted = csg::make_rooted_tree(tree);
    for (const unsigned alu_bits : alu_widths) {
      RC_ASSERT(evaluate_string(rooted, pixels, alu_bits) == expected(tree, pixels));
    }
  }));
}

TEST_CASE("instructions of strategy parallel for an ALU are fastest on that ALU") {
  CHECK(rc::check([] {
    const csg::RootedTree rooted = csg::make_rooted_tree(any_tree(200));
    const csg::BitString string = csg::make_bit_string(rooted.nodes, rooted.root);
    for (const unsigned alu_bits : alu_widths) {
      for (const unsigned other : alu_widths) {
        RC_ASSERT(clocks_of(string, alu_bits, alu_bits) <= clocks_of(string, other, alu_bits));
      }
    }
    RC_ASSERT(clocks_of(string, 8, 8) <= clocks_of(string, 2, 2));
    RC_ASSERT(clocks_of(string, 32, 32) <= clocks_of(string, 8, 8));
  }));
}

TEST_CASE("a union of 32 leaves takes an inversion and five ANDs") {
  ActiveTree tree;
  std::vector<std::uint32_t> leaves;
  for (std::uint32_t i = 0; i < 32; ++i) leaves.push_back(add_leaf(tree, i));
  tree.operands = {add_operator(tree, PositiveOperator::unite, leaves)};
  const csg::BitString string = csg::make_bit_string(tree.nodes, tree.operands.front());
  CHECK(clocks_of(string, 1, 1) == 32 + 2 * (16 + 8 + 4 + 2 + 1));
  CHECK(clocks_of(string, 32, 32) == 1 + 2 * 5);
}

TEST_CASE("a bit string takes the bits of its largest operand and none for a leaf") {
  ActiveTree tree;
  const std::uint32_t alone = add_leaf(tree, 0);
  const std::uint32_t two = add_operator(tree, PositiveOperator::unite, {add_leaf(tree, 1), add_leaf(tree, 2)});
  const std::uint32_t more =
      add_operator(tree, PositiveOperator::unite, {add_leaf(tree, 3), add_leaf(tree, 4), add_leaf(tree, 5)});
  tree.operands = {alone};
  CHECK(emit::string_bits(tree) == 0);
  tree.operands = {alone, two, more};
  CHECK(emit::string_bits(tree) == 3);
}
