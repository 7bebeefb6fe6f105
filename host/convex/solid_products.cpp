#include "host/convex/solid_products.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "host/convex/clip.h"
#include "hw/base/error.h"

namespace csgsim::convex {

namespace {

using csg::PositiveNode;
using csg::PositiveOperator;
using csg::PositiveTree;

constexpr std::string_view multiplying_out = "expanding the model into products";

/// Cost of visiting a node.
constexpr std::uint64_t visit_steps = 16;

/// The region outside which a subtree is constant: entirely inside or entirely outside.
struct Reach {
  bool is_inside_elsewhere = false;  ///< whether all points outside the box are inside the subtree
  facet::Box box;                    ///< relative to PlaneTable::centre()
};

/// Bounds of a node. If each operand alone decides the result outside its box, only the intersection of these boxes is
/// undecided.
Reach node_reach(const PositiveNode& node, const std::vector<Reach>& below) {
  const bool decisive = node.op == PositiveOperator::unite;
  std::optional<facet::Box> decided;
  facet::Box all;
  for (const std::uint32_t child : node.children) {
    const Reach& reach = below[child];
    all = hull(all, reach.box);
    if (reach.is_inside_elsewhere == decisive) decided = decided ? common(*decided, reach.box) : reach.box;
  }
  return decided ? Reach{decisive, *decided} : Reach{!decisive, all};
}

std::vector<Reach> reaches(const facet::Geometry& geometry, const PositiveTree& tree) {
  std::vector<Reach> found(tree.nodes.size());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const PositiveNode& node = tree.nodes[i];
    if (!node.is_leaf) {
      found[i] = node_reach(node, found);
      continue;
    }
    const facet::Box& box = geometry.solids[node.primitive].box;
    found[i] = {node.complemented, box};
    if (!box.empty()) found[i].box = {box.low - geometry.planes.centre(), box.high - geometry.planes.centre()};
  }
  return found;
}

/// A product of which some factors have been chosen.
struct Partial {
  std::optional<Polytope> whole;  ///< empty until the first primitive, representing the whole space
  facet::Box box;                 ///< box of `whole`
  std::vector<std::uint32_t> subtracted;
  std::vector<std::uint32_t> unions;  ///< union nodes with an operand still to be chosen
  std::uint32_t primitive = model::no_index;
};

/// A partial product, and the subtree with which to intersect it next: an operand of a union, or the root.
struct Branch {
  std::shared_ptr<const Partial> parent;
  std::uint32_t node;
};

class Enumeration {
 public:
  Enumeration(const facet::Geometry& geometry, const PositiveTree& tree, const std::function<void(SolidProduct)>& use,
              std::uint64_t max_choices, const Work& work)
      : geometry_(geometry),
        tree_(tree),
        use_(use),
        max_choices_(max_choices),
        work_(work),
        reaches_(reaches(geometry, tree)) {}

  void operator()() {
    branches_.push_back({std::make_shared<const Partial>(), tree_.root});
    while (!branches_.empty()) {
      const Branch branch = std::move(branches_.back());
      branches_.pop_back();
      Partial partial = *branch.parent;
      work_.charge(partial.subtracted.size() + partial.unions.size(), multiplying_out);
      if (absorb(partial, branch.node)) choose(std::move(partial));
    }
  }

 private:
  /// Location of the partial product relative to a subtree: outside, inside, or undecided.
  enum class Known : std::uint8_t { out, in, depends };
  [[nodiscard]] Known known(std::uint32_t node, const Partial& partial) const {
    const Reach& reach = reaches_[node];
    const bool apart = reach.box.empty() || (partial.whole && common(reach.box, partial.box).empty());
    if (!apart) return Known::depends;
    return reach.is_inside_elsewhere ? Known::in : Known::out;
  }

  /// Intersects with a primitive; returns false if nothing is left.
  bool narrow(Partial& partial, std::uint32_t primitive) const {
    const facet::Convex& solid = geometry_.solids[primitive];
    if (!partial.whole) {
      partial.whole = make_polytope(solid, geometry_.planes, work_);
    } else {
      for (const facet::Halfspace& halfspace : solid.halfspaces) {
        work_.charge(clip_steps(*partial.whole), multiplying_out);
        partial.whole = clip(std::move(*partial.whole), halfspace, geometry_.planes);
      }
    }
    partial.box = box_of(*partial.whole);
    return !partial.whole->empty();
  }

