#include "sim/software/tracing/trace.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "hw/base/error.h"
#include "hw/base/seconds.h"
#include "sim/software/coherences/sequences.h"
#include "sim/software/facets/transformation.h"
#include "sim/software/tracing/item_buffer.h"
#include "sim/software/tracing/primary_rays.h"
#include "sim/software/tracing/secondary_rays.h"

namespace csgsim::software {

namespace {

constexpr std::size_t max_lights = 32;

/// Traces a picture pixel by pixel.
template <class Count>
class Tracer {
 public:
  Tracer(const TraceScene& scene, const Directory& directory, const TraceOptions& options)
      : scene_(scene),
        options_(options),
        sequences_(scene.tree(), meters_.classification),
        primary_(scene, directory, options, sequences_, meters_, counts_.primary),
        secondary_(scene, directory, options.has_mailboxes, sequences_, meters_) {
    if (options.facet_test == FacetTest::projected || options.item_pass == ItemPass::depth_lists) {
      count_transformation(scene.facets().corners.size(), scene.screen().facets.size(), scene.screen().linears.size(),
                           meters_.projection);
    }
    const bool is_of_lists = options.item_pass == ItemPass::depth_lists;
    if (options.item_pass != ItemPass::none)
      items_.emplace(scene, sequences_, is_of_lists ? meters_ : uncharged_, counts_.items);
  }

  void trace(std::vector<TracedPixel>& pixels) {
    std::vector<Hit> row_of_items;
    std::size_t pixel = 0;
    for (std::uint32_t row = 0; row < scene_.height(); ++row) {
      if (items_) items_->fill(row, row_of_items);
      for (std::uint32_t column = 0; column < scene_.width(); ++column, ++pixel) {
        const auto x = static_cast<std::int32_t>(column);
        const auto y = static_cast<std::int32_t>(row);
        const Hit hit = items_ ? looked_up(row_of_items[column]) : primary_.trace(x, y);
        shade(hit, x, y, pixels[pixel]);
      }
    }
  }

  [[nodiscard]] TraceCounts counts() const {
    TraceCounts counts = counts_;
    counts.classification = meters_.classification.counts_so_far();
    counts.projection = meters_.projection.done();
    if (options_.item_pass == ItemPass::list_priority) count_list_priority(counts);
    counts.traversal = meters_.traversal.done();
    counts.intersection = meters_.intersection.done();
    counts.shading = meters_.shading.done();
    const std::uint64_t mailboxes = options_.has_mailboxes ? scene_.facets().facets.size() : 0;
    counts.words += sequences_.words() + mailboxes + (items_ ? items_->words() : 0);
    return counts;
  }

 private:
  /// Charges the list priority pass, plus a pointer to the polygon for each pixel that it sets.
  void count_list_priority(TraceCounts& counts) const {
    Count pointers;
    pointers(Operation::store_long, counts.primary.hits);
    counts.projection += options_.list_priority.operations;
    counts.projection += pointers.done();
    counts.items = options_.list_priority.events;
    counts.words = options_.list_priority.words;
  }

  /// Tests the ray against the facet in the item buffer only.
  Hit looked_up(const Hit& hit) {
    RaysMet& met = counts_.primary;
    ++met.rays;
    met.add_cells(0);
    meters_.intersection(Operation::load_long);
    meters_.intersection(Operation::compare_long);
    meters_.intersection(Operation::branch);
    if (hit.seen.owner == VisibleSurface::nothing_seen) return hit;
    ++met.hits;
    ++met.tested;
    ++met.met;
    if (options_.facet_test == FacetTest::space) {
      count_distance(meters_.intersection);
      return hit;
    }
    const std::uint64_t longs = longs_of(scene_.view().sampling);
    meters_.intersection(Operation::load_long, 3 * longs);
    meters_.intersection(Operation::multiply, 4 * longs);
    meters_.intersection(Operation::add_long, 4 * longs);
    return hit;
  }

  void shade(const Hit& hit, std::int32_t column, std::int32_t row, TracedPixel& pixel) {
    pixel.seen = hit.seen;
    pixel.mirrored.clear();
    pixel.surface = {};
    // The facet's precomputed colour is read, and written to the pixel.
    meters_.shading(Operation::load_long, 2);
    meters_.shading(Operation::store_long);
    meters_.shading(Operation::branch_taken);
    if (hit.facet == TraceScene::none) {
      pixel.surface.owner = hit.seen.owner;
      return;
    }
    const std::uint32_t facet = scene_.screen().facets[hit.facet].facet;
    pixel.surface = {hit.seen.owner, facet, 0};
    if (facet == ScreenFacet::near_cap || !has_secondary()) {
      if (facet == ScreenFacet::near_cap) pixel.surface.facet = TraceScene::none;
      return;
    }
    const SpaceRay ray = scene_.ray_of(column, row);
    follow(ray, {at_plane(ray, facet), facet, hit.before}, pixel);
  }

  [[nodiscard]] bool has_secondary() const { return options_.has_shadows || options_.mirror_depth > 0; }

  /// The point at which a ray intersects the plane of a facet.
  glm::dvec3 at_plane(const SpaceRay& ray, std::uint32_t facet) {
    const facet::Plane& plane = plane_of(facet);
    count_products(meters_.shading, 9);
    count_quotients(meters_.shading, 1);
    return ray.at(-plane.height(ray.origin) / glm::dot(plane.normal, ray.direction));
  }

