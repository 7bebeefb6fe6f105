// Three-valued decisions whether a ray may show a surface.
// Used by the explainer and the quadric bounds.
#pragma once

#include <cstdint>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::judges {

/// Range of depth steps, inclusive.
struct Steps {
  std::int64_t low = 0;
  std::int64_t high = 0;
};

/// The truth of a statement about uncertain planes, in Kleene's order: AND is the minimum, OR the maximum.
enum class Maybe : std::uint8_t { no, unknown, yes };

constexpr Maybe opposite(Maybe value) { return static_cast<Maybe>(2 - static_cast<int>(value)); }

/// The intersection of a ray with a surface, a plane or a root of a quadric. Equal indices mean equal depths.
struct Intersection {
  std::uint32_t plane = 0;
  Steps steps;
};

/// An edge-on plane that may be on either side of the ray, or a quadric that the ray may meet or miss.
struct EdgeUse {
  std::uint32_t plane = 0;  ///< for a quadric, the index of its nearer root
  bool positive = true;     ///< the primitive uses the positive half-space, or the rays that meet the quadric
};

/// A primitive that may be on a ray.
struct Candidate {
  std::uint32_t primitive = 0;
  std::vector<EdgeUse> edges;  ///< the undecided edges; the primitive is inside the decided ones
  std::vector<Intersection> fronts;
  std::vector<Intersection> backs;
  bool is_doubtful = false;  ///< some planes may be edges or surfaces, so any result is allowed
};

/// Everything that may be on one ray, primitives in tree order.
struct Ray {
  std::vector<Candidate> candidates;
  std::vector<std::uint32_t> undecided_edges;  ///< indices of planes, each once
};

/// Whether planes within their bounds can show `owner` (or `nothing`) at that depth step.
bool can_show(const model::Tree& tree, const Ray& ray, std::uint32_t owner, std::int64_t depth);

}  // namespace csgsim::judges
