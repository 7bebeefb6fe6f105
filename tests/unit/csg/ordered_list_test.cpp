#include "host/csg/ordered_list.h"

#include <rapidcheck.h>

#include "tests/support/test.h"
#include "tests/unit/csg/list_trees.h"

using namespace csgsim;

namespace {

using namespace csgsim::testing;
using csg::OrderedList;

// ---- Simulation of a pixel.

/// Whether a pixel with these primitives stays visible; empty if it ends with a label other than that of TRUE.
std::optional<bool> execute(const OrderedList& list, const std::vector<bool>& in) {
  std::uint32_t label = 0;
  for (const csg::ListLeaf& leaf : list.leaves) {
    if (label != leaf.name) continue;
    const csg::Target target = in[leaf.primitive] ? leaf.if_in : leaf.if_out;
    if (target.to == csg::Destination::hidden) return false;
    label = target.label;
  }
  return label == list.true_label ? std::optional(true) : std::nullopt;
}

bool is_correct_for_all_assignments(const ActiveTree& tree) {
  const OrderedList list = csg::make_ordered_list(tree);
  std::vector<bool> in(leaves_of(tree));
  for (std::uint32_t assignment = 0; assignment < 1U << in.size(); ++assignment) {
    for (std::size_t i = 0; i < in.size(); ++i) in[i] = ((assignment >> i) & 1U) != 0;
    if (execute(list, in) != evaluate(tree, in)) return false;
  }
  return true;
}

// ---- The leaves that pixels wait for, computed from a tree of alternating operators and an order of its leaves,
// independently of lists and labels.

constexpr std::uint32_t answer_true = 0xfffffffeU;
constexpr std::uint32_t answer_false = 0xffffffffU;

csg::Destination destination(std::uint32_t way) {
  if (way == answer_true) return csg::Destination::visible;
  return way == answer_false ? csg::Destination::hidden : csg::Destination::leaf;
}

/// The position or the answer that follows each value of a leaf (not of its primitive).
struct Ways {
  std::uint32_t if_true;
  std::uint32_t if_false;
};

class Waiting {
 public:
  explicit Waiting(const ActiveTree& tree)
      : tree_(tree), parent_(tree.nodes.size(), model::no_index), begin_(tree.nodes.size()), leaf_(leaves_of(tree)) {
    for (std::uint32_t i = 0; i < tree.nodes.size(); ++i) {
      for (const std::uint32_t child : tree.nodes[i].children) parent_[child] = i;
      if (tree.nodes[i].is_leaf) leaf_[tree.nodes[i].primitive] = i;
    }
  }

  std::vector<Ways> ways(const std::vector<std::uint32_t>& primitives) {
    for (std::uint32_t at = 0; at < primitives.size(); ++at) begin_[leaf_[primitives[at]]] = at;
    for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
      if (tree_.nodes[i].is_leaf) continue;
      begin_[i] = answer_true;
      for (const std::uint32_t child : tree_.nodes[i].children) begin_[i] = std::min(begin_[i], begin_[child]);
    }
    std::vector<Ways> result;
    result.reserve(primitives.size());
    for (const std::uint32_t primitive : primitives) {
      result.push_back({way(leaf_[primitive], true), way(leaf_[primitive], false)});
    }
    return result;
  }

 private:
  [[nodiscard]] std::uint32_t way(std::uint32_t node, bool value) const {
    for (;;) {
      const std::uint32_t parent = parent_[node];
      const bool top = parent == model::no_index;
      const std::vector<std::uint32_t>& siblings = top ? tree_.operands : tree_.nodes[parent].children;
      if (value == (top || tree_.nodes[parent].op == PositiveOperator::intersect)) {
        std::uint32_t next = answer_true;
        for (const std::uint32_t sibling : siblings) {
          if (begin_[sibling] > begin_[node]) next = std::min(next, begin_[sibling]);
        }
        if (next != answer_true) return next;
      }
      if (top) return value ? answer_true : answer_false;
      node = parent;
    }
  }