  [[nodiscard]] const facet::Plane& plane_of(std::uint32_t facet) const {
    return scene_.geometry().planes.planes()[scene_.facets().facets[facet].halfspace.plane];
  }

  /// Computes the lights at the surface that a ray hit, and its reflections.
  void follow(SpaceRay ray, Start start, TracedPixel& pixel) {
    pixel.surface.lit = light_at(start, ray.direction);
    for (unsigned depth = 0; depth < options_.mirror_depth; ++depth) {
      if (options_.mirrors[start.facet] == 0) return;
      const glm::dvec3& normal = plane_of(start.facet).normal;
      const glm::dvec3 direction = ray.direction - normal * (2 * glm::dot(normal, ray.direction));
      count_products(meters_.shading, 6);
      const RealHit hit =
          secondary_.trace(start, direction, std::numeric_limits<double>::infinity(), false, counts_.mirror);
      TracedSurface& mirrored = pixel.mirrored.emplace_back();
      mix();
      if (hit.facet == TraceScene::none) return;
      mirrored = {hit.owner, hit.facet, 0};
      ray = {start.place, direction, 0, 0};
      start = {ray.at(hit.t), hit.facet, hit.before};
      count_products(meters_.shading, 3);
      mirrored.lit = light_at(start, direction);
    }
  }

  /// Bit mask of the lights that reach a surface on the side that is seen in the given direction.
  std::uint32_t light_at(const Start& start, const glm::dvec3& seen_along) {
    if (!options_.has_shadows) return 0;
    std::uint32_t lit = 0;
    const glm::dvec3& normal = plane_of(start.facet).normal;
    const double seen = glm::dot(normal, seen_along);
    for (std::size_t i = 0; i < options_.lights.size(); ++i) {
      const TraceLight& light = options_.lights[i];
      const glm::dvec3 to_light = light.is_point ? light.where - start.place : light.where;
      count_products(meters_.shading, 3);
      count_comparisons(meters_.shading, 1);
      if (!(glm::dot(normal, to_light) * seen < 0)) continue;
      const double end = light.is_point ? 1.0 : std::numeric_limits<double>::infinity();
      if (!secondary_.trace(start, to_light, end, true, counts_.shadow).is_in_solid()) lit |= 1U << i;
      mix();
    }
    return lit;
  }

  /// Blends a colour of three channels with another.
  void mix() {
    meters_.shading(Operation::load, 6);
    meters_.shading(Operation::multiply, 3);
    meters_.shading(Operation::add, 3);
    meters_.shading(Operation::store, 3);
  }

  const TraceScene& scene_;
  const TraceOptions& options_;
  TraceMeters<Count> meters_;
  TraceMeters<Count> uncharged_;  ///< counters of an item buffer that is charged at another pass's price
  TraceCounts counts_;
  Sequences<Count> sequences_;
  PrimaryRays<Count> primary_;
  SecondaryRays<Count> secondary_;
  std::optional<ItemBuffer<Count>> items_;
};

template <class Count>
TraceCounts trace_with(const TraceScene& scene, const Directory& directory, const TraceOptions& options,
                       std::vector<TracedPixel>& pixels) {
  Tracer<Count> tracer(scene, directory, options);
  tracer.trace(pixels);
  return tracer.counts();
}

std::vector<TracedPixel> blank(const TraceScene& scene) {
  TracedPixel nothing;
  nothing.seen.depth = scene.screen().farthest;
  return std::vector<TracedPixel>(std::size_t{scene.width()} * scene.height(), nothing);
}

void refuse(const TraceOptions& options) {
  if (options.lights.size() > max_lights)
    throw InputError("the scene has " + std::to_string(options.lights.size()) +
                     " lights, but at most 32 are supported; remove some lights");
}

}  // namespace

Traced trace(const TraceScene& scene, const Directory& directory, const TraceOptions& options, bool counts) {
  refuse(options);
  Traced traced{blank(scene), {}};
  if (scene.tree().is_constant()) return traced;
  traced.counts = counts ? trace_with<CountingMethod>(scene, directory, options, traced.pixels)
                         : trace_with<UncountedMethod>(scene, directory, options, traced.pixels);
  return traced;
}

double measure_trace_seconds(const TraceScene& scene, const Directory& directory, const TraceOptions& options) {
  refuse(options);
  constexpr unsigned max_runs = 3;
  constexpr double enough = 0.2;
  std::vector<TracedPixel> pixels = blank(scene);
  double min_seconds = std::numeric_limits<double>::infinity();
  double spent = 0;
  if (scene.tree().is_constant()) return 0;
  for (unsigned i = 0; i < max_runs && spent < enough; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    trace_with<UncountedMethod>(scene, directory, options, pixels);
    const double seconds = seconds_since(begin);
    min_seconds = std::min(min_seconds, seconds);
    spent += seconds;
  }
  return min_seconds;
}

Picture picture_of(const Traced& traced) {
  Picture picture;
  picture.seen.reserve(traced.pixels.size());
  for (const TracedPixel& pixel : traced.pixels) picture.seen.push_back(pixel.seen);
  return picture;
}

}  // namespace csgsim::software