  /// Intersects with a subtree, and defers its unions; returns false if nothing is left.
  bool absorb(Partial& partial, std::uint32_t root) const {
    std::vector<std::uint32_t> open{root};
    while (!open.empty()) {
      const std::uint32_t at = open.back();
      open.pop_back();
      work_.charge(visit_steps + tree_.nodes[at].children.size(), multiplying_out);
      const Known about = known(at, partial);
      if (about == Known::out) return false;
      if (about == Known::in) continue;
      const PositiveNode& node = tree_.nodes[at];
      if (!node.is_leaf && node.op == PositiveOperator::unite) {
        partial.unions.push_back(at);
      } else if (!node.is_leaf) {
        // Bounded operands are processed first, because they are popped from the end.
        open.insert(open.end(), node.children.rbegin(), node.children.rend());
        std::stable_partition(open.end() - static_cast<std::ptrdiff_t>(node.children.size()), open.end(),
                              [&](std::uint32_t child) { return reaches_[child].is_inside_elsewhere; });
      } else if (node.complemented) {
        partial.subtracted.push_back(node.primitive);
      } else {
        partial.primitive = std::min(partial.primitive, node.primitive);
        if (!narrow(partial, node.primitive)) return false;
      }
    }
    return true;
  }

  /// Continues with every operand of one of the unions, or emits the product if there is no union left.
  void choose(Partial partial) {
    std::erase_if(partial.unions, [&](std::uint32_t node) { return known(node, partial) == Known::in; });
    if (partial.unions.empty()) {
      finish(std::move(partial));
      return;
    }
    const auto bounded = [&](std::uint32_t node) { return !reaches_[node].is_inside_elsewhere; };
    auto chosen = std::find_if(partial.unions.begin(), partial.unions.end(), bounded);
    if (chosen == partial.unions.end()) chosen = partial.unions.begin();
    const std::uint32_t at = *chosen;
    partial.unions.erase(chosen);

    std::vector<Branch> found;
    if (branch_complements(partial, at, found)) {
      const auto parent = std::make_shared<const Partial>(std::move(partial));
      for (const std::uint32_t child : tree_.nodes[at].children) {
        if (!is_complement(child) && known(child, *parent) != Known::out) add(found, {parent, child});
      }
    }
    branches_.insert(branches_.end(), found.rbegin(), found.rend());
  }

  /// Branches off with each complemented primitive and continues inside it. Returns false if nothing is left there.
  bool branch_complements(Partial& partial, std::uint32_t at, std::vector<Branch>& found) {
    for (const std::uint32_t child : tree_.nodes[at].children) {
      if (!is_complement(child)) continue;
      add(found, {std::make_shared<const Partial>(partial), child});
      if (known(child, partial) == Known::in || !narrow(partial, tree_.nodes[child].primitive)) return false;
    }
    return true;
  }

  [[nodiscard]] bool is_complement(std::uint32_t node) const {
    return tree_.nodes[node].is_leaf && tree_.nodes[node].complemented;
  }

  void add(std::vector<Branch>& found, Branch branch) {
    if (++operands_ > max_choices_) {
      throw InputError("expanding the model into products needs more than " + std::to_string(max_choices_) +
                       " choices of a union's operand; intersect or subtract fewer unions of solids that overlap");
    }
    found.push_back(std::move(branch));
  }

  void finish(Partial partial) {
    if (!partial.whole) return;
    std::erase_if(partial.subtracted,
                  [&](std::uint32_t primitive) { return known(tree_.leaf_of[primitive], partial) != Known::depends; });
    std::sort(partial.subtracted.begin(), partial.subtracted.end());
    use_({std::move(*partial.whole), std::move(partial.subtracted), partial.primitive});
  }

  const facet::Geometry& geometry_;
  const PositiveTree& tree_;
  const std::function<void(SolidProduct)>& use_;
  std::uint64_t max_choices_;
  const Work& work_;
  std::vector<Reach> reaches_;
  std::vector<Branch> branches_;
  std::uint64_t operands_ = 0;
};

}  // namespace

void for_each_product(const facet::Geometry& geometry, const PositiveTree& tree,
                      const std::function<void(SolidProduct)>& visit, std::uint64_t max_choices, const Work& work) {
  if (tree.root != model::no_index) Enumeration(geometry, tree, visit, max_choices, work)();
}

}  // namespace csgsim::convex