  const ActiveTree& tree_;
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> leaf_;
};

/// Maximum number of positions waited for at the same time, before, between and after the leaves.
struct Alive {
  std::size_t with_false = 0;
  std::size_t without_false = 0;

  void count(const std::set<std::uint32_t>& waited_for) {
    with_false = std::max(with_false, waited_for.size());
    without_false = std::max(without_false, waited_for.size() - waited_for.count(answer_false));
  }
};

Alive alive(const std::vector<Ways>& ways) {
  std::set<std::uint32_t> waited_for{ways.empty() ? answer_true : 0};
  Alive result;
  result.count(waited_for);
  for (std::uint32_t at = 0; at < ways.size(); ++at) {
    if (waited_for.erase(at) == 1) waited_for.insert({ways[at].if_true, ways[at].if_false});
    result.count(waited_for);
  }
  return result;
}

bool is_complemented(const ActiveTree& tree, std::uint32_t primitive) {
  return std::ranges::any_of(tree.nodes, [&](const csg::ActiveNode& node) {
    return node.is_leaf && node.primitive == primitive && node.complemented;
  });
}

std::vector<std::uint32_t> order_of(const OrderedList& list) {
  std::vector<std::uint32_t> primitives;
  primitives.reserve(list.leaves.size());
  for (const csg::ListLeaf& leaf : list.leaves) primitives.push_back(leaf.primitive);
  return primitives;
}

/// Runs all possible pixels through the list with the position that each waits for and its label.
bool labels_are_distinct(const ActiveTree& tree, const OrderedList& list) {
  const std::vector<Ways> ways = Waiting(tree).ways(order_of(list));
  std::map<std::uint32_t, std::uint32_t> label_of{{ways.empty() ? answer_true : 0, 0}};
  std::size_t most = 1;
  for (std::uint32_t at = 0; at < ways.size(); ++at) {
    const csg::ListLeaf& leaf = list.leaves[at];
    const auto waiting = label_of.find(at);
    if (waiting == label_of.end() || waiting->second != leaf.name) return false;
    label_of.erase(waiting);
    const bool complemented = is_complemented(tree, leaf.primitive);
    for (const auto& [way, target] : {std::pair(ways[at].if_true, complemented ? leaf.if_out : leaf.if_in),
                                      std::pair(ways[at].if_false, complemented ? leaf.if_in : leaf.if_out)}) {
      if (target.to != destination(way)) return false;
      if (way == answer_false) continue;
      if (target.label >= list.labels || label_of.emplace(way, target.label).first->second != target.label)
        return false;
    }
    std::set<std::uint32_t> labels;
    for (const auto& [way, label] : label_of) labels.insert(label);
    if (labels.size() < label_of.size()) return false;
    most = std::max(most, labels.size());
  }
  return most == list.labels && label_of == std::map<std::uint32_t, std::uint32_t>{{answer_true, list.true_label}};
}

using Orders = std::vector<std::vector<std::uint32_t>>;

Orders all_orders(const ActiveTree& tree, std::vector<std::uint32_t> children);

Orders all_orders(const ActiveTree& tree, std::uint32_t node) {
  if (tree.nodes[node].is_leaf) return {{tree.nodes[node].primitive}};
  return all_orders(tree, tree.nodes[node].children);
}

/// All orders of the leaves that result from reordering operands at any level.
Orders all_orders(const ActiveTree& tree, std::vector<std::uint32_t> children) {
  Orders result;
  std::ranges::sort(children);
  do {
    Orders begun{{}};
    for (const std::uint32_t child : children) {
      Orders longer;
      for (const auto& tail : all_orders(tree, child)) {
        for (const auto& head : begun) {
          longer.push_back(head);
          longer.back().insert(longer.back().end(), tail.begin(), tail.end());
        }
      }
      begun = std::move(longer);
    }
    result.insert(result.end(), begun.begin(), begun.end());
  } while (std::ranges::next_permutation(children).found);
  return result;
}

