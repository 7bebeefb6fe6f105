#include "host/effects/shadow_broadcast.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "host/emit/early_out.h"
#include "hw/isa/opcodes.h"
#include "hw/machines/clocks.h"

namespace csgsim::effects {

namespace {

using isa::Opcode;
using view::PixelRect;
using view::Side;

bool contains(const std::vector<ShadowPlane>& planes, const ShadowPlane& plane) {
  return std::find(planes.begin(), planes.end(), plane) != planes.end();
}

struct PlaneHash {
  std::size_t operator()(const ShadowPlane& plane) const {
    std::uint64_t hash = static_cast<std::uint64_t>(plane.side) * 2 + (plane.is_strict ? 1U : 0U);
    for (const std::int64_t one : {plane.linear.a, plane.linear.b, plane.linear.c}) {
      hash = (hash ^ static_cast<std::uint64_t>(one)) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 32U;
    }
    return hash;
  }
};

PixelRect hull(std::span<const ShadowPart> parts) {
  PixelRect all;
  for (const ShadowPart& part : parts) all = view::hull(all, part.pixels);
  return all;
}

/// The plane that most parts share; at least two must. Null if there is none.
const ShadowPlane* most_shared_plane(std::span<const ShadowPart> parts) {
  struct Sharers {
    std::size_t count = 0;
    const ShadowPart* last = nullptr;
  };
  std::unordered_map<ShadowPlane, Sharers, PlaneHash> sharers;
  for (const ShadowPart& part : parts) {
    for (const ShadowPlane& plane : part.planes) {
      Sharers& of_plane = sharers[plane];
      if (std::exchange(of_plane.last, &part) != &part) ++of_plane.count;
    }
  }
  const ShadowPlane* best = nullptr;
  std::size_t most = 1;
  for (const ShadowPart& part : parts) {
    for (const ShadowPlane& plane : part.planes) {
      const std::size_t count = sharers[plane].count;
      if (count > most) best = &plane, most = count;
    }
  }
  return best;
}

/// Planes that all parts share.
std::vector<ShadowPlane> in_common(std::span<const ShadowPart> parts) {
  std::vector<ShadowPlane> common = parts.front().planes;
  for (const ShadowPart& part : parts)
    std::erase_if(common, [&](const ShadowPlane& plane) { return !contains(part.planes, plane); });
  return common;
}

/// An area in which parts are searched, and how E is restricted there.
struct Place {
  isa::Field mark{};   ///< 1 inside the area; if its width is 0, the area is all pixels of the context
  PixelRect pixels;    ///< rectangle that contains the area
  unsigned marks = 0;  ///< number of mark bits in use
};

class Shadowing {
 public:
  Shadowing(const emit::Context& context, emit::Broadcast& out, isa::Field flag, isa::Field marks)
      : context_(context), out_(out), flag_(flag), marks_(marks) {}

  void emit(std::vector<ShadowPart> parts) {
    const Place everywhere{context_.base, context_.plan.pixels(), 0};
    name(parts.front());
    load(everywhere);
    out_.plain(Opcode::set_constant, flag_, {}, 0);
    const PixelRect pixels = hull(parts);
    if (marks_.width == 0 || !is_clipping_worth(parts, everywhere.pixels))
      return emit_within(std::move(parts), everywhere);
    const Place clipped = mark_within(pixels, {}, everywhere);
    const std::size_t begin = out_.size();
    emit_within(std::move(parts), clipped);
    ask(begin);
  }

 private:
  void name(const ShadowPart& part) { out_.origin = {isa::Purpose::effect, part.primitive, isa::no_node}; }

  void load(const Place& place) {
    place.mark.width > 0 ? out_.plain(Opcode::enable_load, place.mark) : out_.plain(Opcode::enable_all);
  }

  void ask(std::size_t begin) { emit_early_out(context_, out_, begin, out_.origin); }

  void compare(emit::Broadcast& out, const ShadowPlane& plane, const PixelRect& pixels) const {
    const isa::Field depth = context_.layout.depth;
    switch (plane.side) {
      case Side::front:
        return out.surface(plane.is_strict ? Opcode::linear_lt : Opcode::linear_le, depth, plane.linear, pixels);
      case Side::back: return out.surface(Opcode::linear_gt, depth, plane.linear, pixels);
      case Side::edge_positive: return out.edge(Opcode::edge_not_negative, plane.linear, pixels);
      case Side::edge_negative: return out.edge(Opcode::edge_negative, plane.linear, pixels);
    }
  }

