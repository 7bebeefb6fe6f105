#include "sim/judges/explain.h"

#include <algorithm>
#include <cmath>

namespace csgsim::judges {

namespace {

/// What doubles lose in a plane's depth, as a part of the sum of its terms; times SightPlane::condition.
constexpr double double_part = 0x1p-49;

/// Fraction bits that edge tests have more than surfaces.
constexpr int edge_bits = 8;

std::int64_t floor_step(double value) {
  constexpr double limit = 0x1p60;
  return static_cast<std::int64_t>(std::clamp(std::floor(value), -limit, limit));
}

}  // namespace

/// What a machine makes of a plane at a place.
struct Explainer::Nature {
  enum class Kind : std::uint8_t {
    surface,
    holds,      ///< as an edge, which has the place on its positive side
    excludes,   ///< as an edge, which has the place on its negative side
    undecided,  ///< as an edge, which passes too close to tell
    either,     ///< perhaps as an edge, perhaps as a surface
  };
  Kind kind = Kind::surface;
  Steps steps;
};

Explainer::Explainer(const model::Tree& tree, const facet::Scene& scene, const view::Camera& camera,
                     const isa::Program& program)
    : tree_(tree),
      scene_(scene),
      width_(program.shape.width),
      height_(program.shape.height),
      sight_(scene.planes, camera, width_, height_, program.facts.depth_scale),
      z_bits_(program.facts.compile.z_bits),
      ulp_(std::ldexp(0.5, -static_cast<int>(program.facts.compile.fraction_bits))) {
  const isa::DepthScale& scale = program.facts.depth_scale;
  const double steps = std::ldexp(1.0, static_cast<int>(z_bits_)) - 4.0;
  const double unit = sight_.axis_length();
  if (scale.perspective) {
    const double per_inverse = steps / (1.0 / scale.near - 1.0 / scale.far);
    z_at_zero_ = 1.0 + per_inverse / scale.near;
    z_per_q_ = per_inverse / unit;
    q_middle_ = -unit * (1.0 / scale.near + 1.0 / scale.far) / 2.0;
    q_half_range_ = unit * (1.0 / scale.near - 1.0 / scale.far) / 2.0;
  } else {
    const double per_distance = steps / (scale.far - scale.near);
    z_at_zero_ = 1.0 - per_distance * scale.near;
    z_per_q_ = per_distance * unit;
    q_middle_ = (scale.near + scale.far) / 2.0 / unit;
    q_half_range_ = (scale.far - scale.near) / 2.0 / unit;
  }
  steepest_ = (steps + 4.0) / program.facts.compile.edge_on_fraction;
}

/// How far rounded coefficients may take a linear function from what it is at the middle of the picture, in units of
/// 2^-(fraction bits).
double Explainer::rounding(Place place) const { return 1.0 + (std::abs(place.x) + std::abs(place.y)) / 2.0; }

Steps Explainer::steps(std::uint32_t index, Place place) const {
  // 0, or 1 if the near plane, which is fitted to the model, lies behind a face by the last bit of a double.
  if (index >= sight_.near_plane()) return {0, 1};
  const SightPlane& plane = sight_.plane(index);
  const double q = plane.at(place);
  const double terms = std::abs(z_at_zero_) + std::abs(z_per_q_) * (std::abs(plane.c) + std::abs(plane.a * place.x) +
                                                                    std::abs(plane.b * place.y));
  const double off = rounding(place) * ulp_ + double_part * terms * plane.condition;
  const double z = z_at_zero_ + z_per_q_ * q;
  return {floor_step(z - off), floor_step(z + off)};
}

Explainer::Nature Explainer::nature(std::uint32_t index, Place place) const {
  const SightPlane& plane = sight_.plane(index);
  if (!std::isfinite(plane.error)) return {Nature::Kind::either, {}};
  // Per whole pixel; coefficients count half pixels.
  const double a = 2.0 * std::abs(plane.a);
  const double b = 2.0 * std::abs(plane.b);
  const double slope = std::hypot(a, b) * z_per_q_;
  const double doubt = double_part * plane.condition;
  const bool exact_edge = plane.role == Role::edge;
  if (!exact_edge && slope * (1.0 + doubt) < steepest_) return {Nature::Kind::surface, steps(index, place)};
  if (!exact_edge && slope * (1.0 - doubt) <= steepest_) return {Nature::Kind::either, {}};
  const double value = plane.at(place) - (exact_edge ? 0.0 : q_middle_);
  const double terms = std::abs(plane.c) + std::abs(plane.a * place.x) + std::abs(plane.b * place.y) +
                       (exact_edge ? 0.0 : std::abs(q_middle_));
  const double zone = (exact_edge ? 0.0 : q_half_range_) + double_part * terms * plane.condition +
                      std::max(a, b) * rounding(place) * std::ldexp(ulp_, -edge_bits);
  if (std::abs(value) <= zone) return {Nature::Kind::undecided, {}};
  // A front's half-space lies behind it: it holds the depths if the plane is nearer than they are.
  const bool positive = plane.role == Role::back ? value > 0.0 : value < 0.0;
  return {positive ? Nature::Kind::holds : Nature::Kind::excludes, {}};
}

Ray Explainer::make_ray(Place place) const {
  const std::int64_t farthest = (std::int64_t{1} << z_bits_) - 1;
  Ray ray;
  for (std::uint32_t primitive = 0; primitive < scene_.solids.size(); ++primitive) {
    Chance chance{
        primitive, {}, {{sight_.near_plane(), {0, 0}}}, {{sight_.near_plane() + 1, {farthest, farthest}}}, false};
    bool out = false;
    for (const facet::Halfspace& halfspace : scene_.solids[primitive].halfspaces) {
      const Nature is = nature(halfspace.plane, place);
      switch (is.kind) {
        case Nature::Kind::surface: {
          const bool front = (sight_.plane(halfspace.plane).role == Role::front) == halfspace.positive;
          (front ? chance.fronts : chance.backs).push_back({halfspace.plane, is.steps});
          break;
        }
        case Nature::Kind::holds: out = out || !halfspace.positive; break;
        case Nature::Kind::excludes: out = out || halfspace.positive; break;
        case Nature::Kind::undecided: chance.edges.push_back({halfspace.plane, halfspace.positive}); break;
        case Nature::Kind::either: chance.doubtful = true; break;
      }
      if (out) break;
    }
    if (out) continue;
    for (const EdgeUse& edge : chance.edges) {
      if (std::find(ray.undecided_edges.begin(), ray.undecided_edges.end(), edge.plane) == ray.undecided_edges.end()) {
        ray.undecided_edges.push_back(edge.plane);
      }
    }
    ray.chances.push_back(std::move(chance));
  }
  return ray;
}

bool Explainer::may_show(std::uint32_t column, std::uint32_t row, std::uint32_t owner, std::uint32_t depth) const {
  return can_show(tree_, make_ray(place_of(column, row, width_, height_)), owner, depth);
}

}  // namespace csgsim::judges
