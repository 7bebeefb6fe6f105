#include "sim/software/convert/local_tree.h"

#include "host/csg/positive_tree.h"
#include "host/csg/tree_paths.h"
#include "host/model/tree.h"
#include "sim/software/convert/division.h"
#include "tests/oracle/split_mix.h"
#include "tests/oracle/tree_rules.h"
#include "tests/support/test.h"
#include "tests/unit/software/random_tree.h"

using namespace csgsim;
using software::convert::Known;
using software::convert::LocalTree;
using software::convert::Operand;
using software::convert::SideValues;
using testing::Random;
using Kind = LocalTree::Node::Kind;

namespace {

/// A random tree, and those of its primitives that may be near a point.
struct Near {
  explicit Near(Random& random)
      : tree(testing::random_tree(random, 2 + static_cast<unsigned>(random.below(8)))),
        positive(csg::make_positive_tree(tree)),
        paths(positive) {
    for (std::uint32_t i = 0; i < tree.primitives.size(); ++i)
      if (random.below(4) != 0) primitives.push_back(i);
    if (primitives.empty()) primitives.push_back(0);
  }

  model::Tree tree;
  csg::PositiveTree positive;
  csg::TreePaths paths;
  std::vector<std::uint32_t> primitives;
};

SideValues value_of(const Near& near, const std::vector<SideValues>& values) {
  const testing::TreeRules rules(near.tree);
  std::vector<bool> behind(near.tree.primitives.size(), false);
  std::vector<bool> before = behind;
  for (std::size_t i = 0; i < values.size(); ++i) {
    behind[near.primitives[i]] = values[i].behind;
    before[near.primitives[i]] = values[i].before;
  }
  return {rules.holds(behind), rules.holds(before)};
}

/// Calls visit(values) for all values of the unknown operands; both sides are equal unless they may differ.
template <class Visit>
void for_values(std::vector<SideValues> values, const std::vector<Known>& known, const std::vector<bool>& may_differ,
                std::size_t from, const Visit& visit) {
  if (from == known.size()) return visit(values);
  if (known[from].is_known) {
    values[from] = known[from].value;
    return for_values(values, known, may_differ, from + 1, visit);
  }
  for (const SideValues& value :
       {SideValues{false, false}, SideValues{true, true}, SideValues{false, true}, SideValues{true, false}}) {
    if (value.behind != value.before && !may_differ[from]) continue;
    values[from] = value;
    for_values(values, known, may_differ, from + 1, visit);
  }
}

/// Whether children precede their parents and each operator has several children.
bool is_well_formed(const LocalTree& tree) {
  const auto nodes = tree.nodes();
  std::vector<std::size_t> children(nodes.size(), 0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].parent == LocalTree::none) {
      if (i + 1 != nodes.size()) return false;
      continue;
    }
    if (nodes[i].parent <= i || nodes[i].parent >= nodes.size()) return false;
    ++children[nodes[i].parent];
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const bool is_operator = nodes[i].kind == Kind::unite || nodes[i].kind == Kind::intersect;
    if (is_operator ? children[i] < 2 : children[i] != 0) return false;
  }
  return true;
}

std::vector<Known> some_known(Random& random, std::size_t count, unsigned of_four) {
  std::vector<Known> known(count);
  for (Known& one : known)
    if (random.below(4) < of_four) one = {true, {random.below(2) == 0, random.below(2) == 0}};
  return known;
}

}  // namespace

TEST_CASE("reducing a tree by known operands gives its value in one step or in two") {
  Random random(3);
  int both = 0;
  for (int i = 0; i < 400; ++i) {
    const Near near(random);
    const LocalTree tree(near.positive, near.paths, near.primitives);
    const std::size_t count = near.primitives.size();
    const std::vector<bool> may(count, true);
    const std::vector<Known> all = some_known(random, count, 4);
    std::vector<SideValues> values;
    for (const Known& one : all) values.push_back(one.value);
    const SideValues expected = value_of(near, values);
    if (expected.behind != expected.before) ++both;
    const LocalTree reduced = tree.reduced(all, may);
    REQUIRE(reduced.value().is_known);
    CHECK(reduced.value().value == expected);
    CHECK(reduced.nodes().empty());
    std::vector<Known> first(count);
    for (std::size_t k = 0; k < count; ++k)
      if (random.below(2) == 0) first[k] = all[k];
    const LocalTree left = tree.reduced(first, may);
    const LocalTree rest = left.reduced(all, may);
    REQUIRE(rest.value().is_known);
    CHECK(rest.value().value == expected);
    if (left.value().is_known) CHECK(left.value().value == expected);
  }
  CHECK(both > 50);
}

