// Tracing of shadow and mirror rays.
// Used by trace.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "sim/software/coherences/sequences.h"
#include "sim/software/space/arithmetic.h"
#include "sim/software/tracing/counts.h"
#include "sim/software/tracing/piercing.h"
#include "sim/software/tracing/trace_scene.h"

namespace csgsim::software {

/// Start of a secondary ray: a point on a facet, on the side from which it is seen.
struct Start {
  glm::dvec3 place{0};                      ///< relative to PlaneTable::centre()
  std::uint32_t facet = TraceScene::none;   ///< index into Facets::facets; facets in its plane are ignored
  std::uint32_t before = TraceScene::none;  ///< list element that identifies the primitives containing the start
};

/// The point at which a secondary ray enters the solid.
struct RealHit {
  double t = std::numeric_limits<double>::infinity();
  std::uint32_t owner = VisibleSurface::nothing_seen;
  std::uint32_t facet = TraceScene::none;   ///< index into Facets::facets
  std::uint32_t before = TraceScene::none;  ///< as in Start

  [[nodiscard]] bool is_in_solid() const { return t < std::numeric_limits<double>::infinity(); }
};

/// Rays in floating-point arithmetic that start at a surface. Events at the same place, within the slack of the scene,
/// are processed together.
template <class Count>
class SecondaryRays final : public CellVisitor {
 public:
  SecondaryRays(const TraceScene& scene, const Directory& directory, bool has_mailboxes, Sequences<Count>& sequences,
                TraceMeters<Count>& meters)
      : scene_(scene),
        directory_(directory),
        has_mailboxes_(has_mailboxes),
        sequences_(sequences),
        meters_(meters),
        last_ray_(scene.facets().facets.size()),
        holds_(scene.tree().leaf_of.size()) {}

  /// The first point up to t = end at which the ray enters the solid. If `is_any`, any such point, without its owner.
  RealHit trace(const Start& start, const glm::dvec3& direction, double end, bool is_any, RaysMet& met) {
    begin(start, direction, end, met);
    is_any_ = is_any;
    const std::vector<std::uint32_t> held = sequences_.primitives_at(start.before, meters_.classification);
    for (const std::uint32_t primitive : held) holds_[primitive] = 1;
    events_.clear();
    for (const std::uint32_t primitive : held) events_.push_back({0, 2 * primitive});
    directory_.walk(ray_, *this, meters_.traversal);
    if (!is_done_) settle(std::numeric_limits<double>::infinity());
    met.hits += is_done_ ? 1U : 0U;
    met.add_cells(cells_);
    std::ranges::fill(holds_, std::uint8_t{0});
    return hit_;
  }

  bool visit(const Cell& cell) override {
    ++cells_;
    for (const std::uint32_t facet : cell.facets) {
      if (has_mailboxes_ && was_tested(facet)) continue;
      test_facet(facet);
    }
    settle(cell.settled);
    return !is_done_;
  }

 private:
  struct RealEvent {
    double t;
    std::uint32_t facet;
    bool leaves;
    bool operator<(const RealEvent& other) const { return t != other.t ? t < other.t : facet < other.facet; }
  };

