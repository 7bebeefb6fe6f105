// Recounts the operations of ray tracing from the cells along each ray, the corners of facets, and ray events by
// half-spaces.

#include "sim/software/tracing/trace.h"
#include "tests/oracle/split_mix.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"
#include "tests/unit/software/random_scenes.h"
#include "tests/unit/software/recount_display.h"
#include "tests/unit/software/recount_space.h"

using namespace csgsim;
using software::Cell;
using software::Event;
using software::FacetTest;
using software::ItemPass;
using software::RaysMet;
using software::ScreenFacet;
using software::SpaceRay;
using software::TraceCounts;
using software::TraceOptions;
using software::TraceScene;
using software::VisibleSurface;
using testing::comparisons;
using testing::Operations;
using testing::products;
using testing::quotients;
using testing::Scene;
using testing::Sequence;
using testing::SequenceRecount;
using testing::steps;

namespace {

using enum processors::Operation;

constexpr double endless = std::numeric_limits<double>::infinity();

/// Tests a facet against a ray edge by edge, along the ray's dominant axis: all edges must have the ray on the same
/// side. A ray through an edge or a corner counts as slightly displaced.
class Pierced {
 public:
  Pierced(const SpaceRay& ray, std::span<const glm::dvec3> corners) {
    int along = 0;
    for (int axis = 1; axis < 3; ++axis) {
      if (std::abs(ray.direction[axis]) > std::abs(ray.direction[along])) along = axis;
    }
    const int u = (along + 1) % 3;
    const int v = (along + 2) % 3;
    const double turn = ray.direction[along] < 0 ? -1 : 1;
    const double slope_u = ray.direction[u] / ray.direction[along];
    const double slope_v = ray.direction[v] / ray.direction[along];
    const auto seen = [&](const glm::dvec3& corner) {
      const glm::dvec3 to = corner - ray.origin;
      return glm::dvec2{to[u] - slope_u * to[along], to[v] - slope_v * to[along]};
    };
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const glm::dvec2 from = seen(corners[(i + corners.size() - 1) % corners.size()]);
      const glm::dvec2 to = seen(corners[i]);
      ++edges;
      double area = turn * (from.x * to.y - from.y * to.x);
      // Displaces the ray slightly along one of the two other axes, then along the other.
      const bool is_first_u = turn > 0;
      if (area == 0) area = is_first_u ? from.y - to.y : from.x - to.x;
      if (area == 0) area = is_first_u ? to.x - from.x : to.y - from.y;
      if (area * side < 0) {
        side = 0;
        return;
      }
      if (area != 0) side = area;
    }
  }

  /// Edges tested, up to the first with the ray on another side.
  std::uint64_t edges = 0;
  double side = 0;  ///< 0 if the ray misses; positive if it leaves

  [[nodiscard]] Operations operations() const {
    return products(2) + edges * (products(4) + steps({{load_long, 3}, {add_long, 6}, branch}));
  }
};

/// Costs of a facet plane's distance along the ray, and of its range check.
Operations distance() { return products(6) + quotients(1) + comparisons(2); }

/// The facets already tested against a ray, which are skipped if the method has mailboxes.
class TestedFacets {
 public:
  TestedFacets(bool has_mailboxes, Operations& sum, RaysMet& met)
      : has_mailboxes_(has_mailboxes), sum_(sum), met_(met) {}

  bool is_due(std::uint32_t facet) {
    if (!has_mailboxes_) return true;
    sum_ += steps({{load_long, 2}, compare_long, branch});
    if (!tested_.insert(facet).second) {
      ++met_.repeats;
      return false;
    }
    sum_ += steps({store_long});
    return true;
  }

 private:
  bool has_mailboxes_;
  Operations& sum_;
  RaysMet& met_;
  std::set<std::uint32_t> tested_;
};

/// Calls `look(cell)` for each cell of a ray until it returns false.
template <class Look>
class Visitor final : public software::CellVisitor {
 public:
  explicit Visitor(const Look& look) : look_(look) {}

  bool visit(const Cell& cell) override {
    ++cells;
    is_stopped = !look_(cell);
    return !is_stopped;
  }

  std::size_t cells = 0;
  bool is_stopped = false;

