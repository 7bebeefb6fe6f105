// Ray tracing of a model through a directory of its facets.
// Used by sim/studies.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "sim/software/draw.h"
#include "sim/software/tracing/counts.h"
#include "sim/software/tracing/trace_scene.h"

namespace csgsim::software {

/// A light for shadow rays: a position, or a direction towards the light; in model space relative to
/// PlaneTable::centre().
struct TraceLight {
  bool is_point = false;
  glm::dvec3 where{0};
};

/// How the test of primary rays against a facet is counted. The picture does not depend on it.
enum class FacetTest : std::uint8_t {
  space,      ///< as a test against a polygon in space, as for secondary rays
  projected,  ///< as a test in the picture after transforming all facets: rectangle first, then edges
};

/// How the facets that primary rays hit are found: by casting the rays, or by drawing facets.
enum class ItemPass : std::uint8_t {
  none,
  depth_lists,    ///< scan-converts all facets and classifies the sorted events of each row
  list_priority,  ///< as depth_lists, but counted at the cost given by TraceOptions::list_priority
};

/// Cost of drawing the picture by list priority, which fills the item buffer.
struct PriorityPass {
  Operations operations;
  std::uint64_t events = 0;  ///< events drawn at pixels
  std::uint64_t words = 0;   ///< 32-bit words, without the items
};

/// Selects the rays to cast and how their facets are found.
struct TraceOptions {
  ItemPass item_pass = ItemPass::none;
  PriorityPass list_priority{};
  FacetTest facet_test = FacetTest::space;
  bool has_mailboxes = true;
  bool has_shadows = false;
  unsigned mirror_depth = 0;            ///< maximum number of successive reflections
  std::vector<TraceLight> lights{};     ///< at most 32
  std::vector<std::uint8_t> mirrors{};  ///< per facet, whether it is a mirror; indexed like Facets::facets
};

/// The visible surface at a point.
struct TracedSurface {
  std::uint32_t owner = VisibleSurface::nothing_seen;
  std::uint32_t facet = TraceScene::none;  ///< index into Facets::facets; none for a near cap or if nothing is visible
  std::uint32_t lit = 0;                   ///< bit mask of unobstructed lights in front of the facet
};

/// A pixel and its reflections, one per successive mirror.
struct TracedPixel {
  VisibleSurface seen;
  TracedSurface surface;
  std::vector<TracedSurface> mirrored;
};

struct Traced {
  std::vector<TracedPixel> pixels;  ///< row by row
  TraceCounts counts;               ///< without counting, only `words` is set
};

/// Traces a picture. Throws InputError for more than 32 lights, and if the tree fills all of space.
Traced trace(const TraceScene& scene, const Directory& directory, const TraceOptions& options, bool counts);

/// Minimum wall time of tracing the picture on this computer in seconds, over several runs without counting.
double measure_trace_seconds(const TraceScene& scene, const Directory& directory, const TraceOptions& options);

/// Owners and depths of a traced picture.
Picture picture_of(const Traced& traced);

}  // namespace csgsim::software
