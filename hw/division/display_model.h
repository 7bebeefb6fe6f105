#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hw/division/rectangle.h"
#include "hw/isa/instruction.h"

namespace csgsim::division {

// What the host sends to the divider, once a frame, by value: the model as the camera sees it, in integers. Widths of
// all of it on a link are in hw/division/encoding.h; meanings and rules in docs/machines/pixel-square.md.

inline constexpr unsigned fewest_z_bits = 4;
inline constexpr unsigned most_z_bits = 30;
inline constexpr unsigned most_fraction_bits = 20;
inline constexpr std::size_t most_records = (std::size_t{1} << 31U) - 1;  ///< planes, primitives, nodes

/// |A| * width + |B| * height + |C| of a plane is below 2^61: its value at a pixel, with a depth step or the whole
/// depth range added, fits 64 bits.
inline constexpr unsigned reach_bits = 61;

/// A*x + B*y + C, x and y the column and row of the picture.
struct Plane {
  bool is_edge = false;  ///< a line that divides the picture; else a depth in steps, with `fraction_bits` below one
  std::int64_t a = 0;
  std::int64_t b = 0;
  std::int64_t c = 0;

  bool operator==(const Plane&) const = default;
};

/// What is inside a half-space: F is the plane's value, of a depth without its fraction, rounded down.
enum class Side : std::uint8_t {
  front,         ///< z >= F
  back,          ///< z < F
  not_negative,  ///< F >= 0
  negative,      ///< F < 0
};

struct Halfspace {
  std::uint32_t plane = 0;
  bool forward = true;       ///< front or not negative; else back or negative
  std::uint32_t colour = 0;  ///< of the facet, as the colour field holds it; 0 where it is not seen()

  bool operator==(const Halfspace&) const = default;
};

/// What is said of a convex solid besides its half-spaces.
struct PrimitiveHead {
  Box box;                        ///< z_low is at most 2^z_bits, z_high at least -1
  bool complemented = false;      ///< stands for the space outside it in the tree's positive form
  bool joined = false;            ///< drawn with the one before it as one convex solid
  std::uint32_t near_colour = 0;  ///< of its surface at depth 0; 0 if complemented

  bool operator==(const PrimitiveHead&) const = default;
};

/// A convex solid: where all its half-spaces are, in its rectangle of pixels. Its surface is within its box.
struct Primitive : PrimitiveHead {
  std::vector<Halfspace> halfspaces;

  bool operator==(const Primitive&) const = default;
};

enum class Operator : std::uint8_t { unite, intersect };

/// A node of the tree in positive form. Nodes come in postorder: an operator's operands are the last so many subtrees
/// before it that have no operator yet; the leaves are the primitives in order.
struct Node {
  std::uint32_t operands = 0;  ///< 0 for a leaf, else 2 at least
  Operator op = Operator::unite;

  bool operator==(const Node&) const = default;
};

/// Where the fields are in pixel memory.
struct Fields {
  isa::Field depth;             ///< Z2: the nearest surface so far
  isa::Field candidate;         ///< Z1: the surface being classified
  isa::Field colour;            ///< of Z2
  isa::Field candidate_colour;  ///< of Z1; no width if facets are broadcast again to find their colours
  isa::Field mask;
  std::uint32_t stack_base = 0;  ///< the first bit of pending results
  std::uint32_t stack_bits = 0;  ///< how many there are

  bool operator==(const Fields&) const = default;
};

/// What is said of the whole picture.
struct ModelHeader {
  std::uint32_t width = 0;     ///< of the picture, pixels
  std::uint32_t height = 0;    ///< pixels
  unsigned z_bits = 0;         ///< of the depth fields
  unsigned fraction_bits = 0;  ///< of the depths of planes
  unsigned colour_bits = 0;
  std::uint32_t background = 0;  ///< colour where nothing is seen
  Fields fields;

  [[nodiscard]] std::int64_t farthest() const { return (std::int64_t{1} << z_bits) - 1; }
  /// Of a model without all that follows it.
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

/// Whether the facet on the half-space is part of what is seen of such a primitive: the front of one that stands for
/// itself, the back of a complemented one.
constexpr bool seen(Side side, bool complemented) { return side == (complemented ? Side::back : Side::front); }

/// Throws InputError unless the model is sound: everything in range and in the picture, fields in pixel memory and
/// disjoint, planes in reach, the nodes one tree with a leaf a primitive.
void validate(const DisplayModel& model);

}  // namespace csgsim::division
