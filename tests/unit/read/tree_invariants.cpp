#include "tests/unit/read/tree_invariants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace csgsim::read_test {

namespace {

bool in_unit_range(const glm::dvec3& colour) {
  return std::min({colour.x, colour.y, colour.z}) >= 0 && std::max({colour.x, colour.y, colour.z}) <= 1;
}

bool is_placement(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(matrix[column][row])) return false;
    }
  }
  return matrix[0][3] == 0 && matrix[1][3] == 0 && matrix[2][3] == 0 && matrix[3][3] == 1;
}

struct HasSize {
  static bool is_size(double value) { return value > 0 && std::isfinite(value); }

  bool operator()(const model::Cube& cube) const {
    return is_size(cube.size.x) && is_size(cube.size.y) && is_size(cube.size.z);
  }
  bool operator()(const model::Sphere& sphere) const { return is_size(sphere.radius); }
  bool operator()(const model::Cylinder& c) const {
    return is_size(c.height) && c.r1 >= 0 && c.r2 >= 0 && is_size(std::max(c.r1, c.r2));
  }
  bool operator()(const model::Polyhedron& polyhedron) const {
    const auto valid = [&](const auto& face) {
      return face.size() >= 3 && std::ranges::max(face) < polyhedron.points.size();
    };
    return polyhedron.points.size() >= 4 && polyhedron.faces.size() >= 4 &&
           std::ranges::all_of(polyhedron.faces, valid);
  }
};

}  // namespace

std::string broken_invariant(const model::Tree& tree) {
  std::uint32_t next_primitive = 0;
  std::vector<bool> has_parent(tree.nodes.size());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const model::Node& node = tree.nodes[i];
    if (node.is_leaf && node.primitive != next_primitive++) return "primitives are not in tree order";
    if (!node.is_leaf && node.children.size() < 2) return "an operator has fewer than two children";
    for (const std::uint32_t child : node.children) {
      if (child >= i) return "a child follows its parent";
      if (has_parent[child]) return "a node has two parents";
      has_parent[child] = true;
    }
  }
  if (next_primitive != tree.primitives.size()) return "a primitive has no leaf";
  if (tree.nodes.empty() != (tree.root == model::no_index)) return "an empty tree has a root or a tree has none";
  if (!tree.nodes.empty() && tree.root != tree.nodes.size() - 1) return "the root is not last";
  if (std::ranges::count(has_parent, false) > 1) return "a node is outside the tree";
  for (const model::Primitive& primitive : tree.primitives) {
    if (!is_placement(primitive.transform)) return "a transform is not affine and finite";
    if (primitive.colour && !in_unit_range(*primitive.colour)) return "a colour is out of range";
    if (!std::visit(HasSize{}, primitive.shape)) return "a solid is empty";
    if (primitive.location.line == 0 || primitive.location.column == 0) return "a place does not count from 1";
  }
  return "";
}

}  // namespace csgsim::read_test