  template <class Emit>
  [[nodiscard]] std::uint64_t count_clocks(const Emit& emit) const {
    isa::Segment segment{context_.plan.region, {}, {}};
    emit::Broadcast out(segment, context_.view.sampling, context_.options.work);
    emit(out);
    return machines::clocks(segment.instructions, context_.machine);
  }

  /// Whether the narrower planes save more clocks than clipping E to the parts takes.
  [[nodiscard]] bool is_clipping_worth(std::span<const ShadowPart> parts, const PixelRect& outer) const {
    const PixelRect inner = view::common(hull(parts), outer);
    const std::uint64_t clipping = count_clocks([&](emit::Broadcast& out) { out.clip(inner, outer); });
    if (clipping == 0) return false;
    std::vector<ShadowPlane> planes;
    std::unordered_set<ShadowPlane, PlaneHash> known;
    for (const ShadowPart& part : parts) {
      for (const ShadowPlane& plane : part.planes)
        if (known.insert(plane).second) planes.push_back(plane);
    }
    const auto clocks_in = [&](const PixelRect& pixels) {
      return count_clocks([&](emit::Broadcast& out) {
        for (const ShadowPlane& plane : planes) compare(out, plane, pixels);
      });
    };
    return clipping + clocks_in(inner) < clocks_in(outer);
  }

  /// Stores in a mark bit where E is 1 within the pixels and the planes.
  Place mark_within(const PixelRect& pixels, std::span<const ShadowPlane> planes, const Place& outer) {
    const Place inner{{static_cast<std::uint16_t>(marks_.base + outer.marks), 1},
                      view::common(pixels, outer.pixels),
                      outer.marks + 1};
    load(outer);
    out_.clip(inner.pixels, outer.pixels);
    for (const ShadowPlane& plane : planes) compare(out_, plane, inner.pixels);
    out_.plain(Opcode::enable_store, inner.mark);
    return inner;
  }

  void emit_within(std::vector<ShadowPart> parts, const Place& place) {
    while (!parts.empty()) {
      const ShadowPlane* const shared = place.marks < marks_.width ? most_shared_plane(parts) : nullptr;
      if (shared == nullptr) break;
      const ShadowPlane plane = *shared;
      const auto others = std::stable_partition(parts.begin(), parts.end(),
                                                [&](const ShadowPart& part) { return contains(part.planes, plane); });
      std::vector<ShadowPart> together(parts.begin(), others);
      parts.erase(parts.begin(), others);
      emit_together(std::move(together), place);
    }
    for (const ShadowPart& part : parts) emit_alone(part, place);
  }

  void emit_together(std::vector<ShadowPart> parts, const Place& place) {
    name(parts.front());
    const PixelRect pixels = is_clipping_worth(parts, place.pixels) ? hull(parts) : place.pixels;
    const std::vector<ShadowPlane> common = in_common(parts);
    const Place inner = mark_within(pixels, common, place);
    for (ShadowPart& part : parts)
      std::erase_if(part.planes, [&](const ShadowPlane& plane) { return contains(common, plane); });
    const std::size_t begin = out_.size();
    emit_within(std::move(parts), inner);
    ask(begin);
  }

  void emit_alone(const ShadowPart& part, const Place& place) {
    name(part);
    load(place);
    const bool is_clipped = is_clipping_worth({&part, 1}, place.pixels);
    const PixelRect pixels = is_clipped ? view::common(part.pixels, place.pixels) : place.pixels;
    out_.clip(pixels, place.pixels);
    const std::size_t begin = out_.size();
    for (const ShadowPlane& plane : part.planes) compare(out_, plane, pixels);
    out_.plain(Opcode::set_constant, flag_, {}, 1);
    if (is_clipped) ask(begin);
  }

  const emit::Context& context_;
  emit::Broadcast& out_;
  isa::Field flag_;
  isa::Field marks_;
};

}  // namespace

void emit_shadows(const emit::Context& context, emit::Broadcast& out, std::span<const ShadowPart> parts,
                  isa::Field flag, isa::Field marks) {
  if (parts.empty()) return;
  Shadowing(context, out, flag, marks).emit({parts.begin(), parts.end()});
}

}  // namespace csgsim::effects
