#include <rapidcheck.h>

#include "host/csg/active_tree.h"
#include "host/csg/box_index.h"
#include "host/csg/separation.h"
#include "host/csg/tree_paths.h"
#include "host/facet/geometry.h"
#include "host/read/read.h"
#include "host/view/projection.h"
#include "tests/oracle/random_model.h"
#include "tests/support/test.h"

using namespace csgsim;
using csg::Containment;

namespace {

/// Gilbert's algorithm with 100,000 steps, which find any gap between these models.
bool have_gap(const std::vector<glm::dvec3>& one, const std::vector<glm::dvec3>& other) {
  const facet::Box box = facet::hull(facet::box_of(one), facet::box_of(other));
  const auto farthest = [&](const std::vector<glm::dvec3>& points, const glm::dvec3& direction) {
    return *std::ranges::max_element(
        points, {}, [&](const glm::dvec3& point) { return glm::dot(point / (box.high - box.low), direction); });
  };
  glm::dvec3 nearest = (one.front() - other.front()) / (box.high - box.low);
  for (int step = 0; step < 100'000; ++step) {
    const glm::dvec3 support = (farthest(one, -nearest) - farthest(other, nearest)) / (box.high - box.low);
    if (glm::dot(support, nearest) > 0) return true;
    const glm::dvec3 edge = support - nearest;
    const double square = glm::dot(edge, edge);
    if (!(square > 0)) return false;
    nearest += std::clamp(-glm::dot(nearest, edge) / square, 0.0, 1.0) * edge;
  }
  return false;
}

csg::BoxIndex::Box random_box() {
  csg::BoxIndex::Box box;
  for (std::size_t i = 0; i < box.low.size(); ++i) {
    const auto low = *rc::gen::inRange(0, 20);
    box.low[i] = static_cast<float>(low);
    box.high[i] = static_cast<float>(low + *rc::gen::inRange(0, 12));
  }
  return box;
}

template <class Test>
bool in_every_dimension(const csg::BoxIndex::Box& a, const csg::BoxIndex::Box& b, const Test& test) {
  for (std::size_t i = 0; i < a.low.size(); ++i)
    if (!test(a.low[i], a.high[i], b.low[i], b.high[i])) return false;
  return true;
}

bool meet(const csg::BoxIndex::Box& a, const csg::BoxIndex::Box& b) {
  return in_every_dimension(a, b, [](float a0, float a1, float b0, float b1) { return a0 <= b1 && b0 <= a1; });
}

bool covers(const csg::BoxIndex::Box& a, const csg::BoxIndex::Box& b) {
  return in_every_dimension(a, b, [](float a0, float a1, float b0, float b1) { return a0 <= b0 && b1 <= a1; });
}

view::Sampling small_picture() {
  view::Sampling sampling;
  sampling.width = 64;
  sampling.height = 64;
  return sampling;
}

/// A model seen by a camera, with its I-trees pruned by a complete walk.
class Pruned {
 public:
  Pruned(const std::string& text, const csg::Pruning& pruning)
      : tree(read::read_csg_text(text, "test")),
        scene(facet::make_geometry(tree)),
        view(view::make_view(scene, tree, {{30, -40, 20}, {0, 0, 0}, view::Projection::orthographic}, small_picture())),
        positive(csg::make_positive_tree(tree)),
        pruning_(pruning) {}

  struct Part {
    Containment known = Containment::depends;
    std::vector<std::uint32_t> leaves{};  ///< leaves that it depends on
  };

  /// Intersection of all operands next to the path from the primitive to the root.
  [[nodiscard]] Part i_tree(std::uint32_t primitive, const csg::Block& block) const {
    Part all{Containment::in};
    std::uint32_t below = positive.leaf_of[primitive];
    for (std::uint32_t at = positive.nodes[below].parent; at != model::no_index;
         below = std::exchange(at, positive.nodes[at].parent)) {
      if (positive.nodes[at].op != csg::PositiveOperator::intersect) continue;
      for (const std::uint32_t child : positive.nodes[at].children)
        if (child != below) add(all, part(child, primitive, block), Containment::out);
    }
    return all;
  }

