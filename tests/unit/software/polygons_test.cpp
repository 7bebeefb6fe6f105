#include "sim/software/display/polygons.h"

#include <glm/vec3.hpp>

#include "sim/software/display/screen_pieces.h"
#include "sim/software/methods/counts.h"
#include "sim/software/space/directory.h"
#include "tests/support/test.h"
#include "tests/unit/software/random_scenes.h"
#include "tests/unit/software/shown.h"

using namespace csgsim;
using testing::Scene;
using testing::Shown;

namespace {

/// Events of pieces at each pixel, from the bounds of the pieces alone.
std::vector<std::vector<software::Event>> events_of_pieces(const software::ScreenFacets& pieces, std::uint32_t width,
                                                           std::uint32_t height) {
  std::vector<std::vector<software::Event>> events(std::size_t{width} * height);
  for (const software::ScreenFacet& piece : pieces.facets) {
    for (std::int32_t y = 0; y < static_cast<std::int32_t>(height); ++y) {
      for (std::int32_t x = 0; x < static_cast<std::int32_t>(width); ++x) {
        const std::optional<software::Event> event = pieces.event_at(piece, x, y);
        if (event) events[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)].push_back(*event);
      }
    }
  }
  for (std::vector<software::Event>& one : events) std::sort(one.begin(), one.end());
  return events;
}

std::vector<std::uint32_t> all_cells(const software::Polygons& polygons) {
  std::vector<std::uint32_t> cells(polygons.cells.size());
  std::iota(cells.begin(), cells.end(), 0U);
  return cells;
}

software::Polygons polygons_of(const Shown& shown, std::size_t bucket_size) {
  software::UncountedMethod uncounted;
  return software::clipped(shown.facets, shown.scene.geometry,
                           {software::directory_of("excell"), static_cast<std::uint32_t>(bucket_size)}, uncounted);
}

/// Whether a segment passes through a convex polygon with a margin: the minimum of its ends' heights over the plane and
/// of the point's distances from the edges exceeds `margin`.
bool pierces(const glm::dvec3& from, const glm::dvec3& to, std::span<const glm::dvec3> corners, double margin) {
  glm::dvec3 normal{0};
  for (std::size_t i = 0; i < corners.size(); ++i)
    normal += glm::cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
  normal = glm::normalize(normal);
  const double at_from = glm::dot(normal, from - corners[0]);
  const double at_to = glm::dot(normal, to - corners[0]);
  if (std::min(at_from, at_to) > -margin || std::max(at_from, at_to) < margin) return false;
  const glm::dvec3 point = from + (to - from) * (at_from / (at_from - at_to));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 edge = corners[(i + 1) % corners.size()] - corners[i];
    if (glm::length(edge) < margin) continue;
    if (glm::dot(glm::cross(normal, glm::normalize(edge)), point - corners[i]) < margin) return false;
  }
  return true;
}

bool pierce(const software::Piece& one, const software::Piece& other, double margin) {
  for (std::size_t i = 0; i < one.corners.size(); ++i) {
    if (pierces(one.corners[i], one.corners[(i + 1) % one.corners.size()], other.corners, margin)) return true;
  }
  return false;
}

/// Counts pairs of intersecting pieces of different primitives.
std::uint64_t crossings(const Shown& shown, const software::Polygons& polygons, double margin) {
  std::vector<const software::Piece*> pieces;
  for (const software::PolygonCell& cell : polygons.cells) {
    for (const software::Piece& piece : cell.bucket) {
      if (piece.corners.size() >= 3) pieces.push_back(&piece);
    }
  }
  std::uint64_t count = 0;
  for (const software::Piece* const one : pieces) {
    for (const software::Piece* const other : pieces) {
      const bool are_apart = shown.facets.facets[one->facet].primitive == shown.facets.facets[other->facet].primitive;
      if (!are_apart && pierce(*one, *other, margin)) ++count;
    }
  }
  return count;
}

