#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "host/facet/geometry.h"
#include "host/read/read.h"
#include "host/view/projection.h"
#include "hw/base/messages.h"
#include "hw/base/seconds.h"
#include "hw/isa/depth_scale.h"
#include "sim/software/coherences/sequences.h"
#include "sim/software/methods/counts.h"
#include "sim/software/space/directory.h"
#include "sim/software/tracing/trace.h"
#include "sim/software/tree/tree.h"

/// Compares Embree, with single-precision rays, with the directories of csgsim: the same facets, the primary rays of a
/// picture in perspective, on one thread (docs/software.md).
namespace csgsim::bench {

namespace {

using software::Event;
using software::TraceScene;

constexpr std::uint32_t side = 512;

/// A facet hit by a ray, and the distance along the view axis.
struct Hit {
  float distance;
  std::uint32_t facet;
};

/// A ray with a collection of all its hits.
struct Gathering {
  RTCIntersectContext context;  ///< must be the first member: Embree passes a pointer to it
  std::span<const std::uint32_t> facets;
  std::vector<Hit> hits;
};

void gather(const RTCFilterFunctionNArguments* arguments) {
  auto* const gathering = reinterpret_cast<Gathering*>(arguments->context);
  gathering->hits.push_back({RTCRayN_tfar(arguments->ray, arguments->N, 0),
                             gathering->facets[RTCHitN_primID(arguments->hit, arguments->N, 0)]});
  *arguments->valid = 0;
}

/// The facets of a scene as Embree triangles.
class EmbreeScene {
 public:
  explicit EmbreeScene(const TraceScene& traced)
      : device_(rtcNewDevice("threads=1"), rtcReleaseDevice), scene_(rtcNewScene(device_.get()), rtcReleaseScene) {
    const software::Facets& facets = traced.facets();
    for (std::uint32_t facet = 0; facet < facets.facets.size(); ++facet) {
      for (std::size_t i = 2; i < facets.corners_of(facet).size(); ++i) facets_.push_back(facet);
    }
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
    rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_HIGH);
    const RTCGeometry triangles = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* corners = static_cast<float*>(rtcSetNewGeometryBuffer(triangles, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                3 * sizeof(float), facets.corners.size()));
    for (const glm::dvec3& corner : facets.corners) {
      for (int axis = 0; axis < 3; ++axis) *corners++ = static_cast<float>(corner[axis]);
    }
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        triangles, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), facets_.size()));
    for (const software::Facet& facet : facets.facets) {
      for (std::size_t i = facet.begin + 2; i < facet.end; ++i) {
        for (const std::size_t corner : {facet.begin, i - 1, i}) *indices++ = static_cast<std::uint32_t>(corner);
      }
    }
    rtcCommitGeometry(triangles);
    rtcAttachGeometry(scene_.get(), triangles);
    rtcReleaseGeometry(triangles);
    rtcCommitScene(scene_.get());
  }

  /// Finds the nearest facet; false if there is none.
  bool meets(RTCRayHit& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_.get(), &context, &ray);
    return ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  }

  /// Collects all facets, the nearest first.
  void gather_all(RTCRayHit& ray, std::vector<Hit>& hits) const {
    Gathering gathering{{}, facets_, std::move(hits)};
    gathering.hits.clear();
    rtcInitIntersectContext(&gathering.context);
    gathering.context.filter = gather;
    rtcIntersect1(scene_.get(), &gathering.context, &ray);
    hits = std::move(gathering.hits);
    std::ranges::sort(hits, {}, &Hit::distance);
  }

 private:
  std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)> device_;
  std::unique_ptr<RTCSceneTy, decltype(&rtcReleaseScene)> scene_;
  std::vector<std::uint32_t> facets_;  ///< facet of each triangle
};

RTCRayHit ray_of(const TraceScene& scene, std::size_t pixel) {
  const software::SpaceRay ray =
      scene.ray_of(static_cast<std::int32_t>(pixel % side), static_cast<std::int32_t>(pixel / side));
  RTCRayHit made{};
  made.ray.org_x = static_cast<float>(ray.origin.x);
  made.ray.org_y = static_cast<float>(ray.origin.y);
  made.ray.org_z = static_cast<float>(ray.origin.z);
  made.ray.dir_x = static_cast<float>(ray.direction.x);
  made.ray.dir_y = static_cast<float>(ray.direction.y);
  made.ray.dir_z = static_cast<float>(ray.direction.z);
  made.ray.tnear = static_cast<float>(ray.begin);
  made.ray.tfar = std::numeric_limits<float>::infinity();
  made.ray.mask = ~0U;
  made.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  made.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return made;
}