  [[nodiscard]] bool is_disjoint(std::uint32_t other, std::uint32_t primitive, const csg::Block& block) const {
    const view::Extent& extent = view.extents[other];
    const bool in_picture =
        common(extent.pixels, block.pixels).empty() || extent.z_low > block.z_high || extent.z_high < block.z_low;
    return (pruning_.picture && in_picture) ||
           (pruning_.space && csg::disjoint(extent.box, view.extents[primitive].box));
  }

  model::Tree tree;
  facet::Geometry scene;
  view::View view;
  csg::PositiveTree positive;

 private:
  /// Adds an operand of an operator with the given dominant value.
  static void add(Part& whole, Part&& operand, Containment dominant) {
    if (whole.known == dominant) return;
    if (operand.known == dominant) {
      whole = {dominant};
    } else if (operand.known == Containment::depends) {
      whole.known = Containment::depends;
      whole.leaves.insert(whole.leaves.end(), operand.leaves.begin(), operand.leaves.end());
    }
  }

  [[nodiscard]] Part part(std::uint32_t index, std::uint32_t primitive, const csg::Block& block) const {
    const csg::PositiveNode& node = positive.nodes[index];
    if (node.is_leaf) return leaf(node, primitive, block);
    const bool intersects = node.op == csg::PositiveOperator::intersect;
    Part whole{intersects ? Containment::in : Containment::out};
    for (const std::uint32_t child : node.children)
      add(whole, part(child, primitive, block), intersects ? Containment::out : Containment::in);
    return whole;
  }

  [[nodiscard]] Part leaf(const csg::PositiveNode& node, std::uint32_t primitive, const csg::Block& block) const {
    Containment known = Containment::depends;
    const bool apart = pruning_.separation && pairs_.are_apart(node.primitive, primitive, view, {});
    // The plane of the model must still lie between what rounding makes of the primitives in this view.
    if (apart) RC_ASSERT(have_gap(view.extents[node.primitive].corners, view.extents[primitive].corners));
    if (is_disjoint(node.primitive, primitive, block) || apart) {
      known = Containment::out;
    } else if (pruning_.halfspaces) {
      known = csg::locate(view, scene, node.primitive, block);
    }
    if (known == Containment::depends) return {known, {node.primitive}};
    return {(known == Containment::in) != node.complemented ? Containment::in : Containment::out};
  }

  csg::Pruning pruning_;
  mutable csg::PairTable pairs_{scene};
};

std::vector<std::uint32_t> leaves_of(const csg::ActiveTree& active) {
  std::vector<std::uint32_t> leaves;
  std::vector<std::uint32_t> open = active.operands;
  while (!open.empty()) {
    const csg::ActiveNode& node = active.nodes[open.back()];
    open.pop_back();
    open.insert(open.end(), node.children.begin(), node.children.end());
    if (!node.is_leaf) continue;
    leaves.push_back(node.primitive);
    leaves.insert(leaves.end(), node.others.begin(), node.others.end());
  }
  std::sort(leaves.begin(), leaves.end());
  return leaves;
}

csg::Pruning random_pruning() {
  csg::Pruning pruning;
  pruning.picture = *rc::gen::inRange(0, 4) > 0;
  pruning.space = *rc::gen::arbitrary<bool>();
  pruning.separation = *rc::gen::arbitrary<bool>();
  pruning.halfspaces = *rc::gen::arbitrary<bool>();
  return pruning;
}

}  // namespace

TEST_CASE("BoxIndex finds the boxes that meet or cover a box in order of their numbers") {
  CHECK(rc::check([] {
    std::vector<csg::BoxIndex::Entry> entries(static_cast<std::size_t>(*rc::gen::inRange(0, 120)));
    for (std::uint32_t i = 0; i < entries.size(); ++i) entries[i] = {random_box(), i};
    const csg::BoxIndex::Box box = random_box();
    std::vector<std::uint32_t> expected_meeting;
    std::vector<std::uint32_t> cover;
    for (const csg::BoxIndex::Entry& entry : entries) {
      if (meet(entry.box, box)) expected_meeting.push_back(entry.number);
      if (covers(entry.box, box)) cover.push_back(entry.number);
    }
    const std::uint64_t seed = *rc::gen::arbitrary<std::uint64_t>();
    std::shuffle(entries.begin(), entries.end(), std::mt19937_64(seed));
    const csg::BoxIndex index(entries);
    std::vector<std::uint32_t> found{7};
    index.meeting(box, found);
    expected_meeting.insert(expected_meeting.begin(), 7);
    RC_ASSERT(found == expected_meeting);
    RC_ASSERT(index.covering(box, entries.size()) == cover);
  }));
}