 private:
  const Look& look_;
};

/// An event of a facet on the screen.
struct Met {
  Event event;
  std::uint32_t facet = 0;

  bool operator<(const Met& other) const { return event < other.event; }
};

/// A ray's entry into the solid.
struct Hit {
  VisibleSurface seen;
  std::uint32_t facet = TraceScene::none;  ///< on the screen or in the model
  Sequence before{};
  double t = endless;
};

/// Recounts a traced picture.
class TraceRecount {
 public:
  TraceRecount(const Scene& scene, const TraceScene& traced, const std::string& name, std::uint32_t bucket_size,
               const software::Directory& directory, const TraceOptions& options)
      : traced_(traced),
        directory_(directory),
        options_(options),
        rays_(scene),
        numbers_(testing::numbers_of(scene)),
        tree_(scene.tree),
        sequences_(tree_, scene.tree.primitives.size(), counts_.classification),
        walks_(name, traced.shapes(), bucket_size, directory) {}

  /// Traces the picture and checks its pixels.
  TraceCounts run(const std::vector<software::TracedPixel>& found) {
    if (options_.facet_test == FacetTest::projected || options_.item_pass == ItemPass::depth_lists) {
      counts_.projection += testing::transformed(traced_.facets().corners.size(), traced_.screen().facets.size(),
                                                 traced_.screen().linears.size());
    }
    bool are_pixels_same = true;
    std::size_t pixel = 0;
    for (std::int32_t row = 0; row < static_cast<std::int32_t>(traced_.height()); ++row) {
      std::vector<Hit> items;
      if (options_.item_pass != ItemPass::none) items = items_of(row);
      for (std::int32_t column = 0; column < static_cast<std::int32_t>(traced_.width()); ++column, ++pixel) {
        const bool has_item = options_.item_pass != ItemPass::none;
        const Hit hit = has_item ? looked_up(items[static_cast<std::size_t>(column)]) : primary(column, row);
        are_pixels_same = shade(hit, column, row, found[pixel]) && are_pixels_same;
      }
    }
    CHECK(are_pixels_same);
    finish();
    return counts_;
  }

 private:
  void finish() {
    counts_.words = sequences_.words();
    if (options_.has_mailboxes) counts_.words += traced_.facets().facets.size();
    if (options_.item_pass != ItemPass::none) counts_.words += 2 * rays_.size();
    if (options_.item_pass != ItemPass::list_priority) return;
    counts_.items = options_.list_priority.events;
    counts_.words += options_.list_priority.words;
    counts_.projection += options_.list_priority.operations;
    counts_.projection += steps({{store_long, counts_.primary.hits}});
  }

  /// Returns the event of a ray at a facet on the screen.
  [[nodiscard]] std::optional<Event> event_of(const ScreenFacet& facet, std::int32_t column, std::int32_t row) const {
    const view::PixelRect& pixels = facet.pixels;
    if (column < pixels.x0 || column > pixels.x1 || row < pixels.y0 || row > pixels.y1) return std::nullopt;
    if (!testing::is_within(traced_.screen(), facet, column, row)) return std::nullopt;
    for (const Event& event : rays_.at(column, row)) {
      if (event.crossing == facet.crossing()) return event;
    }
    return std::nullopt;
  }

  /// A value of the picture: three coefficients, and a product for each long of two.
  [[nodiscard]] Operations value() const {
    return numbers_.longs * steps({{load_long, 3}, {multiply, 4}, {add_long, 4}});
  }

  /// A facet in the picture: its rectangle, its edges up to the first with the pixel on its other side, its depth.
  [[nodiscard]] Operations projected_test(const ScreenFacet& facet, std::int32_t column, std::int32_t row) const {
    Operations sum = steps({{load, 4}, {compare, 4}, {branch, 4}});
    const view::PixelRect& pixels = facet.pixels;
    if (column < pixels.x0 || column > pixels.x1 || row < pixels.y0 || row > pixels.y1) return sum;
    const auto edges = traced_.screen().bounds_of(facet);
    const auto failed = std::ranges::find_if(
        edges, [&](const view::FixedLinear& edge) { return edge.a * column + edge.b * row + edge.c < 0; });
    const bool is_in = failed == edges.end();
    const auto values = static_cast<std::uint64_t>(failed - edges.begin()) + 1;
    sum += values * (value() + steps({compare, branch}));
    if (is_in) sum += steps({shift_long, {shifted_bit, numbers_.fraction_bits}});
    return sum;
  }