std::size_t orders_count(const ActiveTree& tree) {
  std::size_t orders = 1;
  for (const csg::ActiveNode& node : tree.nodes) {
    for (std::size_t i = 2; i <= node.children.size(); ++i) orders *= i;
  }
  return orders;
}

/// ceil(log2(2n/3 + 2)), the published bound, which counts a label for FALSE.
std::uint32_t published_bound(std::size_t leaves) {
  std::uint32_t labels = 0;
  while ((std::size_t{3} << labels) < 2 * leaves + 6) ++labels;
  return labels;
}

/// ceil(log2(2n/3 + 4/3)), without a label for FALSE.
std::uint32_t list_bound(std::size_t leaves) {
  std::uint32_t labels = 0;
  while ((std::size_t{3} << labels) < 2 * leaves + 4) ++labels;
  return labels;
}

std::uint32_t ceil_log2(std::uint32_t n) { return static_cast<std::uint32_t>(std::bit_width(n - 1)); }

}  // namespace

TEST_CASE("a tree without operands is an empty list, which removes no pixel") {
  const OrderedList list = csg::make_ordered_list({});
  CHECK(list.leaves.empty());
  CHECK(execute(list, {}) == true);
  CHECK(list.labels == 1);
  CHECK(list.label_bits == 0);
  CHECK(csg::footprint({}) == 1);
}

TEST_CASE("a single leaf needs no label bit and swaps its targets if complemented") {
  const csg::Target visible{csg::Destination::visible, 0};
  for (const bool complemented : {false, true}) {
    ActiveTree tree;
    tree.operands = {add_leaf(tree, 0, complemented)};
    const OrderedList list = csg::make_ordered_list(tree);
    REQUIRE(list.leaves.size() == 1);
    CHECK(list.leaves[0].if_in == (complemented ? csg::Target{} : visible));
    CHECK(list.leaves[0].if_out == (complemented ? visible : csg::Target{}));
    CHECK(list.label_bits == 0);
    CHECK(csg::footprint(tree) == 2);
  }
}

TEST_CASE("an intersection of leaves keeps its order and the only label") {
  ActiveTree tree;
  for (std::uint32_t i = 0; i < 5; ++i) tree.operands.push_back(add_leaf(tree, i));
  const OrderedList list = csg::make_ordered_list(tree);
  CHECK(order_of(list) == std::vector<std::uint32_t>{0, 1, 2, 3, 4});
  for (const csg::ListLeaf& leaf : list.leaves) {
    CHECK(leaf.name == 0);
    CHECK(leaf.if_in.label == 0);
    CHECK(leaf.if_out.to == csg::Destination::hidden);
  }
  CHECK(list.labels == 1);
}

TEST_CASE("an ordered list has the tree's value for all assignments to small trees") {
  for_all_trees(testing::cases<std::uint32_t>(7, 6),
                [](const ActiveTree& tree, std::uint32_t) { REQUIRE(is_correct_for_all_assignments(tree)); });
  CHECK(rc::check([] { RC_ASSERT(is_correct_for_all_assignments(any_tree(10))); }));
}

TEST_CASE("an ordered list has the tree's value for random assignments to larger trees") {
  CHECK(rc::check([] {
    const ActiveTree tree = any_tree(60);
    const OrderedList list = csg::make_ordered_list(tree);
    for (int i = 0; i < 50; ++i) {
      const auto in = *rc::gen::container<std::vector<bool>>(leaves_of(tree), rc::gen::arbitrary<bool>());
      RC_ASSERT(execute(list, in) == evaluate(tree, in));
    }
  }));
}

