#include "sim/software/tree/tree.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/software/tree/builder.h"

namespace csgsim::software {

namespace {

constexpr std::array shape_rows{
    ShapeRow{Shape::written, "written", "nodes as in the file, each from left to right"},
    ShapeRow{Shape::left_deep, "left-deep", "nodes with the same operator merged, then from left to right"},
    ShapeRow{Shape::balanced, "balanced", "nodes with the same operator merged, then halved recursively"},
    ShapeRow{Shape::reversed, "reversed", "like balanced, operands of unions in reverse order"}};

std::uint32_t from_the_left(Builder& builder, model::Operator op, std::span<const std::uint32_t> parts) {
  std::uint32_t node = parts.front();
  for (const std::uint32_t part : parts.subspan(1)) node = builder.join(op, node, part);
  return node;
}

/// Index at which to split so that neither side is deeper than necessary: a part of height h has the weight of 2^h
/// leaves.
std::size_t middle_of(const Builder& builder, std::span<const std::uint32_t> parts) {
  std::vector<double> weights;
  double all = 0;
  for (const std::uint32_t part : parts) {
    constexpr std::uint32_t max_exponent = 500;  // so that the sum fits in a double
    all += std::ldexp(1.0, static_cast<int>(std::min(builder.height(part), max_exponent)));
    weights.push_back(all);
  }
  const auto half = std::ranges::lower_bound(weights, all / 2);
  const auto before = static_cast<std::size_t>(half - weights.begin());
  // The part that contains the midpoint goes to the side with the larger share of it.
  const double over = weights[before] - all / 2;
  const double under = all / 2 - (before == 0 ? 0 : weights[before - 1]);
  return std::clamp<std::size_t>(over <= under ? before + 1 : before, 1, parts.size() - 1);
}

std::uint32_t by_halves(Builder& builder, model::Operator op, std::span<const std::uint32_t> parts) {
  if (parts.size() == 1) return parts.front();
  const std::size_t middle = middle_of(builder, parts);
  const std::uint32_t left = by_halves(builder, op, parts.first(middle));
  return builder.join(op, left, by_halves(builder, op, parts.subspan(middle)));
}

/// Converts nodes of the model to binary nodes, or to operands of their parents.
class Shaper {
 public:
  Shaper(const model::Tree& tree, Shape shape) : tree_(tree), shape_(shape), builder_(tree.primitives.size()) {}

  Tree build() {
    std::vector<std::vector<std::uint32_t>> operands(tree_.nodes.size());
    for (std::size_t i = 0; i < tree_.nodes.size(); ++i) operands[i] = operands_of(tree_.nodes[i], operands);
    const model::Node& root = tree_.nodes[tree_.root];
    return builder_.take_tree(joined(root.op, operands[tree_.root]));
  }

 private:
  using Operands = std::vector<std::uint32_t>;

  Operands operands_of(const model::Node& node, std::vector<Operands>& operands) {
    if (node.is_leaf) return {builder_.leaf(node.primitive)};
    Operands all;
    for (std::size_t c = 0; c < node.children.size(); ++c) {
      const model::Node& child = tree_.nodes[node.children[c]];
      // The subtracted operands form a union; a difference subtracts its parts one by one.
      const model::Operator joins = node.op == model::Operator::subtract && c > 0 ? model::Operator::unite : node.op;
      Operands& parts = operands[node.children[c]];
      const bool is_joined = shape_ != Shape::written && !child.is_leaf && child.op == joins;
      if (is_joined) {
        all.insert(all.end(), parts.begin(), parts.end());
      } else {
        all.push_back(joined(child.op, parts));
      }
      Operands().swap(parts);
    }
    return all;
  }

  std::uint32_t joined(model::Operator op, Operands parts) {
    if (parts.size() == 1) return parts.front();
    if (shape_ == Shape::written || shape_ == Shape::left_deep) return from_the_left(builder_, op, parts);
    // The subtracted operands form a union.
    const std::span<std::uint32_t> united = op == model::Operator::subtract ? std::span(parts).subspan(1) : parts;
    if (shape_ == Shape::reversed && op != model::Operator::intersect) std::ranges::reverse(united);
    if (op != model::Operator::subtract) return by_halves(builder_, op, parts);
    return builder_.join(op, parts.front(), by_halves(builder_, model::Operator::unite, united));
  }

  const model::Tree& tree_;
  Shape shape_;
  Builder builder_;
};

}  // namespace

std::span<const ShapeRow> shapes() { return shape_rows; }

Tree make_tree(const model::Tree& tree, Shape shape) {
  if (tree.root == model::no_index) return {};
  return Shaper(tree, shape).build();
}

}  // namespace csgsim::software