double area(std::span<const glm::dvec3> corners) {
  glm::dvec3 sum{0};
  for (std::size_t i = 2; i < corners.size(); ++i)
    sum += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  return glm::length(sum) / 2.0;
}

}  // namespace

TEST_CASE("each pixel of a facet is in one of the facet's pieces at any bucket size") {
  std::uint64_t scenes = 0;
  std::uint64_t cuts = 0;
  const auto enough = testing::cases<std::uint64_t>(60, 12);
  for (std::uint64_t seed = 1; scenes < enough; ++seed) {
    const std::optional<Scene> scene = testing::random_scene(seed);
    if (!scene || !testing::is_faceted(*scene)) continue;
    CAPTURE(seed);
    const Shown shown(*scene);
    const software::ScreenFacets seen =
        software::screen_facets(scene->tree, scene->geometry, scene->view, shown.facets);
    software::ScreenFacets caps = seen;
    std::erase_if(caps.facets,
                  [](const software::ScreenFacet& one) { return one.facet != software::ScreenFacet::near_cap; });
    const software::Polygons polygons = polygons_of(shown, 1 + seed % 20);
    const software::ScreenPieces pieces =
        software::screen_pieces(polygons, all_cells(polygons), seen, scene->geometry, scene->view);
    // Only pieces with pixels have bounds.
    std::size_t linears = 0;
    for (const software::ScreenFacet& piece : pieces.pieces.facets) {
      CHECK(piece.bounds == linears);
      linears = piece.end;
    }
    CHECK(linears == pieces.pieces.linears.size());
    cuts += pieces.pieces.facets.size() - (seen.facets.size() - caps.facets.size());
    const view::Sampling& sampling = scene->view.sampling;
    std::vector<std::vector<software::Event>> events = events_of_pieces(pieces.pieces, sampling.width, sampling.height);
    const auto of_caps = events_of_pieces(caps, sampling.width, sampling.height);
    for (std::size_t i = 0; i < events.size(); ++i) {
      events[i].insert(events[i].end(), of_caps[i].begin(), of_caps[i].end());
      std::sort(events[i].begin(), events[i].end());
    }
    CHECK((events == events_of_pieces(seen, sampling.width, sampling.height)));
    ++scenes;
  }
  CHECK((!testing::draws_usual_cases() || cuts > 1000));
}
TEST_CASE("pieces of different primitives do not cross and keep their facet's area") {
  std::uint64_t scenes = 0;
  std::uint64_t before = 0;
  const auto enough = testing::cases<std::uint64_t>(24, 6);
  for (std::uint64_t seed = 1; scenes < enough; ++seed) {
    const std::optional<Scene> scene = testing::random_scene(seed);
    if (!scene || !testing::is_faceted(*scene)) continue;
    const Shown shown(*scene);
    if (shown.facets.facets.size() > 60) continue;
    CAPTURE(seed);
    const software::Polygons polygons = polygons_of(shown, 12);
    const double margin = 1e-6 * scene->geometry.planes.diagonal();
    CHECK(crossings(shown, polygons, margin) == 0);
    software::Polygons whole;
    software::PolygonCell cell;
    for (std::uint32_t facet = 0; facet < shown.facets.facets.size(); ++facet) {
      const auto corners = shown.facets.corners_of(facet);
      cell.bucket.push_back({facet, {corners.begin(), corners.end()}, {}, {}});
    }
    whole.cells.push_back(cell);
    before += crossings(shown, whole, margin);
    std::vector<double> areas(shown.facets.facets.size());
    for (const software::PolygonCell& one : polygons.cells) {
      for (const software::Piece& piece : one.bucket) areas[piece.facet] += area(piece.corners);
    }
    for (std::uint32_t facet = 0; facet < areas.size(); ++facet) {
      const double expected = area(shown.facets.corners_of(facet));
      CHECK(areas[facet] == doctest::Approx(expected).epsilon(1e-6).scale(margin));
    }
    ++scenes;
  }
  CHECK(before > 50);
}
