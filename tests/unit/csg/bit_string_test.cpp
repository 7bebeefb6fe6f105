#include "host/csg/bit_string.h"

#include <rapidcheck.h>

#include "host/csg/products.h"
#include "tests/support/test.h"
#include "tests/unit/csg/list_trees.h"

using namespace csgsim;
using namespace csgsim::testing;

namespace {

/// Evaluates the string by the method of the thesis from the primitives that contain the point.
bool evaluate_string(const csg::BitString& string, const std::vector<csg::ActiveNode>& nodes,
                     const std::vector<bool>& in) {
  std::vector<bool> bits;
  for (const std::uint32_t leaf : string.leaves) bits.push_back(in[nodes[leaf].primitive]);
  for (const csg::StringLevel& level : string.levels) {
    for (const std::uint32_t position : level.inverted) bits[position] = !bits[position];
    for (const csg::AndRun& meeting : level.and_runs) {
      for (std::uint32_t i = 0; i < meeting.bits; ++i) {
        bits[meeting.first + i] = bits[meeting.first + i] && bits[meeting.second + i];
      }
    }
  }
  return bits.front() != string.inverted;
}

bool is_correct_for_all_assignments(const ActiveTree& tree) {
  const csg::RootedTree rooted = csg::make_rooted_tree(tree);
  const csg::BitString string = csg::make_bit_string(rooted.nodes, rooted.root);
  const std::size_t leaves = leaves_of(tree);
  for (std::uint32_t assignment = 0; assignment < 1U << leaves; ++assignment) {
    std::vector<bool> in;
    for (std::size_t i = 0; i < leaves; ++i) in.push_back((assignment >> i & 1U) != 0);
    if (evaluate_string(string, rooted.nodes, in) != evaluate(tree, in)) return false;
  }
  return true;
}

csg::BitString string_of(std::string_view text) {
  ActiveTree tree;
  const std::uint32_t root = add_text(tree, text);
  return csg::make_bit_string(tree.nodes, root);
}

std::uint32_t ceil_log2(std::size_t number) { return static_cast<std::uint32_t>(std::bit_width(number - 1)); }

}  // namespace

TEST_CASE("a bit string matches Boolean evaluation for all small trees and assignments") {
  for_all_trees(7, [](const ActiveTree& tree, std::uint32_t) { CHECK(is_correct_for_all_assignments(tree)); });
}

TEST_CASE("a bit string matches Boolean evaluation for random trees and all assignments") {
  CHECK(rc::check([] { RC_ASSERT(is_correct_for_all_assignments(any_tree(10))); }));
}

TEST_CASE("every leaf has one bit of the string and a combined bit is not used again") {
  CHECK(rc::check([] {
    const ActiveTree tree = any_tree(60);
    const csg::RootedTree rooted = csg::make_rooted_tree(tree);
    const csg::BitString string = csg::make_bit_string(rooted.nodes, rooted.root);
    std::vector<bool> seen(leaves_of(tree), false);
    for (const std::uint32_t leaf : string.leaves) {
      const std::uint32_t primitive = rooted.nodes[leaf].primitive;
      RC_ASSERT(!seen[primitive]);
      seen[primitive] = true;
    }
    RC_ASSERT(string.leaves.size() == seen.size());
    RC_ASSERT(csg::count_leaves(rooted.nodes, rooted.root) == seen.size());
    std::vector<bool> alive(seen.size(), true);
    for (const csg::StringLevel& level : string.levels) {
      for (const std::uint32_t position : level.inverted) RC_ASSERT(alive[position]);
      for (const csg::AndRun& meeting : level.and_runs) {
        for (std::uint32_t i = 0; i < meeting.bits; ++i) {
          RC_ASSERT(alive[meeting.first + i]);
          RC_ASSERT(alive[meeting.second + i]);
          alive[meeting.second + i] = false;
        }
      }
    }
    RC_ASSERT(std::ranges::count(alive, true) == 1);
    RC_ASSERT(alive.front());
  }));
}

TEST_CASE("an operator over n leaves takes ceil(log2 n) levels of one AND each") {
  for (std::size_t n = 1; n <= 70; ++n) {
    ActiveTree tree;
    std::vector<std::uint32_t> leaves;
    for (std::uint32_t i = 0; i < n; ++i) leaves.push_back(add_leaf(tree, i));
    const std::uint32_t root = add_operator(tree, PositiveOperator::unite, leaves);
    const csg::BitString string = csg::make_bit_string(tree.nodes, root);
    CAPTURE(n);
    CHECK(string.levels.size() == ceil_log2(n));
    for (const csg::StringLevel& level : string.levels) CHECK(level.and_runs.size() == 1);
  }
}

TEST_CASE("operands of unequal depth are combined at minimum depth") {
  CHECK(string_of("*(+(*(..)*(..))....)").levels.size() == 3);
  CHECK(string_of("*(+(*(..)*(..))+(*(..)*(..)))").levels.size() == 3);
  CHECK(string_of("*(+(*(..).).....)").levels.size() == 4);
  CHECK(string_of("*(+(*(..).)+(..)..)").levels.size() == 3);
  // Four leaves and a tree of depth 2 make one of depth 3: 8 of the 32 leaves in a full tree of depth 5.
  CHECK(string_of("+(....*(+(..).))").levels.size() == 3);
  CHECK(string_of("*(+(....*(+(..).))" + std::string(24, '.') + ")").levels.size() == 5);
}

TEST_CASE("a full tree of alternating operators takes one inversion between levels") {
  const csg::BitString string = string_of("*(+(*(..)*(..))+(*(..)*(..)))");
  REQUIRE(string.levels.size() == 3);
  CHECK(string.levels[0].inverted.empty());
  CHECK(string.levels[1].inverted == std::vector<std::uint32_t>{0, 1, 2, 3});
  CHECK(string.levels[2].inverted == std::vector<std::uint32_t>{0, 1});
  CHECK(string.levels[0].and_runs == std::vector<csg::AndRun>{{0, 4, 4}});
  CHECK(string.levels[1].and_runs == std::vector<csg::AndRun>{{0, 2, 2}});
  CHECK(string.levels[2].and_runs == std::vector<csg::AndRun>{{0, 1, 1}});
  CHECK_FALSE(string.inverted);
}
