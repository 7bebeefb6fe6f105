#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::software {

/// A node of a binary tree: a leaf that names a primitive, or an operator over two nodes before it.
struct Node {
  bool is_leaf = false;
  model::Operator op = model::Operator::unite;
  std::uint32_t primitive = model::no_index;
  std::uint32_t left = model::no_index;
  std::uint32_t right = model::no_index;
  std::uint32_t parent = model::no_index;
  std::uint32_t height = 0;  ///< levels below it
};

/// A CSG tree of binary operators, as chapter 4 of the thesis has them; children precede their parents. A tree without
/// nodes holds nothing, or everything if it is complemented.
struct Tree {
  std::vector<Node> nodes;
  std::uint32_t root = model::no_index;
  std::vector<std::uint32_t> leaf_of;  ///< of each primitive of the model; no_index where it has none
  bool complemented = false;           ///< the solid is what the root does not hold

  [[nodiscard]] bool is_constant() const { return root == model::no_index; }
  /// Levels of operators.
  [[nodiscard]] std::uint32_t depth() const { return is_constant() ? 0 : nodes[root].height; }
};

/// How an operator over many children becomes binary ones.
enum class Shape : std::uint8_t {
  written,    ///< from the left, each node of the file by itself
  left_deep,  ///< from the left, when nodes of one operator have been joined: as deep as it gets
  balanced,   ///< by halves, when they have been joined, so that a tree is as low as its operators allow
  reversed,   ///< the same, the operands of unions from the last to the first
};

/// A row of the table of shapes.
struct ShapeRow {
  Shape shape;
  std::string_view name;
  std::string_view help;
};

std::span<const ShapeRow> shapes();

/// The same solid, whatever the shape.
Tree make_tree(const model::Tree& tree, Shape shape);

/// What is known of a primitive beforehand, wherever a tree is to be used.
enum class Known : std::uint8_t { nothing, out, in };

/// The tree pruned by the rules of table 4.1 of the thesis. The NOT TREE that IN - TREE leaves is carried up by de
/// Morgan's laws, to the tree as a whole in the end, so that operands may change sides. `known`: one a primitive.
Tree reduced(const Tree& tree, std::span<const Known> known);

}  // namespace csgsim::software
