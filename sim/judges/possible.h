#pragma once

#include <cstdint>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::judges {

/// The least and greatest depth step that something may have.
struct Steps {
  std::int64_t low = 0;
  std::int64_t high = 0;
};

/// Truth of a statement about uncertain planes, in Kleene's order: `and` is the least, `or` the greatest.
enum class Maybe : std::uint8_t { no, unknown, yes };

constexpr Maybe opposite(Maybe value) { return static_cast<Maybe>(2 - static_cast<int>(value)); }

/// A surface, of a plane or a root of a quadric, as one ray meets it. Equal indices mean equal depth, whatever it is.
struct Met {
  std::uint32_t plane = 0;
  Steps steps;
};

/// An edge-on plane that may be on either side of the ray, or a quadric that the ray may meet or miss.
struct EdgeUse {
  std::uint32_t plane = 0;  ///< of a quadric, its nearer root
  bool positive = true;     ///< the primitive uses the positive half-space, or where the quadric is met
};

/// A primitive that may be on a ray.
struct Chance {
  std::uint32_t primitive = 0;
  std::vector<EdgeUse> edges;  ///< undecided ones; the decided ones hold
  std::vector<Met> fronts;
  std::vector<Met> backs;
  bool doubtful = false;  ///< some of its planes may be edges or surfaces: it may be anything
};

/// All that may be on one ray, primitives in tree order.
struct Ray {
  std::vector<Chance> chances;
  std::vector<std::uint32_t> undecided_edges;  ///< planes, each once
};

/// Whether planes within their bounds can make a picture that shows `owner` (or `nothing`) at that depth step.
bool can_show(const model::Tree& tree, const Ray& ray, std::uint32_t owner, std::int64_t depth);

}  // namespace csgsim::judges