TEST_CASE("pixels waiting for different leaves hold different labels and none is spare") {
  CHECK(rc::check([] {
    const ActiveTree tree = any_tree(400, Nesting::alternating);
    RC_ASSERT(labels_are_distinct(tree, csg::make_ordered_list(tree)));
  }));
  for_all_trees(testing::cases<std::uint32_t>(9, 7), [](const ActiveTree& tree, std::uint32_t) {
    REQUIRE(labels_are_distinct(tree, csg::make_ordered_list(tree)));
  });
}

TEST_CASE("a leaf passes its label to the nearest target that no pixel waits for yet") {
  CHECK(rc::check([] {
    const ActiveTree tree = any_tree(60, Nesting::alternating);
    const OrderedList list = csg::make_ordered_list(tree);
    const std::vector<Ways> ways = Waiting(tree).ways(order_of(list));
    std::set<std::uint32_t> waited_for{0, answer_false};
    for (std::uint32_t at = 0; at < ways.size(); ++at) {
      const std::uint32_t nearer = std::min(ways[at].if_true, ways[at].if_false);
      const std::uint32_t farther = std::max(ways[at].if_true, ways[at].if_false);
      const auto keeps_name = [&](std::uint32_t target) {
        const bool if_true = target == ways[at].if_true;
        const csg::ListLeaf& leaf = list.leaves[at];
        const bool complemented = is_complemented(tree, leaf.primitive);
        return (if_true != complemented ? leaf.if_in : leaf.if_out).label == leaf.name;
      };
      if (waited_for.insert(nearer).second) {
        RC_ASSERT(keeps_name(nearer));
        waited_for.insert(farther);
      } else if (waited_for.insert(farther).second) {
        RC_ASSERT(keeps_name(farther));
      }
    }
  }));
}

TEST_CASE("no order of operands needs fewer labels than the chosen order") {
  const auto check = [](const ActiveTree& tree) {
    Waiting waiting(tree);
    Alive least{100, 100};
    for (const auto& order : all_orders(tree, tree.operands)) {
      const Alive labels = alive(waiting.ways(order));
      least.with_false = std::min(least.with_false, labels.with_false);
      least.without_false = std::min(least.without_false, labels.without_false);
    }
    return csg::footprint(tree) == least.with_false && csg::make_ordered_list(tree).labels == least.without_false;
  };
  for_all_trees(6, [&](const ActiveTree& tree, std::uint32_t) { REQUIRE(check(tree)); });
  // The costliest operand must be last here; with fewer leaves it can always be first.
  std::string_view text = "+(*(+(.*(..))+(*(..)*(..)))*(+(.*(+(..)+(.*(..)))).))";
  ActiveTree lopsided;
  lopsided.operands = {add_text(lopsided, text)};
  REQUIRE(check(lopsided));
  const std::vector<Shape> shapes = all_shapes(11);
  std::mt19937_64 engine(1);
  for (int tested = 0; tested < 200;) {
    const auto shape = static_cast<std::size_t>(engine() % shapes.size());
    const ActiveTree tree =
        tree_of(shapes, shape, engine() % 2 == 1 ? PositiveOperator::unite : PositiveOperator::intersect);
    if (orders_count(tree) > 3000) continue;
    REQUIRE(check(tree));
    ++tested;
  }
}

TEST_CASE("the worst trees of each size reach the bounds on labels and none exceeds them") {
  constexpr std::uint32_t most_leaves = 11;
  std::vector<std::uint32_t> most_labels(most_leaves + 1);
  std::vector<std::uint32_t> widest(most_leaves + 1);
  for_all_trees(most_leaves, [&](const ActiveTree& tree, std::uint32_t leaves) {
    most_labels[leaves] = std::max(most_labels[leaves], csg::make_ordered_list(tree).labels);
    widest[leaves] = std::max(widest[leaves], csg::footprint(tree));
  });
  for (std::uint32_t leaves = 1; leaves <= most_leaves; ++leaves) {
    CHECK(widest[leaves] == published_bound(leaves));
    CHECK(most_labels[leaves] == list_bound(leaves));
  }
}

