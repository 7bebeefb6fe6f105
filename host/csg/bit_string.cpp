#include "host/csg/bit_string.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace csgsim::csg {

namespace {

/// A node of the binary tree: some operands of an operator, deepest first, or a single leaf.
struct Part {
  PositiveOperator op = PositiveOperator::intersect;
  std::vector<std::uint32_t> items;  ///< nodes of the active tree
};

/// Two siblings by their positions in the string, and their operator.
struct Siblings {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  PositiveOperator op = PositiveOperator::intersect;
};

class Development {
 public:
  explicit Development(const std::vector<ActiveNode>& nodes, std::uint32_t root)
      : nodes_(nodes), depths_(nodes.size(), 0) {
    for (std::size_t i = 0; i < nodes.size(); ++i) depths_[i] = min_depth(nodes[i].children);
    parts_.push_back(opened(root));
  }

  /// Adds a level; returns false if all parts are leaves.
  bool deepen() {
    std::vector<Siblings> level;
    const std::size_t above = parts_.size();
    for (std::size_t i = 0; i < above; ++i) {
      if (parts_[i].items.size() == 1) continue;
      level.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(parts_.size()), parts_[i].op});
      auto [first, second] = halves(parts_[i]);
      parts_[i] = std::move(first);
      parts_.push_back(std::move(second));
    }
    if (level.empty()) return false;
    levels_.push_back(std::move(level));
    return true;
  }

  [[nodiscard]] const std::vector<std::vector<Siblings>>& levels() const { return levels_; }  ///< from the root down
  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }

 private:
  /// The minimum depth of a binary tree over nodes of known depths: ceil(log2(sum of 2^depth)).
  [[nodiscard]] std::uint32_t min_depth(const std::vector<std::uint32_t>& children) const {
    std::vector<std::uint32_t> depths;
    for (const std::uint32_t child : children) depths.push_back(depths_[child]);
    std::sort(depths.begin(), depths.end());
    std::uint32_t depth = 0;
    std::size_t subtrees = 0;  // number of subtrees of that depth
    for (const std::uint32_t next : depths) {
      for (; depth < next && subtrees > 1; ++depth) subtrees = (subtrees + 1) / 2;
      depth = std::max(depth, next);
      ++subtrees;
    }
    for (; subtrees > 1; ++depth) subtrees = (subtrees + 1) / 2;
    return depth;
  }

  [[nodiscard]] Part opened(std::uint32_t node) const {
    if (nodes_[node].is_leaf) return {nodes_[node].op, {node}};
    Part part{nodes_[node].op, nodes_[node].children};
    std::stable_sort(part.items.begin(), part.items.end(),
                     [this](std::uint32_t a, std::uint32_t b) { return depths_[a] > depths_[b]; });
    return part.items.size() == 1 ? opened(part.items.front()) : part;
  }

  /// Each item goes to the lighter half, where an item of depth d has the weight 2^d. With the deepest items first,
  /// neither half gets deeper than necessary.
  [[nodiscard]] std::pair<Part, Part> halves(const Part& part) const {
    Part first{part.op, {}};
    Part second{part.op, {}};
    // The lead of the first half in weights of the current item, limited to what the remaining items can compensate.
    std::uint64_t lead = 0;
    std::uint32_t depth = depths_[part.items.front()];
    for (const std::uint32_t item : part.items) {
      for (; depth > depths_[item]; --depth) lead = std::min<std::uint64_t>(2 * lead, part.items.size());
      Part& lighter = lead == 0 ? first : second;
      lead = lead == 0 ? 1 : lead - 1;
      lighter.items.push_back(item);
    }
    return {simple(std::move(first)), simple(std::move(second))};
  }

  [[nodiscard]] Part simple(Part part) const {
    return part.items.size() == 1 ? opened(part.items.front()) : std::move(part);
  }

  const std::vector<ActiveNode>& nodes_;
  std::vector<std::uint32_t> depths_;
  std::vector<Part> parts_;
  std::vector<std::vector<Siblings>> levels_;
};

/// Adds the AND of two siblings; extends the last run if it continues there.
void add_and_run(std::vector<AndRun>& and_runs, const Siblings& siblings) {
  if (!and_runs.empty()) {
    AndRun& last = and_runs.back();
    if (siblings.first == last.first + last.bits && siblings.second == last.second + last.bits) {
      ++last.bits;
      return;
    }
  }
  and_runs.push_back({siblings.first, siblings.second, 1});
}

}  // namespace

std::uint32_t count_leaves(const std::vector<ActiveNode>& nodes, std::uint32_t root) {
  std::uint32_t leaves = 0;
  std::vector<std::uint32_t> open{root};
  while (!open.empty()) {
    const ActiveNode& node = nodes[open.back()];
    open.pop_back();
    if (node.is_leaf) ++leaves;
    open.insert(open.end(), node.children.begin(), node.children.end());
  }
  return leaves;
}

BitString make_bit_string(const std::vector<ActiveNode>& nodes, std::uint32_t root) {
  Development development(nodes, root);
  while (development.deepen()) {
  }
  BitString string;
  std::vector<bool> inverted;
  for (const Part& part : development.parts()) {
    string.leaves.push_back(part.items.front());
    inverted.push_back(nodes[part.items.front()].complemented);
  }
  for (auto siblings = development.levels().rbegin(); siblings != development.levels().rend(); ++siblings) {
    StringLevel level;
    for (const auto& [first, second, op] : *siblings) {
      const bool wanted = op == PositiveOperator::unite;
      for (const std::uint32_t position : {first, second}) {
        if (inverted[position] != wanted) level.inverted.push_back(position);
      }
      inverted[first] = wanted;
      add_and_run(level.and_runs, {first, second, op});
    }
    std::sort(level.inverted.begin(), level.inverted.end());
    string.levels.push_back(std::move(level));
  }
  string.inverted = inverted.front();
  return string;
}

}  // namespace csgsim::csg
