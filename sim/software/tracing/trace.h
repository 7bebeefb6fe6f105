#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "sim/software/draw.h"
#include "sim/software/tracing/counts.h"
#include "sim/software/tracing/trace_scene.h"

namespace csgsim::software {

/// A light as rays have it: a place, or a direction to it; model space, relative to PlaneTable::centre().
struct TraceLight {
  bool is_point = false;
  glm::dvec3 where{0};
};

/// How primary rays are held against a facet. Either way the picture is that of the integers.
enum class FacetTest : std::uint8_t {
  space,      ///< counted as a polygon in space is tested, which is how secondary rays are
  projected,  ///< counted in the picture, into which all facets are transformed: a rectangle first, then its edges
};

/// What takes the place of primary rays.
enum class ItemPass : std::uint8_t {
  none,
  depth_lists,    ///< all facets are scan-converted, the events of a row sorted and classified
  list_priority,  ///< the same items, at the price of TraceOptions::list_priority
};

/// A pass of the list priority algorithm over the same picture.
struct PriorityPass {
  Operations operations;
  std::uint64_t events = 0;  ///< drawn at pixels
  std::uint64_t words = 0;   ///< of 32 bits, without the items
};

/// Which rays are cast.
struct TraceOptions {
  ItemPass item_pass = ItemPass::none;
  PriorityPass list_priority{};
  FacetTest facet_test = FacetTest::space;
  bool has_mailboxes = true;
  bool has_shadows = false;
  unsigned mirror_depth = 0;            ///< mirrors that are seen in one another
  std::vector<TraceLight> lights{};     ///< at most 32
  std::vector<std::uint8_t> mirrors{};  ///< of each facet whether it mirrors, index into Facets::facets
};

/// What is seen at a place of a surface.
struct TracedSurface {
  std::uint32_t owner = Seen::nothing_seen;
  std::uint32_t facet = TraceScene::none;  ///< index into Facets::facets; none of a near cap, and where nothing is seen
  std::uint32_t lit = 0;                   ///< bits of lights in front of the facet that nothing hides
};

/// A pixel, and what it mirrors: the surfaces in mirrors, one in another.
struct TracedPixel {
  Seen seen;
  TracedSurface surface;
  std::vector<TracedSurface> mirrored;
};

struct Traced {
  std::vector<TracedPixel> pixels;  ///< row by row
  TraceCounts counts;               ///< words alone, unless it was to count
};

/// Traces a picture. Keeps nothing. Throws InputError for more than 32 lights, and for a tree that holds all of space.
Traced trace(const TraceScene& scene, const Directory& directory, const TraceOptions& options, bool counts);

/// Wall time of that on this computer, seconds: the least of some times, without counting.
double traced_seconds(const TraceScene& scene, const Directory& directory, const TraceOptions& options);

/// Owners and depths of it.
Picture picture_of(const Traced& traced);

}  // namespace csgsim::software
