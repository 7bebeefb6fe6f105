#include "sim/judges/explain.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hw/isa/facts.h"
#include "sim/judges/truth.h"

namespace csgsim::judges {

namespace {

/// Additional fraction bits of edge tests over surfaces.
constexpr int edge_bits = 8;

/// Margin of a primitive's rectangle around its vertices, pixels, in addition to the width of edges.
constexpr double rectangle_margin = 1.0 / 64;

DepthLine depth_line(const isa::Program& program, double unit) {
  const isa::DepthScale& scale = program.facts->depth_scale;
  const isa::CompileFacts& facts = program.facts->compile;
  const double steps = std::ldexp(1.0, static_cast<int>(facts.z_bits)) - 4.0;
  DepthLine line;
  line.z_bits = facts.z_bits;
  line.fraction_bits = facts.fraction_bits;
  line.edge_on_fraction = facts.edge_on_fraction;
  if (scale.perspective) {
    const double per_inverse = steps / (1.0 / scale.near - 1.0 / scale.far);
    line.z_at_zero = 1.0 + per_inverse / scale.near;
    line.z_per_q = per_inverse / unit;
    line.q_middle = -unit * (1.0 / scale.near + 1.0 / scale.far) / 2.0;
    line.q_half_range = unit * (1.0 / scale.near - 1.0 / scale.far) / 2.0;
  } else {
    const double per_distance = steps / (scale.far - scale.near);
    line.z_at_zero = 1.0 - per_distance * scale.near;
    line.z_per_q = per_distance * unit;
    line.q_middle = (scale.near + scale.far) / 2.0 / unit;
    line.q_half_range = (scale.far - scale.near) / 2.0 / unit;
  }
  return line;
}

}  // namespace

/// The results that a machine may compute for a plane at a place.
struct Explainer::PossibleResults {
  enum class Kind : std::uint8_t {
    surface,
    holds,      ///< an edge with the place on its positive side
    excludes,   ///< an edge with the place on its negative side
    undecided,  ///< an edge too close to decide
    either,     ///< possibly an edge, possibly a surface
  };
  Kind kind = Kind::surface;
  Steps steps;
};

Explainer::Explainer(const model::Tree& tree, const facet::Geometry& geometry, const view::Camera& camera,
                     const isa::Program& program)
    : Explainer(tree, geometry,
                std::make_unique<Sight>(geometry, camera, program.shape.width, program.shape.height,
                                        program.facts->depth_scale),
                program) {}

Explainer::Explainer(const model::Tree& tree, const facet::Geometry& geometry, std::unique_ptr<const Sight> sight,
                     const isa::Program& program)
    : Explainer(tree, geometry, *sight, program) {
  own_sight_ = std::move(sight);
}

Explainer::Explainer(const model::Tree& tree, const facet::Geometry& geometry, const Sight& sight,
                     const isa::Program& program)
    : tree_(tree),
      geometry_(geometry),
      width_(program.shape.width),
      height_(program.shape.height),
      sight_(sight),
      line_(depth_line(program, sight_.axis_length())),
      quadrics_(geometry, sight_, line_),
      reaches_(solid_reaches(geometry, sight_.camera())),
      steepest_(std::ldexp(1.0, static_cast<int>(line_.z_bits)) / line_.edge_on_fraction) {}

Steps Explainer::steps(std::uint32_t index, Place place) const {
  // 0, or 1 if the near plane, which is fitted to the model, is behind a face by the last bit of a double.
  if (index == sight_.near_plane()) return {0, 1};
  if (index > sight_.near_plane()) {
    const Sheet sheet = sight_.quadric_sheet(index);
    const QuadricOutcome outcome = quadrics_.outcome(sheet.index, place);
    return sheet.root == Root::nearer ? outcome.nearer : outcome.farther;
  }
  const SightPlane& plane = sight_.plane(index);
  return line_.steps({plane.c, plane.a, plane.b, 0, 0, 0, 0}, plane.condition, DepthLine::rounding(place), place);
}

Explainer::PossibleResults Explainer::possible_results(std::uint32_t index, Place place) const {
  const SightPlane& plane = sight_.plane(index);
  if (!std::isfinite(plane.error)) return {PossibleResults::Kind::either, {}};
  // Slope per pixel; the coefficients are per half pixel.
  const double a = 2.0 * std::abs(plane.a);
  const double b = 2.0 * std::abs(plane.b);
  const double slope = std::hypot(a, b) * line_.z_per_q;
  const double doubt = DepthLine::double_part * plane.condition;
  const bool exact_edge = plane.role == Role::edge;
  if (!exact_edge && slope * (1.0 + doubt) < steepest_) return {PossibleResults::Kind::surface, steps(index, place)};
  if (!exact_edge && slope * (1.0 - doubt) <= steepest_) return {PossibleResults::Kind::either, {}};
  const double value = plane.at(place) - (exact_edge ? 0.0 : line_.q_middle);
  const double terms = std::abs(plane.c) + std::abs(plane.a * place.x) + std::abs(plane.b * place.y) +
                       (exact_edge ? 0.0 : std::abs(line_.q_middle));
  const double zone = (exact_edge ? 0.0 : line_.q_half_range) + DepthLine::double_part * terms * plane.condition +
                      std::max(a, b) * DepthLine::rounding(place) * std::ldexp(line_.ulp(), -edge_bits);
  if (std::abs(value) <= zone) return {PossibleResults::Kind::undecided, {}};
  // A front's half-space is behind it: it contains the depths if the plane is nearer.
  const bool positive = plane.role == Role::back ? value > 0.0 : value < 0.0;
  return {positive ? PossibleResults::Kind::holds : PossibleResults::Kind::excludes, {}};
}

/// Adds the half-space's front, back or edge at the place to the candidate. Returns false if it excludes the whole ray.
bool Explainer::try_add_halfspace(Candidate& candidate, const facet::Halfspace& halfspace, Place place) const {
  const PossibleResults is = possible_results(halfspace.plane, place);
  switch (is.kind) {
    case PossibleResults::Kind::surface: {
      const bool front = (sight_.plane(halfspace.plane).role == Role::front) == halfspace.positive;
      (front ? candidate.fronts : candidate.backs).push_back({halfspace.plane, is.steps});
      return true;
    }
    case PossibleResults::Kind::holds: return halfspace.positive;
    case PossibleResults::Kind::excludes: return !halfspace.positive;
    case PossibleResults::Kind::undecided:
      candidate.edges.push_back({halfspace.plane, halfspace.positive});
      return true;
    case PossibleResults::Kind::either: candidate.is_doubtful = true; return true;
  }
  return true;
}

/// Adds the quadric's front, back or edge at the place to the candidate. Returns false if it excludes the whole ray. If
/// rays begin inside the quadric, it has a back only if the ray meets it at all.
bool Explainer::try_add_quadric(Candidate& candidate, const facet::QuadricSide& side, Place place) const {
  const SightQuadric& quadric = sight_.quadrics().quadric(side.quadric);
  QuadricOutcome outcome = quadrics_.outcome(side.quadric, place);
  const std::uint32_t nearer = sight_.surface({side.quadric, Root::nearer});
  const std::uint32_t farther = sight_.surface({side.quadric, Root::farther});
  if (outcome.is_doubtful) {
    candidate.is_doubtful = true;
    return true;
  }
  const bool on_far_nappe = quadric.ahead != 0 && (quadric.ahead < 0) == side.along_axis;
  if (!outcome.is_edge && quadric.opening < 0 && !on_far_nappe) {
    if (outcome.is_met == Maybe::unknown) outcome.nearer.high = std::max(outcome.nearer.high, line_.farthest());
    if (outcome.is_met != Maybe::no) candidate.backs.push_back({nearer, outcome.nearer});
    return true;
  }
  if (outcome.is_met == Maybe::no) return false;
  if (outcome.is_met == Maybe::unknown) candidate.edges.push_back({nearer, true});
  if (outcome.is_edge) return true;
  const bool is_from = quadric.opening < 0;
  candidate.fronts.push_back(is_from ? Intersection{farther, outcome.farther} : Intersection{nearer, outcome.nearer});
  if (!is_from) candidate.backs.push_back({farther, outcome.farther});
  return true;
}

/// Whether the place is inside the rectangle of pixels at which the primitive is drawn.
Maybe Explainer::is_in_rectangle(std::uint32_t primitive, Place place) const {
  const PlaceRect& reach = reaches_[primitive];
  if (reach.x0 > reach.x1) return Maybe::no;
  // Places are in half pixels.
  const double beyond =
      std::max(std::max(reach.x0 - place.x, place.x - reach.x1), std::max(reach.y0 - place.y, place.y - reach.y1)) /
      2.0;
  const double margin = rectangle_margin + line_.edge_on_fraction;
  const double sizes =
      std::max(std::abs(reach.x0), std::abs(reach.x1)) + std::max(std::abs(reach.y0), std::abs(reach.y1));
  const double doubt = 0x1p-20 + 0x1p-40 * sizes;
  if (beyond < margin - doubt) return Maybe::yes;
  return beyond > margin + doubt ? Maybe::no : Maybe::unknown;
}

Ray Explainer::make_ray(Place place) const {
  Ray ray;
  // Indices after all surfaces: one per primitive, for its rectangle.
  const std::uint32_t rectangles = sight_.surface({sight_.quadrics().count(), Root::nearer});
  for (std::uint32_t primitive = 0; primitive < geometry_.solids.size(); ++primitive) {
    Candidate candidate{
        primitive, {}, {{sight_.near_plane(), {0, 0}}}, {{nothing, {line_.farthest(), line_.farthest()}}}, false};
    const Maybe in_rect = is_in_rectangle(primitive, place);
    if (in_rect == Maybe::no) continue;
    if (in_rect == Maybe::unknown) candidate.edges.push_back({rectangles + primitive, true});
    const facet::Convex& solid = geometry_.solids[primitive];
    const bool on_ray =
        std::all_of(solid.halfspaces.begin(), solid.halfspaces.end(),
                    [&](const facet::Halfspace& one) { return try_add_halfspace(candidate, one, place); }) &&
        std::all_of(solid.quadrics.begin(), solid.quadrics.end(),
                    [&](const facet::QuadricSide& one) { return try_add_quadric(candidate, one, place); });
    if (!on_ray) continue;
    for (const EdgeUse& edge : candidate.edges) {
      if (std::find(ray.undecided_edges.begin(), ray.undecided_edges.end(), edge.plane) == ray.undecided_edges.end()) {
        ray.undecided_edges.push_back(edge.plane);
      }
    }
    ray.candidates.push_back(std::move(candidate));
  }
  return ray;
}

bool Explainer::may_show(std::uint32_t column, std::uint32_t row, std::uint32_t owner, std::uint32_t depth) const {
  return can_show(tree_, make_ray(make_place(column, row, width_, height_)), owner, depth);
}

}  // namespace csgsim::judges
