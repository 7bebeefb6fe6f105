#include "tests/oracle/ray_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace csgsim::testing {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Span missed{{infinity}, {-infinity}};

/// The t at which a ray meets a canonical plane, identical for all primitives with that plane.
double meeting(const Ray& ray, const facet::Plane& plane, const glm::dvec3& centre) {
  return -(glm::dot(plane.normal, ray.origin - centre) + plane.offset) / glm::dot(plane.normal, ray.direction);
}

void narrow_in(Crossing& in, const Crossing& next) {
  const double lead = std::abs(next.t - in.t);
  if (next.t > in.t) {
    in = next;
    in.lead = lead;
  } else {
    in.lead = std::min(in.lead, lead);
  }
}

void narrow_out(Crossing& out, const Crossing& next) {
  const double lead = std::abs(next.t - out.t);
  if (next.t < out.t) {
    out = next;
    out.lead = lead;
  } else {
    out.lead = std::min(out.lead, lead);
  }
}

std::vector<bool> primitives_at(const std::vector<Span>& spans, double t) {
  std::vector<bool> held(spans.size());
  for (std::size_t i = 0; i < spans.size(); ++i) held[i] = spans[i].in.t <= t && t < spans[i].out.t;
  return held;
}

/// Whether all decisions about a crossing are separated by more than the gap, so that rounding cannot change them.
bool is_apart(const Crossing& at, const std::vector<Span>& spans, double gap) {
  if (at.lead < gap) return false;
  return std::all_of(spans.begin(), spans.end(), [&](const Span& span) {
    const auto apart = [&](const Crossing& c) { return c.plane == at.plane || std::abs(c.t - at.t) >= gap; };
    return span.empty() || (apart(span.in) && apart(span.out));
  });
}

/// Whether a primitive is missed so narrowly that rounding could put it in front of t.
bool is_almost_hit(const Span& span, double t, double gap) {
  return span.empty() && span.in.plane != span.out.plane && span.in.t - span.out.t < gap && span.out.t < t + gap;
}

bool all_clearly_hit_or_missed(const std::vector<Span>& spans, double t, double gap) {
  return std::none_of(spans.begin(), spans.end(), [&](const Span& span) { return is_almost_hit(span, t, gap); });
}

struct Candidate {
  Crossing at;
  std::uint32_t primitive = 0;
};

bool comes_before(const Candidate& a, const Candidate& b) {
  return a.at.t != b.at.t ? a.at.t < b.at.t : a.primitive < b.primitive;
}

}  // namespace

RayModel::RayModel(const model::Tree& tree, const facet::Geometry& scene) : scene_(scene), rules_(tree) {
  constexpr double wider = 1.0 + 1e-9;
  for (const facet::Convex& solid : scene.solids) {
    balls_.push_back({solid.box.centre(), wider * glm::length(solid.box.high - solid.box.low) / 2.0});
  }
}

glm::dvec3 RayModel::normal(std::uint32_t primitive, std::uint32_t halfspace) const {
  const facet::Halfspace& side = scene_.solids[primitive].halfspaces[halfspace];
  const glm::dvec3& normal = scene_.planes.planes()[side.plane].normal;
  return side.positive != is_subtracted(primitive) ? normal : -normal;
}

Span RayModel::span(std::uint32_t primitive, const Ray& ray) const {
  const Ball& ball = balls_[primitive];
  const glm::dvec3 to_centre = ball.centre - ray.origin;
  const double squared = glm::dot(ray.direction, ray.direction);
  const double along = glm::dot(to_centre, ray.direction);
  if (glm::dot(to_centre, to_centre) - along * along / squared > ball.radius * ball.radius) return missed;
  Span span{{-infinity, model::no_index, model::no_index, infinity},
            {infinity, model::no_index, model::no_index, infinity}};
  const std::vector<facet::Halfspace>& halfspaces = scene_.solids[primitive].halfspaces;
  for (std::uint32_t i = 0; i < halfspaces.size(); ++i) {
    const facet::Plane& plane = scene_.planes.planes()[halfspaces[i].plane];
    const double side = halfspaces[i].positive ? 1.0 : -1.0;
    const double slope = side * glm::dot(plane.normal, ray.direction);
    const bool begins_on_it = halfspaces[i].plane == ray.plane;
    if (slope == 0.0) {
      const double value = side * (glm::dot(plane.normal, ray.origin - scene_.planes.centre()) + plane.offset);
      if (begins_on_it || value > 0.0) return missed;
      continue;
    }
    const double t = begins_on_it ? 0.0 : meeting(ray, plane, scene_.planes.centre());
    const Crossing crossing{t, i, halfspaces[i].plane, infinity};
    slope < 0.0 ? narrow_in(span.in, crossing) : narrow_out(span.out, crossing);
  }
  return span;
}

