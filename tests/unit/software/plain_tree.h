#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::testing {

/// Nodes of a tree that were looked at, and operands left out since the other one, or what was there before, decided.
struct Looks {
  std::uint64_t visits = 0;
  std::uint64_t early_outs = 0;
  std::uint64_t differences = 0;  ///< of the visits of a change, those of differences

  Looks& operator+=(const Looks& more) {
    visits += more.visits;
    early_outs += more.early_outs;
    differences += more.differences;
    return *this;
  }
};

/// Of each primitive whether a point is in it.
using Held = std::vector<bool>;

/// The binary tree that a model is as it is written, and what the rules of the thesis look at in it.
class PlainTree {
 public:
  explicit PlainTree(const model::Tree& tree);

  [[nodiscard]] std::uint64_t nodes() const { return nodes_.size(); }
  [[nodiscard]] std::uint64_t levels() const { return levels(root_); }
  [[nodiscard]] bool holds(const Held& held) const { return holds(root_, held); }
  /// Nodes that are left when the primitives that are not there are out, by table 4.1.
  [[nodiscard]] std::uint64_t nodes_with(const Held& there) const { return nodes_with(root_, there); }
  /// Whether it is on the right of an odd number of differences.
  [[nodiscard]] bool is_taken_away(std::uint32_t primitive) const;

  /// Table 4.3: no right operand where the left one decides.
  [[nodiscard]] Looks early_out(const Held& held) const;
  /// Table 4.4: besides, no operand without a primitive that holds the point.
  [[nodiscard]] Looks positional(const Held& held) const;
  /// Table 4.5: from the primitive's leaf upwards, up to a node that stays as it is.
  [[nodiscard]] Looks change(Held& held, std::uint32_t primitive) const;
  /// Upwards from the primitive's leaf, up to an operator that hides it.
  [[nodiscard]] bool shows(const Held& held, std::uint32_t primitive, Looks& looks) const;

 private:
  static constexpr std::uint32_t none = model::no_index;
  struct Node {
    std::optional<model::Operator> op{};  ///< none of a leaf
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
  bool early_out(std::uint32_t node, const Held& held, Looks& looks) const;
  bool positional(std::uint32_t node, const Held& held, Looks& looks) const;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> leaf_of_;  ///< of each primitive
  std::uint32_t root_ = none;
};

}  // namespace csgsim::testing
