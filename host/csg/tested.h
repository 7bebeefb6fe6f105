// Half-spaces that have been tested against rectangles.
// Used by counted.h.
#pragma once

#include <cstdint>
#include <unordered_set>

#include "host/view/fixed_point.h"

namespace csgsim::csg {

/// The planes and rectangles whose extremes the host keeps while it compiles a segment, so that it tests none twice.
class Tested {
 public:
  /// Returns whether the plane has not been tested over the rectangle before.
  bool add(const view::FixedLinear& plane, const view::PixelRect& pixels) {
    return places_.insert({plane.a, plane.b, plane.c, pixels}).second;
  }

  /// Adds everything that `others` has.
  void add(const Tested& others) { places_.insert(others.places_.begin(), others.places_.end()); }

 private:
  struct Place {
    std::int64_t a;
    std::int64_t b;
    std::int64_t c;
    view::PixelRect pixels;

    bool operator==(const Place&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Place& place) const {
      constexpr std::uint64_t odd = 0x9e3779b97f4a7c15;
      std::uint64_t hash = 0;
      const auto mix = [&](std::int64_t number) {
        hash = (hash ^ static_cast<std::uint64_t>(number)) * odd;
        hash ^= hash >> 29U;
      };
      for (const std::int64_t number : {place.a, place.b, place.c}) mix(number);
      for (const std::int32_t number : {place.pixels.x0, place.pixels.y0, place.pixels.x1, place.pixels.y1})
        mix(number);
      return hash;
    }
  };

  std::unordered_set<Place, Hash> places_;
};

}  // namespace csgsim::csg