  [[nodiscard]] Operations space_test(const ScreenFacet& facet, const SpaceRay& ray) const {
    if (facet.facet == ScreenFacet::near_cap) return {};
    const auto corners = traced_.facets().corners_of(facet.facet);
    if (corners.size() < 3) return {};
    const Pierced pierced(ray, corners);
    return pierced.side == 0 ? pierced.operations() : pierced.operations() + distance();
  }

  /// Classifies events depth by depth up to a limit; true if the ray enters the solid.
  bool classify(std::vector<Met>& waiting, std::size_t due, Sequence& sequence, std::vector<Event>& events, Hit& hit) {
    while (due > 0) {
      const std::uint32_t depth = waiting.front().event.depth;
      const auto end = std::ranges::find_if(waiting, [&](const Met& one) { return one.event.depth != depth; });
      const std::vector<Met> point(waiting.begin(), end);
      waiting.erase(waiting.begin(), end);
      due -= point.size();
      hit.before = sequence;
      std::vector<Event> at;
      ++counts_.classification.points;
      counts_.classification.operations += point.size() * comparisons(1);
      for (const Met& one : point) {
        sequences_.follow(sequence, one.event.primitive(), counts_.classification);
        at.push_back(one.event);
      }
      if (!sequences_.is_in(sequence, point.size(), counts_.classification)) {
        events.insert(events.end(), at.begin(), at.end());
        continue;
      }
      hit.seen = {depth, sequences_.owner(events, at, counts_.classification)};
      for (const Met& one : point) {
        if (one.event.primitive() == hit.seen.owner) hit.facet = one.facet;
      }
      return true;
    }
    return false;
  }

  /// A pixel's ray: tests its cells' facets and keeps their events in order until no nearer one can follow.
  Hit primary(std::int32_t column, std::int32_t row) {
    RaysMet& met = counts_.primary;
    const SpaceRay ray = traced_.ray_of(column, row);
    Hit hit{{traced_.screen().farthest, VisibleSurface::nothing_seen}};
    std::vector<Met> waiting;
    Sequence sequence;
    std::vector<Event> events;
    std::int64_t known = -1;  // depth up to which events have been taken
    counts_.traversal += products(6);
    if (options_.facet_test == FacetTest::space) counts_.traversal += quotients(2);
    const auto test = [&](std::uint32_t screen) {
      const ScreenFacet& facet = traced_.screen().facets[screen];
      counts_.intersection += testing::calls(1);
      counts_.intersection +=
          options_.facet_test == FacetTest::projected ? projected_test(facet, column, row) : space_test(facet, ray);
      const std::optional<Event> event = event_of(facet, column, row);
      if (!event || static_cast<std::int64_t>(event->depth) <= known) return;
      const auto behind = static_cast<std::uint64_t>(
          std::ranges::count_if(waiting, [&](const Met& one) { return !(one.event < *event); }));
      counts_.intersection += (1 + behind) * steps({load_long, compare_long, {store_long, 2}, branch_taken});
      if (std::ranges::count(waiting, *event, &Met::event) > 0) return;
      ++met.met;
      waiting.push_back({*event, screen});
      std::sort(waiting.begin(), waiting.end());
    };
    bool is_in = false;
    const auto take = [&](std::size_t due) {
      if (due > 0) known = waiting[due - 1].event.depth;
      is_in = classify(waiting, due, sequence, events, hit);
    };
    const auto loose = traced_.loose_in(static_cast<std::uint32_t>(row));
    counts_.intersection += loose.size() * steps({load_long, {compare, 2}, {branch, 2}});
    for (const std::uint32_t screen : loose) {
      const view::PixelRect& pixels = traced_.screen().facets[screen].pixels;
      if (column < pixels.x0 || column > pixels.x1) continue;
      ++met.tested;
      ++met.loose;
      test(screen);
    }
    TestedFacets tested(options_.has_mailboxes, counts_.intersection, met);
    const auto look = [&](const Cell& cell) {
      for (const std::uint32_t facet : cell.facets) {
        if (!tested.is_due(facet)) continue;
        ++met.tested;
        counts_.intersection += steps({{load_long, 2}, {branch, 2}});
        if (traced_.screen_of(facet) != TraceScene::none) test(traced_.screen_of(facet));
      }
      const double settled = traced_.depth_at(cell.settled);
      const auto due = static_cast<std::size_t>(
          std::ranges::count_if(waiting, [&](const Met& one) { return one.event.depth + 1.0 <= settled; }));
      counts_.intersection += (due + 1) * steps({compare_long, branch});
      take(due);
      return !is_in;
    };
    walk(ray, look, met);
    if (!is_in) take(waiting.size());
    if (!is_in) hit.before.clear();
    met.hits += is_in ? 1U : 0U;
    return hit;
  }

