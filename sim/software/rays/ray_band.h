// Intersections of the rays of a band.
// Used by the ray caster and by all classification methods.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace csgsim::software {

/// The interval front <= z < back, in depth steps, in which a ray is inside a primitive.
struct Interval {
  std::uint32_t primitive = 0;
  std::uint32_t front = 0;
  std::uint32_t back = 0;

  bool operator==(const Interval&) const = default;
};

/// A ray enters or leaves a primitive. Events are ordered by depth, then by primitive.
struct Event {
  std::uint32_t depth = 0;     ///< in depth steps; the first depth behind the surface
  std::uint32_t crossing = 0;  ///< twice the primitive, plus 1 if the ray leaves it

  [[nodiscard]] std::uint32_t primitive() const { return crossing / 2; }
  [[nodiscard]] bool leaves() const { return crossing % 2 != 0; }
  bool operator==(const Event&) const = default;
  bool operator<(const Event& other) const {
    return depth != other.depth ? depth < other.depth : crossing < other.crossing;
  }
};

/// The rays of some rows of a picture, row by row from the top, with their intersections between the near plane and
/// depth 2^n - 1, at which nothing is visible.
struct RayBand {
  std::uint32_t width = 0;
  std::uint32_t first_row = 0;
  std::uint32_t rows = 0;
  std::vector<std::size_t> interval_begins;  ///< start index of each ray, and the end of the last ray
  std::vector<Interval> intervals;           ///< per ray in the order of primitives, none empty
  std::vector<std::size_t> event_begins;     ///< indexed like interval_begins
  std::vector<Event> events;                 ///< sorted per ray

  [[nodiscard]] std::size_t rays() const { return std::size_t{width} * rows; }
  [[nodiscard]] std::span<const Interval> intervals_of(std::size_t ray) const {
    return std::span(intervals).subspan(interval_begins[ray], interval_begins[ray + 1] - interval_begins[ray]);
  }
  [[nodiscard]] std::span<const Event> events_of(std::size_t ray) const {
    return std::span(events).subspan(event_begins[ray], event_begins[ray + 1] - event_begins[ray]);
  }
};

/// The visible surface at a pixel.
struct VisibleSurface {
  std::uint32_t depth = 0;  ///< in depth steps; 2^n - 1 if nothing is visible
  std::uint32_t owner = nothing_seen;

  static constexpr std::uint32_t nothing_seen = 0xffffffffU;
  bool operator==(const VisibleSurface&) const = default;
};

}  // namespace csgsim::software
