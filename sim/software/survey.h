#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_set>
#include <vector>

#include "sim/software/rays/ray_band.h"

namespace csgsim::software {

/// Rays as the thesis counts them (table 4.9). A sequence is the primitives that a ray meets until it gets into the
/// solid, or all of them if it never does, in order.
struct Survey {
  std::uint64_t rays = 0;
  std::uint64_t met = 0;        ///< with an event at least: rays with points
  std::uint64_t hits = 0;       ///< that get into the solid
  std::uint64_t points = 0;     ///< events at one depth are one, until a ray gets into the solid
  std::uint64_t sequences = 0;  ///< rays whose sequence is not that of the last ray that met something
  std::uint64_t different_sequences = 0;
  std::uint64_t combinations = 0;  ///< of primitives, in whatever order and however often rays meet them
  std::uint64_t most_points = 0;   ///< of a ray
};

/// Goes through rays in the order of pixels.
class Surveyor {
 public:
  void add(const RayBand& band, std::span<const Seen> seen);
  [[nodiscard]] Survey result() const;

 private:
  struct Hash {
    std::size_t operator()(const std::vector<std::uint32_t>& sequence) const;
  };

  void add_ray(std::span<const Event> events, const Seen& seen);

  Survey survey_;
  std::vector<std::uint32_t> last_;
  std::vector<std::uint32_t> sequence_;
  std::unordered_set<std::vector<std::uint32_t>, Hash> found_;
  std::unordered_set<std::vector<std::uint32_t>, Hash> combinations_;
};

}  // namespace csgsim::software