  template <class Look>
  void walk(const SpaceRay& ray, const Look& look, RaysMet& met) {
    Visitor visitor(look);
    software::Uncounted uncounted;
    directory_.walk(ray, visitor, uncounted);
    counts_.traversal += walks_.along(ray, visitor.cells, visitor.is_stopped);
    add_ray(visitor.cells, met);
  }

  static void add_ray(std::size_t cells, RaysMet& met) {
    ++met.rays;
    met.cells += cells;
    met.rays_by_cells.resize(std::max(met.rays_by_cells.size(), cells + 1));
    ++met.rays_by_cells[cells];
  }

  /// Visible surfaces in a row by scan conversion of all facets.
  std::vector<Hit> items_of(std::int32_t row) {
    const software::Counts before_row = counts_.classification;
    std::uint64_t items = 0;
    std::vector<std::vector<Met>> met(traced_.width());
    Operations sum;
    for (std::uint32_t i = 0; i < traced_.screen().facets.size(); ++i) {
      const ScreenFacet& facet = traced_.screen().facets[i];
      if (row < facet.pixels.y0 || row > facet.pixels.y1) continue;
      std::uint64_t columns = 0;
      for (std::int32_t column = facet.pixels.x0; column <= facet.pixels.x1; ++column) {
        if (!testing::is_within(traced_.screen(), facet, column, row)) continue;
        ++columns;
        if (const auto event = event_of(facet, column, row))
          met[static_cast<std::size_t>(column)].push_back({*event, i});
      }
      const std::uint64_t longs = numbers_.longs;
      sum += traced_.screen().bounds_of(facet).size() *
             steps({{load_long, 3 * longs}, {divide, 2}, {multiply, 2}, {add_long, longs + 2}, compare, branch});
      sum += longs * steps({{load_long, 2}, add_long});
      sum += testing::depths(columns, numbers_);
      sum += columns * steps({{store_long, 2}, branch_taken});
    }
    std::vector<Hit> hits;
    for (std::vector<Met>& events : met) {
      items += events.size();
      std::uint64_t compared = 0;
      std::sort(events.begin(), events.end(), [&](const Met& a, const Met& b) {
        ++compared;
        return a < b;
      });
      sum += testing::sorted(compared) + steps({{store_long, 2}});
      Hit& hit = hits.emplace_back(Hit{{traced_.screen().farthest, VisibleSurface::nothing_seen}});
      Sequence sequence;
      std::vector<Event> before;
      if (!classify(events, events.size(), sequence, before, hit)) hit.before.clear();
    }
    if (options_.item_pass == ItemPass::depth_lists) {
      counts_.items += items;
      counts_.projection += sum;
    } else {
      // List priority fills the item buffer in any case; its costs include classification.
      counts_.classification = before_row;
    }
    return hits;
  }

  /// Tests only the item of a pixel.
  Hit looked_up(const Hit& hit) {
    RaysMet& met = counts_.primary;
    add_ray(0, met);
    counts_.intersection += comparisons(1);
    if (hit.seen.owner == VisibleSurface::nothing_seen) return hit;
    ++met.hits;
    ++met.tested;
    ++met.met;
    counts_.intersection += options_.facet_test == FacetTest::space ? distance() : value();
    return hit;
  }

