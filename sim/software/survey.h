// Statistics of the rays of a picture.
// Used by csgsim classify.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_set>
#include <vector>

#include "sim/software/rays/ray_band.h"

namespace csgsim::software {

/// Rays as the thesis counts them (table 4.9). A sequence is the ordered list of primitives that a ray intersects until
/// it enters the solid, or all of them if it never does.
struct Survey {
  std::uint64_t rays = 0;
  std::uint64_t met = 0;                  ///< rays with at least one event; the thesis's rays with points
  std::uint64_t hits = 0;                 ///< rays that enter the solid
  std::uint64_t points = 0;               ///< until a ray enters the solid; events at the same depth are one point
  std::uint64_t sequences = 0;            ///< rays whose sequence differs from that of the previous ray with events
  std::uint64_t different_sequences = 0;  ///< distinct sequences
  std::uint64_t combinations = 0;         ///< distinct sets of primitives, regardless of their order in the sequence
  std::uint64_t max_points = 0;           ///< maximum per ray
};

/// Collects statistics of rays in the order of pixels.
class Surveyor {
 public:
  void add(const RayBand& band, std::span<const VisibleSurface> seen);
  [[nodiscard]] Survey result() const;

 private:
  struct Hash {
    std::size_t operator()(const std::vector<std::uint32_t>& sequence) const;
  };

  void add_ray(std::span<const Event> events, const VisibleSurface& seen);

  Survey survey_;
  std::vector<std::uint32_t> last_;
  std::vector<std::uint32_t> sequence_;
  std::unordered_set<std::vector<std::uint32_t>, Hash> found_;
  std::unordered_set<std::vector<std::uint32_t>, Hash> combinations_;
};

}  // namespace csgsim::software
