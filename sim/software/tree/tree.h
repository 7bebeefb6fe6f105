// Binary CSG trees.
// Used by sim/studies.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::software {

/// A node of a binary tree: a leaf with a primitive, or an operator with two earlier nodes.
struct Node {
  bool is_leaf = false;
  model::Operator op = model::Operator::unite;
  std::uint32_t primitive = model::no_index;
  std::uint32_t left = model::no_index;
  std::uint32_t right = model::no_index;
  std::uint32_t parent = model::no_index;
  std::uint32_t height = 0;  ///< number of levels below it
};

/// A CSG tree of binary operators, as in chapter 4 of the thesis; children precede their parents. A tree without nodes
/// is empty, or all of space if it is complemented.
struct Tree {
  std::vector<Node> nodes;
  std::uint32_t root = model::no_index;
  std::vector<std::uint32_t> leaf_of;  ///< per primitive of the model; no_index if it has no leaf
  bool complemented = false;           ///< the solid is the complement of the root

  [[nodiscard]] bool is_constant() const { return root == model::no_index; }
  /// Number of levels of operators.
  [[nodiscard]] std::uint32_t depth() const { return is_constant() ? 0 : nodes[root].height; }
};

/// How an operator with many children is converted to binary operators.
enum class Shape : std::uint8_t {
  written,    ///< left to right, each node of the file separately
  left_deep,  ///< left to right after merging nodes with the same operator: maximum depth
  balanced,   ///< halved recursively after merging: minimum depth
  reversed,   ///< like balanced, with the operands of unions in reverse order
};

/// A row of the table of shapes.
struct ShapeRow {
  Shape shape;
  std::string_view name;
  std::string_view help;
};

std::span<const ShapeRow> shapes();

/// Converts the model's tree; the solid is the same for every shape.
Tree make_tree(const model::Tree& tree, Shape shape);

/// Whether a primitive contains all or nothing of the region where a tree is used.
enum class Known : std::uint8_t { nothing, out, in };

/// Prunes the tree by the rules of table 4.1 of the thesis. Complements, which arise from IN - TREE, are moved up to
/// the root by de Morgan's laws, so that operands may change sides. `known` has one entry per primitive.
Tree reduced(const Tree& tree, std::span<const Known> known);

}  // namespace csgsim::software
