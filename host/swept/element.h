// Surface elements and quadtree streams.
// Used throughout host/swept.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

namespace csgsim::swept {

/// Maximum number of times that a patch may be halved along a side.
inline constexpr std::uint32_t max_depth = 16;

/// A square in a patch's parameter space, in units of 2^-max_depth of the patch's side.
struct Square {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  std::uint32_t size = std::uint32_t{1} << max_depth;
};

inline constexpr std::uint32_t whole_side = Square{}.size;

/// Corners in the order of a square's four parts: south-west, south-east, north-west, north-east.
enum Corner : std::uint8_t { sw, se, nw, ne };

/// A surface element: a leaf of a patch's quadtree.
struct Element {
  Square square;
  std::array<glm::dvec3, 4> corners;
};

/// A node of a patch's quadtree in depth-first order, `(` or `L` of a DF-expression (Kawaguchi and Endo 1980).
struct Node {
  bool is_leaf = false;
  Element element;
};

/// The nodes of a patch's quadtree in depth-first order: each node before its four parts, in the order of the corners.
class Stream {
 public:
  Stream() = default;
  virtual ~Stream() = default;
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  /// The next node; empty after the last node.
  virtual std::optional<Node> next() = 0;
};

}  // namespace csgsim::swept