TEST_CASE("the bounds on labels hold for random trees of up to 400 leaves") {
  CHECK(rc::check([] {
    const ActiveTree tree = any_tree(400);
    const OrderedList list = csg::make_ordered_list(tree);
    RC_ASSERT(csg::footprint(tree) <= published_bound(leaves_of(tree)));
    RC_ASSERT(list.labels <= csg::footprint(tree));
    RC_ASSERT(list.labels <= list_bound(leaves_of(tree)));
    RC_ASSERT(list.label_bits == ceil_log2(list.labels));
  }));
}

TEST_CASE("two to four label bits suffice for 21 to 98301 leaves") {
  CHECK(ceil_log2(list_bound(4)) == 1);
  std::uint32_t bits = 2;
  for (const std::size_t leaves : {21U, 381U, 98'301U}) {
    CHECK(ceil_log2(published_bound(leaves)) == bits);
    CHECK(ceil_log2(published_bound(leaves + 1)) == bits + 1);
    CHECK(ceil_log2(list_bound(leaves + 1)) == bits);
    CHECK(ceil_log2(list_bound(leaves + 2)) == bits + 1);
    ++bits;
  }
}

TEST_CASE("the smallest trees for each number of labels reach the bounds on labels") {
  for (std::uint32_t labels = 2; labels <= 17; ++labels) {
    const ActiveTree widest = widest_tree(labels);
    CHECK(csg::footprint(widest) == labels);
    CHECK(published_bound(leaves_of(widest)) == labels);
    CHECK(published_bound(leaves_of(widest) - 1) == labels - 1);

    const ActiveTree longest = under_a_union(widest);
    CHECK(csg::make_ordered_list(longest).labels == labels);
    CHECK(list_bound(leaves_of(longest)) == labels);
    CHECK(list_bound(leaves_of(longest) - 1) == labels - 1);
  }
}

TEST_CASE("a tree a hundred thousand levels deep needs two labels") {
  ActiveTree tree;
  constexpr std::uint32_t depth = 100'000;
  std::uint32_t top = add_leaf(tree, 0);
  for (std::uint32_t i = 1; i <= depth; ++i) {
    const std::uint32_t leaf = add_leaf(tree, i, i % 3 == 0);
    top = add_operator(tree, i % 2 == 0 ? PositiveOperator::unite : PositiveOperator::intersect, {leaf, top});
  }
  tree.operands = {top};
  CHECK(csg::make_ordered_list(tree).labels == 2);
  CHECK(csg::footprint(tree) == 2);
}

TEST_CASE("a hundred thousand nested unions become one operator of an ordered list") {
  ActiveTree tree;
  constexpr std::uint32_t depth = 100'000;
  std::uint32_t top = add_leaf(tree, 0);
  for (std::uint32_t i = 1; i <= depth; ++i) {
    top = add_operator(tree, PositiveOperator::unite, {top, add_leaf(tree, i)});
  }
  tree.operands = {top};
  const OrderedList list = csg::make_ordered_list(tree);
  CHECK(list.labels == 2);
  CHECK(std::ranges::is_sorted(order_of(list)));
}

TEST_CASE("an operator may have a hundred thousand operands") {
  for (const PositiveOperator op : {PositiveOperator::unite, PositiveOperator::intersect}) {
    ActiveTree tree;
    std::vector<std::uint32_t> pairs;
    for (std::uint32_t i = 0; i < 100'000; ++i) {
      const std::uint32_t first = add_leaf(tree, 2 * i);
      pairs.push_back(add_operator(tree, other(op), {first, add_leaf(tree, 2 * i + 1)}));
    }
    tree.operands = {add_operator(tree, op, pairs)};
    CHECK(csg::make_ordered_list(tree).labels == (op == PositiveOperator::unite ? 3 : 2));
    CHECK(csg::footprint(tree) == 3);
  }
}