  [[nodiscard]] const facet::Plane& plane_of(std::uint32_t facet) const {
    return traced_.geometry().planes.planes()[traced_.facets().facets[facet].halfspace.plane];
  }

  /// Shades the pixel; returns whether it equals `found`.
  bool shade(const Hit& hit, std::int32_t column, std::int32_t row, const software::TracedPixel& found) {
    bool is_same = found.seen == hit.seen;
    counts_.shading += steps({{load_long, 2}, store_long, branch_taken});
    if (hit.facet == TraceScene::none) return is_same;
    const std::uint32_t facet = traced_.screen().facets[hit.facet].facet;
    if (facet == ScreenFacet::near_cap || (!options_.has_shadows && options_.mirror_depth == 0)) return is_same;
    SpaceRay ray = traced_.ray_of(column, row);
    counts_.shading += products(9) + quotients(1);
    const facet::Plane& plane = plane_of(facet);
    glm::dvec3 place = ray.at(-plane.height(ray.origin) / glm::dot(plane.normal, ray.direction));
    Hit at{hit.seen, facet, hit.before};
    is_same = lit(place, at, ray.direction) == found.surface.lit && is_same;
    std::size_t mirrored = 0;
    for (; mirrored < options_.mirror_depth && options_.mirrors[at.facet] != 0; ++mirrored) {
      const glm::dvec3 normal = plane_of(at.facet).normal;
      const glm::dvec3 direction = ray.direction - normal * (2 * glm::dot(normal, ray.direction));
      counts_.shading += products(6) + mixed();
      const Hit next = secondary(place, direction, endless, at, false, counts_.mirror);
      is_same = is_same && found.mirrored.size() > mirrored && found.mirrored[mirrored].facet == next.facet;
      if (next.facet == TraceScene::none) break;
      counts_.shading += products(3);
      place = SpaceRay{place, direction}.at(next.t);
      ray.direction = direction;
      at = next;
      const std::uint32_t lights = lit(place, at, direction);
      is_same = is_same && found.mirrored[mirrored].lit == lights;
    }
    return is_same;
  }

  /// Mixes two colours of three channels.
  static Operations mixed() { return 3 * steps({{load, 2}, multiply, add, store}); }

  /// Sends a ray to each light on the visible side of the facet.
  std::uint32_t lit(const glm::dvec3& place, const Hit& at, const glm::dvec3& seen_along) {
    std::uint32_t lights = 0;
    for (std::size_t i = 0; options_.has_shadows && i < options_.lights.size(); ++i) {
      const software::TraceLight& light = options_.lights[i];
      const glm::dvec3 direction = light.is_point ? light.where - place : light.where;
      const glm::dvec3 normal = plane_of(at.facet).normal;
      counts_.shading += products(3) + comparisons(1);
      if (!(glm::dot(normal, direction) * glm::dot(normal, seen_along) < 0)) continue;
      counts_.shading += mixed();
      const Hit hit = secondary(place, direction, light.is_point ? 1.0 : endless, at, true, counts_.shadow);
      if (hit.t == endless) lights |= 1U << i;
    }
    return lights;
  }

  struct RealEvent {
    double t;
    std::uint32_t facet;
    bool leaves;
  };

