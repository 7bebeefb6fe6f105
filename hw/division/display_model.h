// The display model: planes, primitives and tree of the picture, the input of the divider. Used by hw/multi_processor
// and host/emit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hw/division/rectangle.h"
#include "hw/isa/instruction.h"

namespace csgsim::division {

// The host sends one display model per frame: the model in the camera's view, in integers. Widths on a link are
// defined in hw/division/encoding.h, semantics in docs/machines/pixel-square.md.

inline constexpr unsigned min_z_bits = 4;
inline constexpr unsigned max_z_bits = 30;
inline constexpr unsigned max_fraction_bits = 20;
inline constexpr std::size_t max_records = (std::size_t{1} << 31U) - 1;  ///< maximum number of planes, primitives or
                                                                         ///< nodes

/// |A| * width + |B| * height + |C| of a plane is below 2^61. The value at a pixel plus a depth step, or plus the whole
/// depth range, therefore fits 64 bits.
inline constexpr unsigned reach_bits = 61;

/// A*x + B*y + C, where x and y are column and row of the picture.
struct Plane {
  bool is_edge = false;  ///< a line that divides the picture; otherwise a depth in steps, with `fraction_bits` fraction
                         ///< bits
  std::int64_t a = 0;
  std::int64_t b = 0;
  std::int64_t c = 0;

  bool operator==(const Plane&) const = default;
};

/// Interior of a half-space. F is the plane's value; for a depth, its fraction is dropped (floor).
enum class Side : std::uint8_t {
  front,         ///< z >= F
  back,          ///< z < F
  not_negative,  ///< F >= 0
  negative,      ///< F < 0
};

struct Halfspace {
  std::uint32_t plane = 0;
  bool forward = true;  ///< true for front and not_negative, false for back and negative
  /// Colour of the facet, as stored in the colour field; 0 if it is never visible, see is_visible_side().
  std::uint32_t colour = 0;

  bool operator==(const Halfspace&) const = default;
};

/// A convex solid without its half-spaces.
struct PrimitiveHead {
  Box box;                        ///< z_low is at most 2^z_bits, z_high at least -1
  bool complemented = false;      ///< represents the space outside the solid, in the tree's positive form
  bool joined = false;            ///< drawn with the previous primitive as one convex solid
  std::uint32_t near_colour = 0;  ///< colour of its surface at depth 0; 0 if complemented

  bool operator==(const PrimitiveHead&) const = default;
};

/// A convex solid: the intersection of its half-spaces within its rectangle of pixels. Its surface is within its box.
struct Primitive : PrimitiveHead {
  std::vector<Halfspace> halfspaces;

  bool operator==(const Primitive&) const = default;
};

enum class Operator : std::uint8_t { unite, intersect };

/// A node of the tree in positive form. Nodes are in postorder: an operator's operands are the last `operands`
/// preceding subtrees that have no operator yet; the leaves are the primitives in order.
struct Node {
  std::uint32_t operands = 0;  ///< 0 for a leaf, otherwise at least 2
  Operator op = Operator::unite;

  bool operator==(const Node&) const = default;
};

/// Positions of the fields in pixel memory.
struct Fields {
  isa::Field depth;      ///< Z2: depth of the nearest surface
  isa::Field candidate;  ///< Z1: depth of the surface being classified
  isa::Field colour;     ///< colour of Z2
  /// Colour of Z1; width 0 if the facets are broadcast again to store their colours in `colour`.
  isa::Field candidate_colour;
  isa::Field mask;
  std::uint32_t stack_base = 0;  ///< first memory bit of the stack of intermediate results
  std::uint32_t stack_bits = 0;  ///< number of bits of that stack

  bool operator==(const Fields&) const = default;
};

/// Properties of the whole picture.
struct ModelHeader {
  std::uint32_t width = 0;     ///< width of the picture in pixels
  std::uint32_t height = 0;    ///< height in pixels
  unsigned z_bits = 0;         ///< bits of the depth fields
  unsigned fraction_bits = 0;  ///< fraction bits of planes' depths
  unsigned colour_bits = 0;
  std::uint32_t background = 0;  ///< colour where nothing is visible
  Fields fields;

  /// The greatest value of a depth, which is that of the background.
  [[nodiscard]] std::int64_t farthest() const { return (std::int64_t{1} << z_bits) - 1; }
  /// This object as a header, for derived classes.
  [[nodiscard]] const ModelHeader& header() const { return *this; }
  bool operator==(const ModelHeader&) const = default;
};

struct DisplayModel : ModelHeader {
  std::vector<Plane> planes;
  std::vector<Primitive> primitives;
  std::vector<Node> nodes;

  bool operator==(const DisplayModel&) const = default;
};

constexpr Side side_of(const Plane& plane, bool forward) {
  if (plane.is_edge) return forward ? Side::not_negative : Side::negative;
  return forward ? Side::front : Side::back;
}

/// Whether a facet on that side is part of the visible surface of a primitive: a front, or a back if the primitive is
/// complemented.
constexpr bool is_visible_side(Side side, bool complemented) {
  return side == (complemented ? Side::back : Side::front);
}

/// Throws InputError unless the model is valid: every number is in range and within the picture, the fields are
/// disjoint and within pixel memory, plane values are below 2^reach_bits, and the nodes form a single tree with one
/// leaf per primitive.
void validate(const DisplayModel& model);

}  // namespace csgsim::division