/// Finds the visible surface from Embree's hits with csgsim's classification.
class Classifier {
 public:
  explicit Classifier(const TraceScene& scene) : scene_(scene), sequences_(scene.tree(), uncounted_) {}

  software::VisibleSurface seen(std::span<const Hit> hits, const RTCRay& ray) {
    const view::View& view = scene_.view();
    const glm::dvec3 direction{ray.dir_x, ray.dir_y, ray.dir_z};
    events_.clear();
    for (const Hit& hit : hits) {
      const software::Facet& facet = scene_.facets().facets[hit.facet];
      const facet::Plane& plane = scene_.geometry().planes.planes()[facet.halfspace.plane];
      const bool leaves = (glm::dot(plane.normal, direction) > 0) == facet.halfspace.positive;
      const double depth = std::floor(isa::depth_of(view.depth, view.sampling.z_bits, double{hit.distance}));
      events_.push_back({static_cast<std::uint32_t>(std::clamp(depth, 0.0, scene_.screen().farthest - 1.0)),
                         2 * facet.primitive + (leaves ? 1 : 0)});
    }
    return sequences_.along(events_, scene_.screen().farthest, uncounted_);
  }

 private:
  const TraceScene& scene_;
  software::UncountedMethod uncounted_;
  software::Sequences<software::UncountedMethod> sequences_;
  std::vector<Event> events_;
};

/// The least of three times, as for the directories.
double seconds_of(const std::function<void()>& draw) {
  double least = std::numeric_limits<double>::infinity();
  for (unsigned i = 0; i < 3; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    draw();
    least = std::min(least, seconds_since(begin));
  }
  return least;
}

void compare(const std::string& name, const view::Camera& camera) {
  const model::Tree tree = read::read_csg_file(name);
  const facet::Geometry geometry = facet::make_geometry(tree);
  const view::View view = view::make_view(geometry, tree, camera, {});
  const software::Tree balanced = software::make_tree(tree, software::Shape::balanced);
  const TraceScene scene(tree, geometry, view, balanced);
  const EmbreeScene embree(scene);
  std::vector<RTCRayHit> rays;
  for (std::size_t pixel = 0; pixel < std::size_t{side} * side; ++pixel) rays.push_back(ray_of(scene, pixel));
  std::uint64_t met = 0;
  const double first = seconds_of([&] {
    met = 0;
    for (RTCRayHit ray : rays) met += embree.meets(ray) ? 1U : 0U;
  });
  std::vector<Hit> hits;
  std::uint64_t all_hits = 0;
  const double all = seconds_of([&] {
    all_hits = 0;
    for (RTCRayHit ray : rays) {
      embree.gather_all(ray, hits);
      all_hits += hits.size();
    }
  });
  const auto bvh = software::directory_of("bvh").make(scene.shapes(), {});
  const software::Traced traced = software::trace(scene, *bvh, {}, false);
  Classifier classifier(scene);
  std::uint64_t owners = 0;
  std::uint64_t depths = 0;
  for (std::size_t pixel = 0; pixel < rays.size(); ++pixel) {
    RTCRayHit ray = rays[pixel];
    embree.gather_all(ray, hits);
    const software::VisibleSurface seen = classifier.seen(hits, ray.ray);
    owners += seen.owner != traced.pixels[pixel].seen.owner ? 1U : 0U;
    depths += seen.depth != traced.pixels[pixel].seen.depth ? 1U : 0U;
  }
  fmt::print("| Embree, first hit | {:.3f} | {} rays meet facets |\n", first, met);
  fmt::print(
      "| Embree, all hits in order | {:.3f} | {} hits; classified, {} pixels have another owner, {} another depth |\n",
      all, all_hits, owners, depths);
  for (const char* const directory : {"bvh", "kd-tree", "excell"}) {
    const auto space = software::directory_of(directory).make(scene.shapes(), {});
    fmt::print("| `{}`, classified | {:.3f} | exact |\n", directory,
               software::measure_trace_seconds(scene, *space, {}));
  }
}

}  // namespace

}  // namespace csgsim::bench

/// Arguments: MODEL and a camera, as eye and centre.
int main(int argc, char** argv) {
  constexpr int words = 8;
  if (argc != words) {
    csgsim::report_line("usage: csgsim_embree MODEL.csg EX EY EZ CX CY CZ");
    return 2;
  }
  try {
    const auto number = [&](int word) { return std::strtod(argv[word], nullptr); };
    csgsim::bench::compare(
        argv[1],
        {{number(2), number(3), number(4)}, {number(5), number(6), number(7)}, csgsim::view::Projection::perspective});
    return 0;
  } catch (const std::exception& error) {
    csgsim::report_line(error.what());
    return 1;
  }
}
