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

/// How round things are faceted, as OpenSCAD's special variables say.
struct FacetControl {
  double fn = 0;   ///< $fn: fragments of a circle; 0 leaves it to fa and fs
  double fa = 12;  ///< $fa: least angle of a fragment, degrees
  double fs = 2;   ///< $fs: least length of a fragment, model units

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

/// A cylinder, cone or frustum about the z axis. r1 is at the lower end.
struct Cylinder {
  double height = 1;
  double r1 = 1;
  double r2 = 1;
  bool center = false;
  FacetControl facets;
};

/// A closed convex polyhedron; `faces` index `points`, in either consistent orientation.
struct Polyhedron {
  std::vector<glm::dvec3> points;
  std::vector<std::vector<std::uint32_t>> faces;
  /// Each face's outward normal, of length 1, and its distance from the origin along that, negated. Pieces of one solid
  /// give the same plane by the same numbers. Empty: the planes through the corners.
  std::vector<glm::dvec4> planes{};
};

using Shape = std::variant<Cube, Sphere, Cylinder, Polyhedron>;

/// A place in the source file; line and column count from 1.
struct Location {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

inline constexpr std::uint32_t no_index = 0xffffffffU;

/// A convex solid of the model, in place: what a node of the file stands for, or one of the pieces of that.
struct Primitive {
  Shape shape;
  glm::dmat4 transform{1};           ///< object to model space; the last row is 0 0 0 1
  std::optional<glm::dvec3> colour;  ///< red, green, blue in [0, 1], if the model says one
  Location location;
  double opacity = 1;                ///< alpha of the colour: from 0, clear, to 1, opaque
  std::uint32_t section = no_index;  ///< number of the cutting plane that it stands for, if it is none of the file's
  std::string_view node{};           ///< what the file calls it, if that is not its shape's name
  bool continues = false;            ///< a piece of the same node of the file as the primitive before it
};

enum class Operator : std::uint8_t { unite, subtract, intersect };

/// A node of the tree: a leaf that names a primitive, or an operator over at least two children.
/// `subtract` takes all further children from the first.
struct Node {
  bool is_leaf = false;
  Operator op = Operator::unite;
  std::uint32_t primitive = no_index;   ///< leaf: index into Tree::primitives
  std::vector<std::uint32_t> children;  ///< operator: indices into Tree::nodes, each smaller than the node's own
  bool of_pieces = false;               ///< operator: of the pieces of one node of the file
};

/// A CSG tree. Children precede their parents in `nodes`, so a single pass in order is a postorder traversal and no
/// tree is too deep. Primitives are in tree order (left to right). An empty model has no nodes and root == no_index.
struct Tree {
  std::string file;
  std::vector<std::filesystem::path> imports{};  ///< other files that it is made of
  std::vector<Primitive> primitives;
  std::vector<Node> nodes;
  std::uint32_t root = no_index;
  bool is_flat = false;  ///< of 2-D shapes alone, which stand there as plates
};

/// Appends a primitive and its leaf. Returns the leaf's index; the primitive is the last one.
std::uint32_t add_leaf(Tree& tree, Primitive primitive);

/// Counts the nodes of the file. Operators count as binary ones: one over k children is k - 1.
struct Counts {
  std::uint64_t primitives = 0;  ///< each once, whatever its pieces
  std::uint64_t unions = 0;
  std::uint64_t differences = 0;
  std::uint64_t intersections = 0;
};

Counts count(const Tree& tree);

/// Where the file has the primitive, as messages begin: file:line:column.
std::string place_of(const Tree& tree, std::uint32_t primitive);

}  // namespace csgsim::model
