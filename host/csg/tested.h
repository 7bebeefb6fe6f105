// Half-spaces that have been tested against rectangles.
// Used by counted.h.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <unordered_set>
#include <utility>
#include <vector>

#include "host/view/fixed_point.h"

namespace csgsim::csg {

/// How the extremes of a plane over a rectangle are found.
enum class ExtremesSource : std::uint8_t {
  by_test,   ///< at the corners
  from_row,  ///< by additions, from the extremes in the row above
  known,     ///< they have been found before
};

/// The planes and rectangles whose extremes the host keeps while it compiles a segment, so that it tests none twice.
/// They are stored as hashes of 64 bits; less than one program in 10^5 is expected to have a false match.
class Tested {
 public:
  /// Derives the extremes in a row from the row above it in the segment above. `above` must outlive this object.
  void follow(const Tested& above) { above_ = &above; }

  /// Adds a plane and a rectangle. Returns how the host finds the plane's extremes there.
  ExtremesSource add(const view::FixedLinear& plane, const view::PixelRect& pixels) {
    const std::uint64_t place = hash(plane, pixels);
    if (is_sealed(place) || !open_.insert(place).second) return ExtremesSource::known;
    const bool is_row = pixels.y0 == pixels.y1;
    const bool follows = is_row && above_ != nullptr &&
                         above_->is_sealed(hash(plane, {pixels.x0, pixels.y0 - 1, pixels.x1, pixels.y1 - 1}));
    return follows ? ExtremesSource::from_row : ExtremesSource::by_test;
  }

  /// Adds all sealed entries of `others`.
  void add(const Tested& others) {
    std::vector<std::uint64_t> all;
    std::ranges::set_union(sealed_, others.sealed_, std::back_inserter(all));
    sealed_ = std::move(all);
  }

  /// Moves all entries to compact storage. Only rows of sealed entries can be followed.
  void seal() {
    sealed_.insert(sealed_.end(), open_.begin(), open_.end());
    std::ranges::sort(sealed_);
    open_ = {};
  }

 private:
  static std::uint64_t hash(const view::FixedLinear& plane, const view::PixelRect& pixels) {
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15;
    std::uint64_t hash = 0;
    const auto mix = [&](std::int64_t number) {
      hash = (hash ^ static_cast<std::uint64_t>(number)) * odd;
      hash ^= hash >> 29U;
    };
    for (const std::int64_t number : {plane.a, plane.b, plane.c}) mix(number);
    for (const std::int32_t number : {pixels.x0, pixels.y0, pixels.x1, pixels.y1}) mix(number);
    return hash;
  }

  [[nodiscard]] bool is_sealed(std::uint64_t place) const { return std::ranges::binary_search(sealed_, place); }

  std::vector<std::uint64_t> sealed_;  ///< sorted
  std::unordered_set<std::uint64_t> open_;
  const Tested* above_ = nullptr;
};

}  // namespace csgsim::csg