std::vector<Span> RayModel::spans(const Ray& ray) const {
  std::vector<Span> spans;
  spans.reserve(balls_.size());
  for (std::uint32_t p = 0; p < balls_.size(); ++p) spans.push_back(span(p, ray));
  return spans;
}

bool RayModel::holds(const std::vector<Span>& spans, double t) const { return rules_.holds(primitives_at(spans, t)); }

Surfaces RayModel::surfaces(const Ray& ray, const Stretch& stretch, double gap) const {
  std::vector<Span> all = spans(ray);
  std::vector<Candidate> candidates;
  for (std::uint32_t p = 0; p < all.size(); ++p) {
    Span& span = all[p];
    if (span.empty()) continue;
    const bool is_cut = stretch.plane == model::no_index && span.in.t < stretch.from;
    if (is_cut) span.in = {stretch.from, model::no_index, model::no_index, infinity};
    if (span.empty()) continue;
    const Crossing& at = is_subtracted(p) ? span.out : span.in;
    const bool is_beyond = stretch.plane == model::no_index || (at.plane != stretch.plane && at.t > stretch.from);
    if (is_beyond) candidates.push_back({at, p});
  }
  std::sort(candidates.begin(), candidates.end(), comes_before);

  Surfaces found;
  for (const Candidate& c : candidates) {
    found.is_clear = found.is_clear && is_apart(c.at, all, gap);
    if (!found.points.empty() && found.points.back().t == c.at.t) continue;
    if (!rules_.shows(c.primitive, primitives_at(all, c.at.t))) continue;
    const bool is_clear = found.is_clear && all_clearly_hit_or_missed(all, c.at.t, gap);
    found.points.push_back(
        {c.at.t, c.primitive, c.at.halfspace, c.at.plane, is_clear && c.at.halfspace != model::no_index});
  }
  found.is_clear = found.is_clear && all_clearly_hit_or_missed(all, infinity, gap);
  return found;
}

Occlusion RayModel::occlusion(const Ray& ray, double length, double gap) const {
  const std::vector<Span> all = spans(ray);
  std::vector<double> stops{0.0, length};
  Occlusion result;
  for (const Span& span : all) {
    if (span.empty()) {
      result.is_clear = result.is_clear && !(is_almost_hit(span, length, gap) && span.in.t > -gap);
      continue;
    }
    for (const Crossing* crossing : std::array{&span.in, &span.out}) {
      if (crossing->t > 0.0 && crossing->t < length) stops.push_back(crossing->t);
      const bool is_own = crossing->plane == ray.plane;
      result.is_clear = result.is_clear && (is_own || std::abs(crossing->t) >= gap);
    }
  }
  std::sort(stops.begin(), stops.end());
  double filled = 0.0;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    const double part = stops[i + 1] - stops[i];
    if (!(part > 0.0)) continue;
    const double middle = std::isinf(part) ? stops[i] + 1.0 : stops[i] + part / 2.0;
    filled = holds(all, middle) ? filled + part : 0.0;
    result.is_blocked = result.is_blocked || filled > 0.0;
    if (filled >= gap && filled > 0.0) return {true, true};
  }
  if (result.is_blocked) result.is_clear = false;
  return result;
}

}  // namespace csgsim::testing