  void begin(const Start& start, const glm::dvec3& direction, double end, RaysMet& met) {
    ray_ = {start.place, direction, 0, end};
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(ray_.direction[axis]) < std::numeric_limits<double>::min()) ray_.direction[axis] = 0;
    }
    piercing_.emplace(ray_);
    plane_ = scene_.facets().facets[start.facet].halfspace.plane;
    slack_ = scene_.slack() / glm::length(direction);
    met_ = &met;
    element_ = start.before;
    pending_.clear();
    taken_.clear();
    hit_ = {};
    cells_ = 0;
    is_done_ = false;
    ++met.rays;
    ++number_;
    count_quotients(meters_.traversal, 2);
  }

  bool was_tested(std::uint32_t facet) {
    meters_.intersection(Operation::load_long, 2);
    meters_.intersection(Operation::compare_long);
    meters_.intersection(Operation::branch);
    if (last_ray_[facet] == number_) {
      ++met_->repeats;
      return true;
    }
    meters_.intersection(Operation::store_long);
    last_ray_[facet] = number_;
    return false;
  }

  void test_facet(std::uint32_t number) {
    ++met_->tested;
    const Facet& facet = scene_.facets().facets[number];
    const std::span<const glm::dvec3> corners = scene_.facets().corners_of(number);
    meters_.intersection(Operation::call);
    meters_.intersection(Operation::come_back);
    meters_.intersection(Operation::compare);
    meters_.intersection(Operation::branch);
    if (facet.halfspace.plane == plane_ || corners.size() < 3) return;
    const int side = piercing_->through(corners, meters_.intersection);
    if (side == 0) return;
    const facet::Plane& plane = scene_.geometry().planes.planes()[facet.halfspace.plane];
    const double t = -plane.height(ray_.origin) / glm::dot(plane.normal, ray_.direction);
    count_distance(meters_.intersection);
    if (!(t > 0 && t <= ray_.end)) return;
    if (std::ranges::find(taken_, number) != taken_.end()) return;
    const RealEvent event{t, number, side > 0};
    const auto place = std::lower_bound(pending_.begin(), pending_.end(), event);
    if (place != pending_.end() && place->facet == number) return;
    meters_.intersection(Operation::store_long, 4);
    ++met_->met;
    pending_.insert(place, event);
  }

  /// Processes the places that are certain, given that the ray is settled up to `settled`.
  void settle(double settled) {
    std::size_t begin = 0;
    while (begin < pending_.size() && !is_done_ && pending_[begin].t + 2 * slack_ <= settled) {
      std::size_t end = begin + 1;
      while (end < pending_.size() && pending_[end].t <= pending_[begin].t + slack_) ++end;
      process_place(std::span(pending_).subspan(begin, end - begin));
      begin = end;
    }
    pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(begin));
  }

  /// Ignores leaving a primitive that was not entered, which happens if rounding moves a place across a face.
  void process_place(std::span<const RealEvent> place) {
    const std::uint32_t before = element_;
    const std::size_t begin = events_.size();
    meters_.classification.point();
    for (const RealEvent& event : place) {
      if (!has_mailboxes_) taken_.push_back(event.facet);
      const std::uint32_t primitive = scene_.facets().facets[event.facet].primitive;
      meters_.classification(Operation::load, 2);
      meters_.classification(Operation::branch);
      if ((holds_[primitive] != 0) != event.leaves) continue;
      holds_[primitive] ^= 1U;
      events_.push_back({1, 2 * primitive + (event.leaves ? 1U : 0U)});
      element_ = sequences_.after(element_, primitive, meters_.classification);
    }
    if (events_.size() == begin) return;
    if (!sequences_.is_in(element_, events_.size() - begin, meters_.classification)) return;
    is_done_ = true;
    hit_.t = place.front().t;
    if (is_any_) return;
    hit_.before = before;
    const std::span<const Event> events(events_);
    hit_.owner = sequences_.owner(events.first(begin), events.subspan(begin), meters_.classification);
    for (const RealEvent& event : place) {
      if (scene_.facets().facets[event.facet].primitive == hit_.owner) hit_.facet = event.facet;
    }
  }

  const TraceScene& scene_;
  const Directory& directory_;
  bool has_mailboxes_;
  Sequences<Count>& sequences_;
  TraceMeters<Count>& meters_;
  std::vector<std::uint32_t> last_ray_;
  std::vector<std::uint8_t> holds_;  ///< per primitive, whether the ray is inside
  std::uint32_t number_ = 0;
  SpaceRay ray_;
  std::optional<Piercing> piercing_;
  std::uint32_t plane_ = 0;
  double slack_ = 0;
  RaysMet* met_ = nullptr;
  std::uint32_t element_ = 0;
  std::vector<RealEvent> pending_;
  std::vector<std::uint32_t> taken_;  ///< facets with processed events, which can reappear without mailboxes
  std::vector<Event> events_;         ///< entries into the primitives containing the start, then the ray's events
  RealHit hit_;
  std::uint64_t cells_ = 0;
  bool is_any_ = false;
  bool is_done_ = false;
};

}  // namespace csgsim::software