  /// A ray that starts on a facet, with the primitives that contain its origin.
  Hit secondary(const glm::dvec3& place, const glm::dvec3& direction, double end, const Hit& from, bool is_any,
                RaysMet& met) {
    SpaceRay ray{place, direction, 0, end};
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(ray.direction[axis]) < std::numeric_limits<double>::min()) ray.direction[axis] = 0;
    }
    const double slack = traced_.slack() / glm::length(direction);
    const auto list = sequences_.held(from.before, counts_.classification);
    std::set<std::uint32_t> held(list.begin(), list.end());
    std::vector<Event> events;
    std::ranges::transform(list, std::back_inserter(events), [](std::uint32_t one) { return Event{0, 2 * one}; });
    Hit hit{{0, VisibleSurface::nothing_seen}};
    Sequence sequence = from.before;
    std::vector<RealEvent> waiting;
    std::set<std::uint32_t> taken;
    bool is_in = false;
    counts_.traversal += quotients(2);
    const auto take = [&](double settled) {
      while (!is_in && !waiting.empty() && waiting.front().t + 2 * slack <= settled) {
        const double near = waiting.front().t + slack;
        const auto behind = std::ranges::find_if(waiting, [&](const RealEvent& one) { return one.t > near; });
        const std::vector<RealEvent> point(waiting.begin(), behind);
        waiting.erase(waiting.begin(), behind);
        is_in = classify(point, sequence, held, events, is_any, hit);
        for (const RealEvent& one : point) taken.insert(one.facet);
      }
    };
    TestedFacets tested(options_.has_mailboxes, counts_.intersection, met);
    const auto look = [&](const Cell& cell) {
      for (const std::uint32_t facet : cell.facets) {
        if (!tested.is_due(facet)) continue;
        ++met.tested;
        try_facet(ray, facet, from.facet, taken, waiting, met);
      }
      take(cell.settled);
      return !is_in;
    };
    walk(ray, look, met);
    take(endless);
    met.hits += is_in ? 1U : 0U;
    return hit;
  }

  void try_facet(const SpaceRay& ray, std::uint32_t facet, std::uint32_t from, const std::set<std::uint32_t>& taken,
                 std::vector<RealEvent>& waiting, RaysMet& met) {
    counts_.intersection += testing::calls(1) + steps({compare, branch});
    const auto corners = traced_.facets().corners_of(facet);
    const std::uint32_t plane = traced_.facets().facets[facet].halfspace.plane;
    if (plane == traced_.facets().facets[from].halfspace.plane || corners.size() < 3) return;
    const Pierced pierced(ray, corners);
    counts_.intersection += pierced.operations();
    if (pierced.side == 0) return;
    counts_.intersection += distance();
    const double t = -plane_of(facet).height(ray.origin) / glm::dot(plane_of(facet).normal, ray.direction);
    if (!(t > 0 && t <= ray.end) || taken.contains(facet)) return;
    if (std::ranges::count(waiting, facet, &RealEvent::facet) > 0) return;
    counts_.intersection += steps({{store_long, 4}});
    ++met.met;
    waiting.push_back({t, facet, pierced.side > 0});
    std::ranges::sort(waiting, {}, [](const RealEvent& one) { return std::pair{one.t, one.facet}; });
  }

  /// Takes the events at one place. Skips the exit of a primitive that is not held and the entry of one that is.
  bool classify(const std::vector<RealEvent>& point, Sequence& sequence, std::set<std::uint32_t>& held,
                std::vector<Event>& events, bool is_any, Hit& hit) {
    software::Counts& counts = counts_.classification;
    ++counts.points;
    counts.operations += point.size() * steps({{load, 2}, branch});
    const Sequence before = sequence;
    std::vector<Event> at;
    for (const RealEvent& one : point) {
      const std::uint32_t primitive = traced_.facets().facets[one.facet].primitive;
      if (held.contains(primitive) != one.leaves) continue;
      if (one.leaves) {
        held.erase(primitive);
      } else {
        held.insert(primitive);
      }
      at.push_back({1, 2 * primitive + (one.leaves ? 1U : 0U)});
      sequences_.follow(sequence, primitive, counts);
    }
    const bool is_in = !at.empty() && sequences_.is_in(sequence, at.size(), counts);
    if (is_in) {
      hit.t = point.front().t;
      hit.before = before;
      if (!is_any) hit.seen.owner = sequences_.owner(events, at, counts);
      for (const RealEvent& one : point) {
        if (!is_any && traced_.facets().facets[one.facet].primitive == hit.seen.owner) hit.facet = one.facet;
      }
    }
    events.insert(events.end(), at.begin(), at.end());
    return is_in;
  }

  const TraceScene& traced_;
  const software::Directory& directory_;
  const TraceOptions& options_;
  testing::PixelEvents rays_;
  testing::Numbers numbers_;
  testing::PlainTree tree_;
  TraceCounts counts_;
  SequenceRecount sequences_;
  testing::WalkRecount walks_;
};

