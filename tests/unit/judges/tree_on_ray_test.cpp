#include "sim/judges/tree_on_ray.h"

#include <rapidcheck.h>

#include "tests/oracle/tree_rules.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

/// Leaves in order; neighbours are combined until one remains.
model::Tree any_tree() {
  model::Tree tree;
  const auto count = *rc::gen::inRange<std::uint32_t>(1, 13);
  tree.primitives.resize(count);
  std::vector<std::uint32_t> roots;
  for (std::uint32_t i = 0; i < count; ++i) {
    tree.nodes.push_back({true, model::Operator::unite, i, {}});
    roots.push_back(i);
  }
  while (roots.size() > 1) {
    const auto first = *rc::gen::inRange<std::size_t>(0, roots.size() - 1);
    const auto end = *rc::gen::inRange<std::size_t>(first + 2, std::min(first + 5, roots.size() + 1));
    const auto from = roots.begin() + static_cast<std::ptrdiff_t>(first);
    const auto to = roots.begin() + static_cast<std::ptrdiff_t>(end);
    const auto op = *rc::gen::element(model::Operator::unite, model::Operator::subtract, model::Operator::intersect);
    tree.nodes.push_back({false, op, model::no_index, {from, to}});
    *from = static_cast<std::uint32_t>(tree.nodes.size() - 1);
    roots.erase(from + 1, to);
  }
  tree.root = roots.front();
  return tree;
}

bool value(const model::Tree& tree, std::uint32_t at, const std::vector<bool>& held) {
  const model::Node& node = tree.nodes[at];
  if (node.is_leaf) return held[node.primitive];
  const auto in = [&](std::uint32_t child) { return value(tree, child, held); };
  const auto& all = node.children;
  switch (node.op) {
    case model::Operator::unite: return std::any_of(all.begin(), all.end(), in);
    case model::Operator::intersect: return std::all_of(all.begin(), all.end(), in);
    case model::Operator::subtract: break;
  }
  return in(all.front()) && std::none_of(all.begin() + 1, all.end(), in);
}

struct Event {
  int depth;
  std::uint32_t primitive;
  bool enters;
};

bool same_depth(const Event& a, const Event& b) { return a.depth == b.depth; }

/// Interval of a ray inside each primitive, if any, at few different depths so that many coincide.
struct Interval {
  int front;
  int back;
};
using Intervals = std::vector<std::optional<Interval>>;

Intervals any_intervals(std::size_t count) {
  Intervals intervals(count);
  for (std::optional<Interval>& in : intervals) {
    const int front = *rc::gen::inRange(0, 6);
    if (*rc::gen::inRange(0, 5) > 0) in = Interval{front, front + *rc::gen::inRange(1, 5)};
  }
  return intervals;
}

/// Events in order of depth; those of equal depth in any order.
std::vector<Event> events_of(const Intervals& intervals) {
  std::vector<Event> events;
  for (std::uint32_t i = 0; i < intervals.size(); ++i) {
    if (!intervals[i]) continue;
    events.push_back({intervals[i]->front, i, true});
    events.push_back({intervals[i]->back, i, false});
  }
  if (*rc::gen::arbitrary<bool>()) std::reverse(events.begin(), events.end());
  std::stable_sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.depth < b.depth; });
  return events;
}

struct Shown {
  int depth = 0;
  std::uint32_t primitive = 0;

  bool operator==(const Shown&) const = default;
};

/// The nearest visible side that no operator removes; the first in tree order if several coincide.
std::optional<Shown> nearest_shown(const model::Tree& tree, const Intervals& intervals) {
  const testing::TreeRules rules(tree);
  std::optional<Shown> seen;
  for (std::uint32_t i = 0; i < intervals.size(); ++i) {
    if (!intervals[i]) continue;
    const int depth = rules.is_subtracted(i) ? intervals[i]->back : intervals[i]->front;
    if (seen && seen->depth <= depth) continue;
    std::vector<bool> held;
    for (const std::optional<Interval>& in : intervals) held.push_back(in && in->front <= depth && depth < in->back);
    if (rules.shows(i, held)) seen = Shown{depth, i};
  }
  return seen;
}

}  // namespace

TEST_CASE("incremental updates of a tree give the value of a full evaluation") {
  CHECK(rc::check([] {
    const model::Tree tree = any_tree();
    judges::TreeOnRay on_ray(tree);
    std::vector<bool> held(tree.primitives.size());
    const auto toggles = *rc::gen::container<std::vector<std::uint32_t>>(
        40, rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(held.size())));
    for (const std::uint32_t primitive : toggles) {
      held[primitive] = *rc::gen::arbitrary<bool>();
      on_ray.set(primitive, held[primitive]);
      RC_ASSERT(on_ray.is_in_model() == value(tree, tree.root, held));
    }
  }));
}

TEST_CASE("a surface is visible where its side is present and no operator removes it") {
  CHECK(rc::check([] {
    const model::Tree tree = any_tree();
    judges::TreeOnRay on_ray(tree);
    const testing::TreeRules rules(tree);
    const auto held = *rc::gen::container<std::vector<bool>>(tree.primitives.size(), rc::gen::arbitrary<bool>());
    for (std::uint32_t i = 0; i < held.size(); ++i) on_ray.set(i, held[i]);
    for (std::uint32_t i = 0; i < held.size(); ++i) {
      RC_ASSERT(on_ray.is_subtracted(i) == rules.is_subtracted(i));
      RC_ASSERT(on_ray.is_exposed(i) == (held[i] != rules.is_subtracted(i) && rules.shows(i, held)));
    }
  }));
}

TEST_CASE("a ray sees the nearest surface and the first primitive in tree order") {
  CHECK(rc::check([] {
    const model::Tree tree = any_tree();
    judges::TreeOnRay on_ray(tree);
    for (int ray = 0; ray < 3; ++ray) {
      const Intervals intervals = any_intervals(tree.primitives.size());
      const std::vector<Event> events = events_of(intervals);
      const Event* seen = judges::first_seen(on_ray, std::span<const Event>(events), same_depth);
      const std::optional<Shown> expected = nearest_shown(tree, intervals);
      RC_ASSERT((seen != nullptr) == expected.has_value());
      if (seen != nullptr) RC_ASSERT((Shown{seen->depth, seen->primitive} == *expected));
      RC_ASSERT_FALSE(on_ray.is_in_model());
    }
  }));
}

TEST_CASE("an empty tree is outside everywhere") { CHECK_FALSE(judges::TreeOnRay(model::Tree{}).is_in_model()); }
