#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

namespace csgsim::swept {

/// How often a patch may be halved along a side, at most.
inline constexpr std::uint32_t deepest = 16;

/// A square of a patch's parameters, in units of 2^-deepest of its side.
struct Square {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  std::uint32_t size = std::uint32_t{1} << deepest;
};

inline constexpr std::uint32_t whole_side = Square{}.size;

/// Corners in the order of the four parts of a square: south-west, south-east, north-west, north-east.
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

/// The nodes of a patch's quadtree, one after the other: each before its four parts, and these in the order of corners.
class Stream {
 public:
  Stream() = default;
  virtual ~Stream() = default;
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  /// Nothing after the last one.
  virtual std::optional<Node> next() = 0;
};

}  // namespace csgsim::swept