TEST_CASE("BoxIndex::covering() returns the first boxes up to the requested number") {
  const csg::BoxIndex::Box box{{1, 1, 1, 1}, {2, 2, 2, 2}};
  std::vector<csg::BoxIndex::Entry> entries;
  for (std::uint32_t i = 0; i < 1000; ++i) entries.push_back({box, 999 - i});
  const csg::BoxIndex index(entries);
  CHECK(index.covering(box, 4) == std::vector<std::uint32_t>{0, 1, 2, 3});
  CHECK(index.covering(box, 2000).size() == 1000);
  CHECK(index.covering(box, 0).empty());
}

TEST_CASE("the paths of a tree lead to the same nodes as steps from parent to parent") {
  CHECK(rc::check([] {
    const std::string text = testing::random_model(*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::inRange(2U, 60U));
    const csg::PositiveTree tree = csg::make_positive_tree(read::read_csg_text(text, "test"));
    const csg::TreePaths paths(tree);
    const auto up = [&](std::uint32_t node) {
      std::vector<std::uint32_t> nodes{node};
      while (tree.nodes[nodes.back()].parent != model::no_index) nodes.push_back(tree.nodes[nodes.back()].parent);
      return nodes;
    };
    const auto primitive = [&] {
      return *rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(tree.leaf_of.size()));
    };
    const std::uint32_t a = primitive();
    const std::uint32_t b = primitive();
    const std::vector<std::uint32_t> of_a = up(tree.leaf_of[a]);
    const std::vector<std::uint32_t> of_b = up(tree.leaf_of[b]);
    const auto both = std::find_first_of(of_a.begin(), of_a.end(), of_b.begin(), of_b.end());
    const std::uint32_t above = paths.common_ancestor(tree.leaf_of[a], tree.leaf_of[b]);
    RC_ASSERT(above == *both);
    RC_ASSERT(paths.first(above) <= std::min(a, b));
    RC_ASSERT(paths.last(above) >= std::max(a, b));
    if (a != b) RC_ASSERT(paths.child_towards(above, a) == *(both - 1));
  }));
}

TEST_CASE("Pruner::meeting() returns the operands that a walk of the whole tree finds") {
  CHECK(rc::check([] {
    const csg::Pruning pruning = random_pruning();
    const Pruned plain(testing::random_model(*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::inRange(2U, 120U)),
                       pruning);
    csg::PairTable pairs(plain.scene);
    const csg::Pruner pruner(plain.scene, plain.view, plain.positive, pairs, {pruning});
    const auto x = *rc::gen::inRange(0, 64);
    const auto y = *rc::gen::inRange(0, 64);
    const view::PixelRect region{x, y, *rc::gen::inRange(x, 64), *rc::gen::inRange(y, 64)};
    for (std::uint32_t primitive = 0; primitive < plain.scene.solids.size(); ++primitive) {
      const csg::ConvexSet set{primitive};
      const csg::Block block = pruner.surface_block(set, region);
      if (block.pixels.empty()) continue;
      const std::vector<std::uint32_t> meeting = pruner.meeting(set, block);
      RC_ASSERT(std::is_sorted(meeting.begin(), meeting.end()));
      const Pruned::Part expected = plain.i_tree(primitive, block);
      const csg::ActiveTree active = pruner.active_tree(set, block);
      RC_ASSERT(active.nothing == (expected.known == Containment::out));
      RC_ASSERT(active.operands.empty() == (expected.known != Containment::depends));
      std::vector<std::uint32_t> leaves = expected.leaves;
      std::sort(leaves.begin(), leaves.end());
      RC_ASSERT(leaves_of(active) == leaves);
      for (const std::uint32_t leaf : leaves) RC_ASSERT(std::binary_search(meeting.begin(), meeting.end(), leaf));
      for (const std::uint32_t one : meeting) RC_ASSERT(!plain.is_disjoint(one, primitive, block));
    }
  }));
}
