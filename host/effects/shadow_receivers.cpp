#include "host/effects/shadow_receivers.h"

#include <algorithm>
#include <cstdint>

#include "host/emit/drawing.h"
#include "host/emit/shading.h"
#include "host/emit/surface.h"

namespace csgsim::effects {

namespace {

using view::FixedLinear;
using view::Side;

FixedLinear minus(const FixedLinear& a, const FixedLinear& b, std::int64_t more) {
  return {a.a - b.a, a.b - b.b, a.c - b.c + more};
}

FixedLinear negated(const FixedLinear& line, std::int64_t more) { return {-line.a, -line.b, -line.c + more}; }

/// Lines that are not negative where points of a receiver's plane, floor(F) deep, may be in a half-space or out of it.
/// `last` is the greatest fraction of a depth step.
class Comparison {
 public:
  Comparison(const FixedLinear& receiver, unsigned fraction_bits)
      : receiver_(receiver), last_((std::int64_t{1} << fraction_bits) - 1) {}

  [[nodiscard]] FixedLinear in(const ShadowPlane& plane) const {
    switch (plane.side) {
      case Side::front: return minus(receiver_, plane.linear, plane.is_strict ? -1 : last_);
      case Side::back: return minus(plane.linear, receiver_, -1);
      case Side::edge_positive: return plane.linear;
      case Side::edge_negative: return negated(plane.linear, -1);
    }
    return plane.linear;
  }

  [[nodiscard]] FixedLinear out(const ShadowPlane& plane) const {
    switch (plane.side) {
      case Side::front: return minus(plane.linear, receiver_, plane.is_strict ? last_ : -1);
      case Side::back: return minus(receiver_, plane.linear, last_);
      case Side::edge_positive: return negated(plane.linear, -1);
      case Side::edge_negative: return plane.linear;
    }
    return plane.linear;
  }

 private:
  FixedLinear receiver_;
  std::int64_t last_;
};

/// Where the facet is what a surface shows: the farthest of the fronts before all backs, or the nearest of the backs
/// of what is taken away, behind all fronts.
Outline outline_of(const emit::Context& context, const emit::PlannedSurface& planned, const emit::Sides& sides,
                   const emit::Facet& facet) {
  const FixedLinear& plane = context.linear_of(facet.halfspace);
  const Comparison compared(plane, context.view.sampling.fraction_bits);
  const bool complemented = context.complemented(planned.primitive());
  Outline outline(planned.block.pixels);
  const auto keep = [&](const FixedLinear& line) { outline = outline.clipped(line); };
  const unsigned fraction_bits = context.view.sampling.fraction_bits;
  keep({plane.a, plane.b, plane.c - (planned.block.z_low << fraction_bits)});
  keep(negated(plane, ((planned.block.z_high + 1) << fraction_bits) - 1));
  for (const emit::Facet& front : sides.fronts.facets)
    keep(compared.in({Side::front, complemented, context.linear_of(front.halfspace)}));
  for (const emit::Facet& back : sides.backs.facets) {
    const ShadowPlane half{Side::back, false, context.linear_of(back.halfspace)};
    // The nearest of the backs is before the others, or at them.
    keep(complemented ? compared.out({Side::front, true, half.linear}) : compared.in(half));
  }
  for (const std::uint32_t primitive : planned.set) {
    for (const facet::Halfspace& halfspace : context.scene.solids[primitive].halfspaces) {
      const view::ScreenPlane& edge = context.view.planes[halfspace.plane];
      if (edge.kind == view::PlaneKind::edge && edge.representable)
        keep(compared.in({view::side_of(edge, halfspace), false, edge.linear}));
    }
  }
  return outline;
}

/// A volume among receivers: which of its half-spaces are needed.
class Reduction {
 public:
  Reduction(const SeenVolume& volume, const Receivers& receivers, unsigned fraction_bits)
      : volume_(volume), receivers_(receivers), fraction_bits_(fraction_bits), kept_(volume.planes.size(), true) {}

