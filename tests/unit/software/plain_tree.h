#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::testing {

/// Number of visited tree nodes, and of operands skipped because the other one, or the previous status, decided.
struct TreeVisits {
  std::uint64_t visits = 0;
  std::uint64_t early_outs = 0;
  std::uint64_t differences = 0;  ///< difference nodes among the visits of an update

  TreeVisits& operator+=(const TreeVisits& more) {
    visits += more.visits;
    early_outs += more.early_outs;
    differences += more.differences;
    return *this;
  }
};

/// Whether a point is in each primitive.
using Held = std::vector<bool>;

/// The binary tree of a model as written, evaluated by the rules of the thesis.
class PlainTree {
 public:
  explicit PlainTree(const model::Tree& tree);

  [[nodiscard]] std::uint64_t nodes() const { return nodes_.size(); }
  [[nodiscard]] std::uint64_t levels() const { return levels(root_); }
  [[nodiscard]] bool holds(const Held& held) const { return holds(root_, held); }
  /// Nodes that are left by table 4.1 when absent primitives are out.
  [[nodiscard]] std::uint64_t nodes_with(const Held& present) const { return nodes_with(root_, present); }
  /// Whether the primitive is in the right operand of an odd number of differences.
  [[nodiscard]] bool is_subtracted(std::uint32_t primitive) const;

  /// Table 4.3: skips the right operand if the left one decides.
  [[nodiscard]] TreeVisits early_out(const Held& held) const;
  /// Table 4.4: also skips operands in which no primitive holds the point.
  [[nodiscard]] TreeVisits positional(const Held& held) const;
  /// Table 4.5: walks from the primitive's leaf upwards to the first node whose status stays the same.
  [[nodiscard]] TreeVisits update_tree(Held& held, std::uint32_t primitive) const;
  /// Whether no operator above the primitive's leaf removes its surface; `tally` receives the visited nodes.
  [[nodiscard]] bool shows(const Held& held, std::uint32_t primitive, TreeVisits& tally) const;

 private:
  static constexpr std::uint32_t none = model::no_index;
  struct Node {
    std::optional<model::Operator> op{};  ///< empty for a leaf
    std::uint32_t primitive = none;
    std::uint32_t left = none;
    std::uint32_t right = none;
    std::uint32_t parent = none;
  };

  std::uint32_t add(const model::Tree& tree, std::uint32_t node);
  [[nodiscard]] std::uint64_t levels(std::uint32_t node) const;
  [[nodiscard]] std::uint64_t nodes_with(std::uint32_t node, const Held& there) const;
  [[nodiscard]] bool holds(std::uint32_t node, const Held& held) const;
  [[nodiscard]] bool has_any(std::uint32_t node, const Held& held) const;
  [[nodiscard]] bool is_on_odd_side(std::uint32_t node) const;
  bool early_out(std::uint32_t node, const Held& held, TreeVisits& tally) const;
  bool positional(std::uint32_t node, const Held& held, TreeVisits& tally) const;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> leaf_of_;  ///< leaf node of each primitive
  std::uint32_t root_ = none;
};

}  // namespace csgsim::testing
