#include "hw/division/rendering.h"

#include <algorithm>

namespace csgsim::division {

namespace {

using isa::Opcode;
using isa::Purpose;

}  // namespace

Rendering::Rendering(Datapath& path, const Surface& surface)
    : model_(path.header()), surface_(surface), complemented_(surface.complemented) {
  const Box column{surface.box.pixels, 0, model_.farthest()};
  Extremes fronts = find_extremes(path, surface.tested, Side::front, column);
  Extremes backs = find_extremes(path, surface.tested, Side::back, column);
  const Extremes& own = complemented_ ? backs : fronts;
  is_empty_ = fronts.is_empty || backs.is_empty || (complemented_ && own.facets.empty());
  // If a front is behind depth 0 at all corners, the surface does not reach depth 0: its box begins behind it.
  const bool reaches_zero = fronts.facets.empty() || surface.box.z_low == 0;
  if (!complemented_ && reaches_zero) {
    facets_.push_back({true, surface.first, surface.near_colour, {}, 0, 0});
  }
  for (const TestedHalfspace& one : own.facets) facets_.push_back(facet_of(one));
  others_ = std::move(complemented_ ? fronts.facets : backs.facets);
  const auto start =
      std::find_if(facets_.begin(), facets_.end(), [&](const Facet& facet) { return facet.at_zero || fits(facet); });
  start_ = static_cast<std::size_t>(start - facets_.begin());
}

Rendering::Facet Rendering::facet_of(const TestedHalfspace& tested) const {
  return {false, tested.primitive, tested.halfspace.colour, tested.plane, tested.low, tested.high};
}

/// Whether Z1 can hold the facet at all pixels of the surface, except beyond the other end of the depth range.
bool Rendering::fits(const Facet& facet) const {
  return complemented_ ? facet.high <= model_.farthest() : facet.low >= 0;
}

isa::Origin Rendering::shading(const Facet& facet) const {
  return {Purpose::shade, facet.primitive, surface_.count > 1 ? surface_.first : isa::no_node};
}

void Rendering::write_surface(Writer& out, const Rectangle& square) const {
  const Rectangle& pixels = surface_.box.pixels;
  const isa::Field z1 = model_.fields.candidate;
  out.origin = {Purpose::render, surface_.first, isa::no_node};
  out.plain(Opcode::enable_all);
  out.clip(pixels, square);
  out.edges(surface_.tested, pixels);
  model_.fields.candidate_colour.width > 0 ? write_extreme_with_colours(out) : write_extreme(out);
  for (const TestedHalfspace& other : others_) {
    out.depth(complemented_ ? Opcode::linear_lt : Opcode::linear_gt, z1, other.plane, pixels);
  }
  if (complemented_) write_near_test(out);
}

void Rendering::write_start(Writer& out) const {
  const isa::Field z1 = model_.fields.candidate;
  if (start_ < facets_.size() && !facets_[start_].at_zero) {
    out.depth(Opcode::load_linear, z1, facets_[start_].plane, surface_.box.pixels);
  } else {
    out.set(z1, complemented_ ? static_cast<std::uint64_t>(model_.farthest()) : 0);
  }
}

void Rendering::write_extreme(Writer& out) const {
  write_start(out);
  for (std::size_t i = 0; i < facets_.size(); ++i) {
    if (i == start_) continue;
    out.depth(complemented_ ? Opcode::keep_min : Opcode::keep_max, model_.fields.candidate, facets_[i].plane,
              surface_.box.pixels);
  }
}

/// Each facet replaces those that it exceeds, with the mask as E. Among equal facets the first wins: facets after the
/// start facet replace only strictly lesser ones, in order; facets before it also replace equal ones, in reverse order.
void Rendering::write_extreme_with_colours(Writer& out) const {
  write_start(out);
  out.plain(Opcode::enable_store, model_.fields.mask);
  write_candidate_colour(out, start_ < facets_.size() ? facets_[start_] : facets_.back());
  for (std::size_t i = start_ + 1; i < facets_.size(); ++i) write_replacement(out, facets_[i], false);
  for (std::size_t i = start_; i-- > 0;) write_replacement(out, facets_[i], true);
  out.plain(Opcode::enable_load, model_.fields.mask);
}

void Rendering::write_replacement(Writer& out, const Facet& facet, bool replace_equal) const {
  const Rectangle& pixels = surface_.box.pixels;
  const isa::Field z1 = model_.fields.candidate;
  out.plain(Opcode::enable_load, model_.fields.mask);
  // There is no surface beyond the end of the depth range.
  if (!complemented_ && facet.high > model_.farthest()) {
    out.line(Opcode::edge_negative, depth_range_excess(model_, facet.plane), pixels);
    out.plain(Opcode::enable_store, model_.fields.mask);
  } else if (complemented_ && facet.low < 0) {
    out.line(Opcode::edge_not_negative, facet.plane, pixels);
    out.plain(Opcode::enable_store, model_.fields.mask);
  }
  const Opcode more = complemented_ ? Opcode::linear_lt : Opcode::linear_gt;
  const Opcode more_or_equal = complemented_ ? Opcode::linear_le : Opcode::linear_ge;
  out.depth(replace_equal ? more_or_equal : more, z1, facet.plane, pixels);
  out.depth(Opcode::load_linear, z1, facet.plane, pixels);
  write_candidate_colour(out, facet);
}

void Rendering::write_candidate_colour(Writer& out, const Facet& facet) const {
  const isa::Origin rendering = out.origin;
  out.origin = shading(facet);
  out.set(model_.fields.candidate_colour, facet.colour);
  out.origin = rendering;
}

/// A subtracted solid has no visible back where its back is before the near plane.
void Rendering::write_near_test(Writer& out) const {
  if (std::any_of(facets_.begin(), facets_.end(), [](const Facet& back) { return back.low <= 0; }))
    out.depth(Opcode::linear_lt, model_.fields.candidate, {}, surface_.box.pixels);
}

void Rendering::write_depth_test(Writer& out) const {
  out.origin = {Purpose::merge, surface_.first, isa::no_node};
  out.plain(Opcode::field_lt, model_.fields.candidate, model_.fields.depth);
  out.plain(Opcode::enable_store, model_.fields.mask);
}

void Rendering::write_merge(Writer& out) const {
  out.origin = {Purpose::merge, surface_.first, surface_.count > 1 ? surface_.first : isa::no_node};
  out.plain(Opcode::copy, model_.fields.depth, model_.fields.candidate);
  if (model_.fields.candidate_colour.width > 0) {
    out.plain(Opcode::copy, model_.fields.colour, model_.fields.candidate_colour);
  } else {
    write_colours(out);
  }
}

/// Broadcasts each facet but the last again; each removes its pixels from the mask.
void Rendering::write_colours(Writer& out) const {
  for (std::size_t i = 0; i < facets_.size(); ++i) {
    const Facet& facet = facets_[i];
    const bool is_last = i + 1 == facets_.size();
    out.origin = shading(facet);
    if (i > 0) out.plain(Opcode::enable_load, model_.fields.mask);
    if (!is_last) out.depth(Opcode::linear_eq, model_.fields.candidate, facet.plane, surface_.box.pixels);
    out.set(model_.fields.colour, facet.colour);
    if (!is_last) out.set(model_.fields.mask, 0);
  }
}

}  // namespace csgsim::division