void check_same(const RaysMet& found, const RaysMet& expected) {
  CHECK(found.rays == expected.rays);
  CHECK(found.cells == expected.cells);
  CHECK(found.tested == expected.tested);
  CHECK(found.loose == expected.loose);
  CHECK(found.met == expected.met);
  CHECK(found.repeats == expected.repeats);
  CHECK(found.hits == expected.hits);
  CHECK(found.rays_by_cells == expected.rays_by_cells);
}

struct Tally {
  std::uint64_t primary = 0;
  std::uint64_t shadow = 0;
  std::uint64_t mirror = 0;
  std::uint64_t ties = 0;
};

void check_trace(const Scene& scene, const TraceScene& traced, const std::string& name, std::uint32_t bucket_size,
                 const TraceOptions& options, Tally& tally) {
  const auto directory = software::directory_of(name).make(traced.shapes(), {bucket_size});
  const software::Traced found = software::trace(traced, *directory, options, true);
  // Trees of boxes are complete after all rays.
  const TraceCounts expected = TraceRecount(scene, traced, name, bucket_size, *directory, options).run(found.pixels);
  check_same(found.counts.primary, expected.primary);
  check_same(found.counts.shadow, expected.shadow);
  check_same(found.counts.mirror, expected.mirror);
  CHECK(found.counts.items == expected.items);
  CHECK(found.counts.words == expected.words);
  testing::check_same(found.counts.projection, expected.projection);
  testing::check_same(found.counts.traversal, expected.traversal);
  testing::check_same(found.counts.intersection, expected.intersection);
  testing::check_same(found.counts.shading, expected.shading);
  testing::check_same(found.counts.classification, expected.classification);
  testing::check_same(found.counts.classification.traversal, expected.classification.traversal);
  tally.primary += found.counts.primary.rays;
  tally.shadow += found.counts.shadow.rays;
  tally.mirror += found.counts.mirror.rays;
  tally.ties += found.counts.classification.ties;
}

TraceOptions any_options(testing::Random& random, const TraceScene& traced) {
  TraceOptions options;
  options.item_pass = random.one_of({ItemPass::none, ItemPass::none, ItemPass::depth_lists, ItemPass::list_priority});
  options.list_priority = {steps({{multiply, random.below(1000)}}), random.below(1000), random.below(1000)};
  options.facet_test = random.one_of({FacetTest::space, FacetTest::projected});
  options.has_mailboxes = random.below(3) != 0;
  options.has_shadows = random.below(2) == 0;
  options.mirror_depth = static_cast<unsigned>(random.below(3));
  const auto any = [&] { return 2 * random.unit() - 1; };
  for (std::uint64_t i = random.below(3); i > 0; --i) {
    const bool is_point = random.below(2) == 0;
    options.lights.push_back({is_point, glm::dvec3{any(), any(), any()} * (is_point ? 20.0 : 1.0)});
  }
  for (std::size_t i = 0; i < traced.facets().facets.size(); ++i)
    options.mirrors.push_back(random.below(3) != 0 ? 1 : 0);
  return options;
}

}  // namespace

TEST_CASE("ray tracing counts as a plain recount of cells and facets and rays does") {
  Tally tally;
  std::uint64_t scenes = 0;
  for (std::uint64_t seed = 1; scenes < 150; ++seed) {
    const std::optional<Scene> scene = testing::random_scene(seed);
    if (!scene || !testing::is_faceted(*scene)) continue;
    ++scenes;
    testing::Random random(seed);
    const software::Tree tree = software::make_tree(scene->tree, software::Shape::written);
    const TraceScene traced(scene->tree, scene->geometry, scene->view, tree);
    const auto rows = software::directories();
    for (std::size_t i = 0; i < 2; ++i) {
      const std::string name(rows[(seed + i * 3) % rows.size()]->name);
      CAPTURE(seed);
      CAPTURE(name);
      check_trace(*scene, traced, name, static_cast<std::uint32_t>(2 + random.below(12)), any_options(random, traced),
                  tally);
    }
  }
  MESSAGE(tally.primary, " primary rays, ", tally.shadow, " to lights, ", tally.mirror, " of mirrors, ", tally.ties,
          " ties");
  CHECK(tally.primary > 100 * scenes);
  CHECK(tally.shadow > 10 * scenes);
  CHECK(tally.mirror > 10 * scenes);
  CHECK(tally.ties > 0);
}
