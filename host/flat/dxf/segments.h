// Segments on OpenSCAD's grid, and the outlines that they form.
// Used by dxf.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <utility>
#include <vector>

#include "host/flat/area.h"

namespace csgsim::flat::dxf {

/// Segments with ends on a grid of 1/1024, as in OpenSCAD: ends at most one step apart in both directions coincide.
class Segments {
 public:
  /// Adds a segment. Throws InputError for too many segments or coordinates that are too large.
  void add(const glm::dvec2& from, const glm::dvec2& to);

  /// The grid point of a segment end; later ends near it snap to the same point.
  glm::dvec2 snap(const glm::dvec2& point);

  /// The outlines that the segments form; each segment is used once. Open chains come first, then closed chains.
  [[nodiscard]] std::vector<Outline> outlines() const;

 private:
  std::uint32_t vertex(const glm::dvec2& point);
  [[nodiscard]] bool is_turned(const std::vector<std::uint32_t>& chain) const;

  std::map<std::pair<std::int64_t, std::int64_t>, std::uint32_t> grid_;
  std::vector<glm::dvec2> vertices_;
  std::vector<std::array<std::uint32_t, 2>> segments_;
};

/// Maximum number of segments of a drawing.
inline constexpr std::size_t max_segments = 1'000'000;

}  // namespace csgsim::flat::dxf