  /// The pixels at which it touches receivers; none if it touches none.
  [[nodiscard]] view::PixelRect touched() const {
    view::PixelRect all;
    for (const Receiver& one : receivers_.facets) {
      const Outline inside = clipped(one, volume_.planes.size());
      if (!inside.empty()) all = view::hull(all, inside.pixels());
    }
    return all;
  }

  /// Leaves out what takes nothing from any receiver that the others leave.
  void reduce() {
    for (std::size_t i = 0; i < kept_.size(); ++i) kept_[i] = !is_redundant(i);
  }

  [[nodiscard]] std::vector<ShadowPlane> planes() const {
    std::vector<ShadowPlane> left;
    for (std::size_t i = 0; i < kept_.size(); ++i)
      if (kept_[i]) left.push_back(volume_.planes[i]);
    return left;
  }

 private:
  /// What the half-spaces that are kept, but for one, leave of a receiver.
  [[nodiscard]] Outline clipped(const Receiver& receiver, std::size_t but) const {
    const Comparison compared(receiver.plane, fraction_bits_);
    return clipped(receiver.outline, compared, but);
  }
  [[nodiscard]] Outline clipped(Outline outline, const Comparison& compared, std::size_t but) const {
    for (std::size_t i = 0; i < kept_.size() && !outline.empty(); ++i) {
      if (i == but || !kept_[i]) continue;
      const FixedLinear line = compared.in(volume_.planes[i]);
      outline = outline.is_beyond(line) ? Outline{} : outline.clipped(line);
    }
    return outline;
  }

  [[nodiscard]] bool is_redundant(std::size_t index) const {
    return std::all_of(receivers_.facets.begin(), receivers_.facets.end(), [&](const Receiver& one) {
      const Comparison compared(one.plane, fraction_bits_);
      const FixedLinear out = compared.out(volume_.planes[index]);
      if (one.outline.is_beyond(out)) return true;
      return clipped(one.outline.clipped(out), compared, index).empty();
    });
  }

  const SeenVolume& volume_;
  const Receivers& receivers_;
  unsigned fraction_bits_;
  std::vector<bool> kept_;
};

/// Whether all that one takes of the receivers the other takes too.
bool holds(const ShadowPart& large, const ShadowPart& small) {
  return std::all_of(large.planes.begin(), large.planes.end(), [&](const ShadowPlane& plane) {
    return std::find(small.planes.begin(), small.planes.end(), plane) != small.planes.end();
  });
}

}  // namespace

Receivers receivers_of(const emit::Context& context, std::size_t light) {
  Receivers receivers;
  for (const emit::PlannedSurface& planned : context.plan.surfaces) {
    if (!emit::is_drawn(context, planned)) continue;
    const emit::Sides sides = emit::deciding_sides(context, planned);
    const emit::Surface surface = emit::surface_of(context, planned, sides);
    if (surface.nothing) continue;
    for (const emit::Facet& facet : surface.facets) {
      if (!emit::light_matters(context, facet, planned.block.pixels, light)) continue;
      if (facet.at != emit::At::plane) {
        receivers.reach_near = true;
        continue;
      }
      Outline outline = outline_of(context, planned, sides, facet);
      if (!outline.empty()) receivers.facets.push_back({context.linear_of(facet.halfspace), std::move(outline)});
    }
  }
  return receivers;
}

std::vector<ShadowPart> parts_that_touch(const std::vector<SeenVolume>& volumes, const Receivers& receivers,
                                         unsigned fraction_bits) {
  std::vector<ShadowPart> parts;
  for (const SeenVolume& volume : volumes) {
    Reduction reduction(volume, receivers, fraction_bits);
    const view::PixelRect pixels = reduction.touched();
    if (pixels.empty()) continue;
    reduction.reduce();
    ShadowPart part{reduction.planes(), pixels, volume.primitive};
    if (std::any_of(parts.begin(), parts.end(), [&](const ShadowPart& one) { return holds(one, part); })) continue;
    std::erase_if(parts, [&](const ShadowPart& one) { return holds(part, one); });
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace csgsim::effects
