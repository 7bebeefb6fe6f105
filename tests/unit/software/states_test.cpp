#include <rapidcheck.h>

#include "sim/software/methods/counts.h"
#include "sim/software/traversals/bit_parallel.h"
#include "sim/software/traversals/bit_parallel_status.h"
#include "sim/software/traversals/bit_sequential.h"
#include "sim/software/traversals/early_out.h"
#include "sim/software/traversals/positional.h"
#include "sim/software/traversals/standard.h"
#include "sim/software/traversals/status.h"
#include "sim/software/traversals/take_back.h"
#include "sim/software/tree/tree.h"
#include "tests/oracle/split_mix.h"
#include "tests/oracle/tree_rules.h"
#include "tests/support/test.h"
#include "tests/unit/software/random_tree.h"

using namespace csgsim;
using software::CountingMethod;
using software::Known;
using software::Shape;
using software::Tree;
using testing::Random;

namespace {

/// A model and the known states of its primitives.
struct Question {
  const testing::TreeRules& rules;
  std::vector<Known> known;

  [[nodiscard]] std::vector<std::uint32_t> open() const {
    std::vector<std::uint32_t> primitives;
    for (std::uint32_t i = 0; i < known.size(); ++i) {
      if (known[i] == Known::nothing) primitives.push_back(i);
    }
    return primitives;
  }
  /// The known states, with all others out.
  [[nodiscard]] std::vector<bool> held() const {
    std::vector<bool> held;
    for (const Known one : known) held.push_back(one == Known::in);
    return held;
  }
};

/// A traversal at a point whose states can be changed.
template <class Traversal>
class Walker {
 public:
  Walker(const Tree& tree, const Question& question)
      : tree_(tree), question_(question), traversal_(tree), held_(question.held()) {}

  void flip(std::uint32_t primitive) {
    held_[primitive] = !held_[primitive];
    if (tree_.leaf_of[primitive] != model::no_index) traversal_.flip(primitive, count_);
  }
  void start() {
    std::vector<std::uint32_t> in;
    for (const std::uint32_t primitive : question_.open()) {
      if (held_[primitive] && tree_.leaf_of[primitive] != model::no_index) in.push_back(primitive);
    }
    software::undo_flips(traversal_, in, count_);
    held_ = question_.held();
  }
  bool is_right() { return (traversal_.evaluate(count_) != tree_.complemented) == question_.rules.holds(held_); }