TEST_CASE("a value is known if no open operand affects it and otherwise may differ") {
  Random random(4);
  int known_early = 0;
  int never_differs = 0;
  for (int i = 0; i < 400; ++i) {
    const Near near(random);
    const std::size_t count = near.primitives.size();
    if (count > 6) continue;
    const LocalTree tree(near.positive, near.paths, near.primitives);
    const std::vector<Known> known = some_known(random, count, 2);
    std::vector<bool> may(count);
    for (std::size_t k = 0; k < count; ++k) may[k] = random.below(3) == 0;
    const LocalTree left = tree.reduced(known, may);
    bool is_first = true;
    bool is_one = true;
    bool can_differ = false;
    SideValues value;
    for_values(std::vector<SideValues>(count), known, may, 0, [&](const std::vector<SideValues>& values) {
      const SideValues here = value_of(near, values);
      if (!is_first && !(here == value)) is_one = false;
      value = here;
      is_first = false;
      if (here.behind != here.before) can_differ = true;
    });
    const auto is_constant = [](const LocalTree::Node& node) { return node.kind == Kind::constant; };
    const bool has_constant = std::ranges::any_of(left.nodes(), is_constant);
    // Every primitive occurs once in the tree: a value that is the same for all open operands is known, except for
    // operators that are decided by operands on both sides together.
    CHECK((left.value().is_known == is_one || (is_one && has_constant)));
    if (left.value().is_known) {
      CHECK(left.value().value == value);
      ++known_early;
      continue;
    }
    CHECK(is_well_formed(left));
    CHECK((left.may_differ() || !can_differ));
    const auto is_open_and_may = [&](const LocalTree::Node& node) {
      return node.kind == Kind::leaf && may[node.operand];
    };
    CHECK(left.may_differ() == (std::ranges::any_of(left.nodes(), is_open_and_may) || has_constant));
    for (const LocalTree::Node& node : left.nodes()) {
      if (node.kind == Kind::leaf) CHECK(!known[node.operand].is_known);
      // A constant decides its operator on one side of the plane and has no effect on the other.
      if (node.kind == Kind::constant) CHECK(node.value.behind != node.value.before);
    }
    if (!left.may_differ()) ++never_differs;
  }
  CHECK(known_early > 50);
  CHECK(never_differs > 10);
}

TEST_CASE("dropping operands of a tree renumbers the remaining ones") {
  Random random(6);
  for (int i = 0; i < 100; ++i) {
    const Near near(random);
    const std::size_t count = near.primitives.size();
    const LocalTree tree(near.positive, near.paths, near.primitives);
    const std::vector<Known> known = some_known(random, count, 2);
    LocalTree left = tree.reduced(known, std::vector<bool>(count, true));
    if (left.value().is_known) continue;
    std::vector<Operand> operands(count);
    std::vector<bool> is_kept(count, false);
    for (std::size_t k = 0; k < count; ++k) operands[k].body = near.primitives[k];
    for (const LocalTree::Node& node : left.nodes())
      if (node.kind == Kind::leaf) is_kept[node.operand] = true;
    std::vector<std::uint32_t> bodies;
    for (const LocalTree::Node& node : left.nodes())
      if (node.kind == Kind::leaf) bodies.push_back(near.primitives[node.operand]);
    software::convert::keep_operands(is_kept, left, operands);
    CHECK(operands.size() == static_cast<std::size_t>(std::ranges::count(is_kept, true)));
    std::size_t at = 0;
    for (const LocalTree::Node& node : left.nodes())
      if (node.kind == Kind::leaf) CHECK(operands.at(node.operand).body == bodies.at(at++));
    CHECK(std::ranges::is_sorted(operands, {}, &Operand::body));
  }
}
