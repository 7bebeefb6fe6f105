// CSG trees of convex primitives.
// Used throughout the host and the simulators.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace csgsim::model {

/// How round shapes are faceted, as with OpenSCAD's special variables.
struct FacetControl {
  double fn = 0;   ///< $fn: fragments of a circle; 0: determined by fa and fs
  double fa = 12;  ///< $fa: minimum angle of a fragment, degrees
  double fs = 2;   ///< $fs: minimum length of a fragment, model units

  bool operator==(const FacetControl&) const = default;
};

struct Cube {
  glm::dvec3 size{1};
  bool center = false;
};

struct Sphere {
  double radius = 1;
  FacetControl facets;
};

/// A cylinder, cone or frustum about the z axis. r1 is the radius of the lower end.
struct Cylinder {
  double height = 1;
  double r1 = 1;
  double r2 = 1;
  bool center = false;
  FacetControl facets;
};

/// A closed convex polyhedron; `faces` index `points`, with either orientation, but the same for all.
struct Polyhedron {
  std::vector<glm::dvec3> points;
  std::vector<std::vector<std::uint32_t>> faces;
  /// Each face's outward unit normal, and the negated distance from the origin along it. Pieces of one solid use
  /// identical numbers for the same plane. If empty, the planes are those through the corners.
  std::vector<glm::dvec4> planes{};
};

using Shape = std::variant<Cube, Sphere, Cylinder, Polyhedron>;

/// A position in the source file; line and column count from 1.
struct Location {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

inline constexpr std::uint32_t no_index = 0xffffffffU;

/// A convex solid of the model, in place: a node of the file, or one of its pieces.
struct Primitive {
  Shape shape;
  glm::dmat4 transform{1};           ///< local to model space; the last row is 0 0 0 1
  std::optional<glm::dvec3> colour;  ///< red, green, blue in [0, 1]; empty if the model gives none
  Location location;
  double opacity = 1;                ///< alpha of the colour: from 0, transparent, to 1, opaque
  std::uint32_t section = no_index;  ///< number of the cutting plane, if it stands for one and is not in the file
  std::string_view node{};           ///< name in the file, if it is not the shape's name
  bool continues = false;            ///< a piece of the same node of the file as the primitive before it
};

enum class Operator : std::uint8_t { unite, subtract, intersect };

/// A node of the tree: a leaf that names a primitive, or an operator over at least two children. `subtract` removes all
/// further children from the first.
struct Node {
  bool is_leaf = false;
  Operator op = Operator::unite;
  std::uint32_t primitive = no_index;   ///< leaf: index into Tree::primitives
  std::vector<std::uint32_t> children;  ///< operator: indices into Tree::nodes, each smaller than the node's own
  bool of_pieces = false;               ///< operator: joins the pieces of one node of the file
};

/// A CSG tree. Children precede their parents in `nodes`, so that a single pass is a postorder traversal without
/// recursion. Primitives are in tree order (left to right). An empty model has no nodes, and root == no_index.
struct Tree {
  std::string file;
  std::vector<std::filesystem::path> imports{};  ///< other files that it includes
  std::vector<Primitive> primitives;
  std::vector<Node> nodes;
  std::uint32_t root = no_index;
  bool is_flat = false;  ///< consists only of 2-D shapes, which are represented as plates
};

/// Appends a primitive and its leaf. Returns the leaf's index; the primitive is the last one.
std::uint32_t add_leaf(Tree& tree, Primitive primitive);

/// Numbers of nodes of the file. Operators count as binary ones: one over k children counts k - 1.
struct Counts {
  std::uint64_t primitives = 0;  ///< each counts once, regardless of its pieces
  std::uint64_t unions = 0;
  std::uint64_t differences = 0;
  std::uint64_t intersections = 0;
};

Counts count(const Tree& tree);

/// The position of the primitive as a prefix for messages: file:line:column.
std::string place_of(const Tree& tree, std::uint32_t primitive);

}  // namespace csgsim::model