 private:
  const Tree& tree_;
  const Question& question_;
  Traversal traversal_;
  std::vector<bool> held_;
  CountingMethod count_;
};

/// Whether a traversal is right in all states consistent with the known ones, each one change from the previous, and
/// then in random states from the start.
template <template <class> class Traversal>
bool is_right_in_all_states(const Tree& tree, const Question& question, Random& random) {
  const std::vector<std::uint32_t> open = question.open();
  Walker<Traversal<CountingMethod>> walker(tree, question);
  if (!walker.is_right()) return false;
  const std::uint64_t states = std::uint64_t{1} << open.size();
  for (std::uint64_t state = 1; state < states; ++state) {
    walker.flip(open[static_cast<std::size_t>(std::countr_zero(state))]);
    if (!walker.is_right()) return false;
  }
  for (int i = 0; i < 8; ++i) {
    walker.start();
    if (!walker.is_right()) return false;
    for (std::uint64_t flips = random.below(20); flips > 0 && !open.empty(); --flips)
      walker.flip(open[static_cast<std::size_t>(random.below(open.size()))]);
    if (!walker.is_right()) return false;
  }
  return true;
}

/// Returns the name of a wrong traversal; empty if none.
std::string wrong_traversal(const Tree& tree, const Question& question, Random& random) {
  if (tree.is_constant()) {
    std::vector<bool> held = question.held();
    const std::vector<std::uint32_t> open = question.open();
    for (std::uint64_t state = 0; state < std::uint64_t{1} << open.size(); ++state) {
      for (std::size_t i = 0; i < open.size(); ++i) held[open[i]] = ((state >> i) & 1U) != 0;
      if (question.rules.holds(held) != tree.complemented) return "none: the tree is constant";
    }
    return "";
  }
  if (!is_right_in_all_states<software::Standard>(tree, question, random)) return "standard";
  if (!is_right_in_all_states<software::EarlyOut>(tree, question, random)) return "early-out";
  if (!is_right_in_all_states<software::Positional>(tree, question, random)) return "positional";
  if (!is_right_in_all_states<software::StatusTree>(tree, question, random)) return "status";
  if (!is_right_in_all_states<software::BitSequential>(tree, question, random)) return "bit-sequential";
  if (!is_right_in_all_states<software::BitParallel>(tree, question, random)) return "bit-parallel";
  if (!is_right_in_all_states<software::BitParallelStatus>(tree, question, random)) return "bit-parallel-status";
  return "";
}

/// Returns an inconsistency between tree nodes; empty if none.
std::string wrong_node(const Tree& tree, std::size_t primitives) {
  if (tree.leaf_of.size() != primitives) return "leaves";
  for (std::uint32_t i = 0; i < tree.nodes.size(); ++i) {
    const software::Node& node = tree.nodes[i];
    if (i != tree.root && node.parent == model::no_index) return "a node without a parent";
    if (node.is_leaf) {
      if (node.height != 0 || tree.leaf_of[node.primitive] != i) return "a leaf";
      continue;
    }
    if (node.left >= i || node.right >= i) return "a child after its parent";
    const software::Node& left = tree.nodes[node.left];
    const software::Node& right = tree.nodes[node.right];
    if (left.parent != i || right.parent != i) return "a parent";
    if (node.height != 1 + std::max(left.height, right.height)) return "a height";
  }
  return "";
}

/// Makes some of the unknown states known.
void add_known(std::vector<Known>& known, Random& random) {
  for (Known& one : known) {
    if (one == Known::nothing && random.below(5) == 0) one = random.one_of({Known::out, Known::in});
  }
}

struct Tally {
  std::uint64_t constants = 0;
  std::uint64_t complemented = 0;
  std::uint64_t long_strings = 0;  ///< trees of more than 5 levels
};

std::string find_fault(const Tree& tree, const Question& question, Random& random, Tally& tally) {
  tally.constants += tree.is_constant() ? 1U : 0U;
  tally.complemented += !tree.is_constant() && tree.complemented ? 1U : 0U;
  tally.long_strings += tree.depth() > 5 ? 1U : 0U;
  const std::string node = wrong_node(tree, question.known.size());
  return node.empty() ? wrong_traversal(tree, question, random) : node;
}

/// Checks a tree as a whole and pruned twice by additional known states.
std::string find_fault(const model::Tree& model, Shape shape, Random& random, Tally& tally) {
  const testing::TreeRules rules(model);
  Question question{rules, std::vector<Known>(model.primitives.size())};
  Tree tree = software::make_tree(model, shape);
  std::string fault = find_fault(tree, question, random, tally);
  for (int i = 0; i < 2 && fault.empty(); ++i) {
    add_known(question.known, random);
    const std::size_t nodes = tree.nodes.size();
    tree = software::reduced(tree, question.known);
    if (tree.nodes.size() > nodes) return "pruning added nodes";
    for (std::uint32_t primitive = 0; primitive < question.known.size(); ++primitive) {
      const bool is_known = question.known[primitive] != Known::nothing;
      if (is_known && tree.leaf_of[primitive] != model::no_index) return "pruning kept a known primitive";
    }
    fault = find_fault(tree, question, random, tally);
    if (!fault.empty()) fault += ", pruned";
  }
  return fault;
}

constexpr Shape all_shapes[] = {Shape::written, Shape::left_deep, Shape::balanced};

model::Tree union_of(unsigned primitives) {
  model::Tree tree;
  model::Node root;
  for (std::uint32_t i = 0; i < primitives; ++i) {
    tree.primitives.emplace_back();
    tree.nodes.push_back({.is_leaf = true, .primitive = i, .children = {}});
    root.children.push_back(i);
  }
  tree.nodes.push_back(std::move(root));
  tree.root = primitives;
  return tree;
}

}  // namespace

