#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <utility>
#include <vector>

#include "host/flat/area.h"

namespace csgsim::flat::dxf {

/// Segments whose ends are at points of a grid of 1/1024, as OpenSCAD's are: ends that are a step or less apart in both
/// directions are the same.
class Segments {
 public:
  /// Throws InputError for too many segments and for coordinates that are too large.
  void add(const glm::dvec2& from, const glm::dvec2& to);

  /// The point of the grid that an end there is at; ends near it are at the same one from now on.
  glm::dvec2 snap(const glm::dvec2& point);

  /// The outlines that they make up, each segment once: first those that begin where no other segment ends, then those
  /// that come back.
  [[nodiscard]] std::vector<Outline> outlines() const;

 private:
  std::uint32_t vertex(const glm::dvec2& point);
  [[nodiscard]] bool is_turned(const std::vector<std::uint32_t>& chain) const;

  std::map<std::pair<std::int64_t, std::int64_t>, std::uint32_t> grid_;
  std::vector<glm::dvec2> vertices_;
  std::vector<std::array<std::uint32_t, 2>> segments_;
};

/// Segments of a drawing, at most.
inline constexpr std::size_t max_segments = 1'000'000;

}  // namespace csgsim::flat::dxf
