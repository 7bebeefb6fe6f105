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

/// How round shapes are faceted; the members are OpenSCAD's special variables.
struct FacetControl {
  double fn = 0;   ///< $fn: fragments of a circle; 0 if fa and fs determine the number
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

/// A closed convex polyhedron. `faces` index `points`; all faces have the same orientation, either way.
struct Polyhedron {
  std::vector<glm::dvec3> points;
  std::vector<std::vector<std::uint32_t>> faces;
  /// Each face's outward unit normal, and the negated distance from the origin along it. Pieces of one solid use
  /// identical numbers for the same plane. If empty, the planes are those through the faces' corners.
  std::vector<glm::dvec4> planes{};
};

using Shape = std::variant<Cube, Sphere, Cylinder, Polyhedron>;

/// A position in the source file; line and column count from 1.
struct Location {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

inline constexpr std::uint32_t no_index = 0xffffffffU;

/// A convex solid of the model: a node of the file, or one piece of a node.
struct Primitive {
  Shape shape;
  glm::dmat4 transform{1};           ///< local to model space; the last row is 0 0 0 1
  std::optional<glm::dvec3> colour;  ///< red, green, blue in [0, 1]; empty if the model specifies no colour
  Location location;
  double opacity = 1;  ///< alpha of the colour: from 0, transparent, to 1, opaque
  /// Number of the cutting plane, if the primitive represents one and is not in the file.
  std::uint32_t section = no_index;
  std::string_view node{};  ///< name in the file, if it is not the shape's name
  bool continues = false;   ///< whether the primitive is a further piece of the node of the previous primitive
};

enum class Operator : std::uint8_t { unite, subtract, intersect };

/// A node of the tree: a leaf that names a primitive, or an operator over at least two children. `subtract` removes all
/// further children from the first.
struct Node {
  bool is_leaf = false;
  Operator op = Operator::unite;
  std::uint32_t primitive = no_index;  ///< of a leaf: index into Tree::primitives
  /// Indices of an operator's operands in Tree::nodes, all smaller than this node's index.
  std::vector<std::uint32_t> children;
  bool of_pieces = false;  ///< of an operator: whether it joins the pieces of one node of the file
};

/// A CSG tree. Children precede their parents in `nodes`, so a single pass is a postorder traversal without recursion.
/// Primitives are in tree order (left to right). An empty model has no nodes, and root == no_index.
struct Tree {
  std::string file;
  std::vector<std::filesystem::path> imports{};  ///< paths of imported files
  std::vector<Primitive> primitives;
  std::vector<Node> nodes;
  std::uint32_t root = no_index;
  bool is_flat = false;  ///< whether the model consists only of 2-D shapes, which are represented as plates
};

/// Appends a primitive and its leaf. Returns the index of the leaf; the primitive is the last one in `primitives`.
std::uint32_t add_leaf(Tree& tree, Primitive primitive);

/// Numbers of nodes in the file. Operators count as binary ones: an operator with k children counts k - 1.
struct Counts {
  std::uint64_t primitives = 0;  ///< a primitive counts once, regardless of the number of its pieces
  std::uint64_t unions = 0;
  std::uint64_t differences = 0;
  std::uint64_t intersections = 0;
};

Counts count(const Tree& tree);

/// The position of the primitive as a prefix for messages: file:line:column.
std::string location_text(const Tree& tree, std::uint32_t primitive);

}  // namespace csgsim::model