TEST_CASE("every traversal follows the CSG rules in all states of random trees") {
  Tally tally;
  CHECK(rc::check([&] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    for (std::uint64_t i = 0; i < 4; ++i) {
      Random random(seed + i);
      const model::Tree model = testing::random_tree(random, 1 + static_cast<unsigned>(random.below(10)));
      for (const Shape shape : all_shapes) {
        const std::string fault = find_fault(model, shape, random, tally);
        if (!fault.empty())
          RC_FAIL(std::string(software::shapes()[static_cast<std::size_t>(shape)].name) + ": " + fault);
      }
    }
  }));
  MESSAGE(tally.constants, " constant trees, ", tally.complemented, " complemented, ", tally.long_strings,
          " of more than 5 levels");
  if (!testing::draws_usual_cases()) return;
  CHECK(tally.constants > 50);
  CHECK(tally.complemented > 10);
  CHECK(tally.long_strings > 10);
}
TEST_CASE("every traversal follows the CSG rules in all states of 14 chained operators") {
  Tally tally;
  Random random(7);
  const model::Tree model = testing::chain(15);
  CHECK(software::make_tree(model, Shape::written).depth() == 14);
  CHECK(find_fault(model, Shape::written, random, tally) == "");
  CHECK(find_fault(model, Shape::balanced, random, tally) == "");
}
TEST_CASE("each tree shape has its documented depth") {
  for (const unsigned primitives : {2U, 3U, 5U, 8U, 9U, 16U, 17U, 100U, 1024U, 1025U}) {
    CAPTURE(primitives);
    const model::Tree model = union_of(primitives);
    CHECK(software::make_tree(model, Shape::left_deep).depth() == primitives - 1);
    CHECK(software::make_tree(model, Shape::written).depth() == primitives - 1);
    CHECK(software::make_tree(model, Shape::balanced).depth() == std::bit_width(primitives - 1));
  }
  // Two unions below a union are separate nodes as written, and operands of one node when merged.
  model::Tree model = union_of(4);
  model.nodes[4].children = {0, 1};
  model.nodes.push_back({.op = model::Operator::unite, .children = {2, 3}});
  model.nodes.push_back({.op = model::Operator::unite, .children = {4, 5}});
  model.root = 6;
  CHECK(software::make_tree(model, Shape::written).depth() == 2);
  CHECK(software::make_tree(model, Shape::left_deep).depth() == 3);
  CHECK(software::make_tree(model, Shape::balanced).depth() == 2);
}
TEST_CASE("pruning a tree of two primitives follows table 4.1") {
  using model::Operator;
  struct Row {
    Operator op;
    Known left;
    Known right;
    std::uint32_t rest;  ///< a primitive, or none
    bool is_complemented;
  };
  constexpr std::uint32_t none = model::no_index;
  for (const Row& row : {Row{Operator::unite, Known::nothing, Known::in, none, true},
                         {Operator::unite, Known::nothing, Known::out, 0, false},
                         {Operator::unite, Known::in, Known::nothing, none, true},
                         {Operator::unite, Known::out, Known::nothing, 1, false},
                         {Operator::subtract, Known::nothing, Known::in, none, false},
                         {Operator::subtract, Known::nothing, Known::out, 0, false},
                         {Operator::subtract, Known::in, Known::nothing, 1, true},
                         {Operator::subtract, Known::out, Known::nothing, none, false},
                         {Operator::intersect, Known::nothing, Known::in, 0, false},
                         {Operator::intersect, Known::nothing, Known::out, none, false},
                         {Operator::intersect, Known::in, Known::nothing, 1, false},
                         {Operator::intersect, Known::out, Known::nothing, none, false}}) {
    model::Tree model = union_of(2);
    model.nodes.back().op = row.op;
    const std::vector<Known> known{row.left, row.right};
    const Tree rest = software::reduced(software::make_tree(model, Shape::written), known);
    CAPTURE(static_cast<int>(row.op));
    CAPTURE(static_cast<int>(row.left));
    CAPTURE(static_cast<int>(row.right));
    CHECK(rest.complemented == row.is_complemented);
    CHECK(rest.nodes.size() == (row.rest == none ? 0 : 1));
    CHECK((row.rest == none || rest.nodes.front().primitive == row.rest));
  }
}
