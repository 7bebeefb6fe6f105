#include "sim/judges/tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace csgsim::judges {

namespace {

/// A rectangle of places: its middle and half its sides.
struct Middle {
  double x;
  double y;
  double half_width;
  double half_height;
};

struct Range {
  double low;
  double high;
};

Middle tile_middle(const Tile& tile, std::uint32_t width, std::uint32_t height) {
  const Place first = make_place(tile.x0, tile.y0, width, height);
  const Place last = make_place(tile.x1 - 1, tile.y1 - 1, width, height);
  return {(first.x + last.x) / 2.0, (first.y + last.y) / 2.0, (last.x - first.x) / 2.0, (last.y - first.y) / 2.0};
}

/// Bounds of a plane's depth, or of an edge's value, over the tile.
Range range_over(const SightPlane& plane, const Middle& tile) {
  const double value = plane.c + plane.a * tile.x + plane.b * tile.y;
  const double reach = std::abs(plane.a) * tile.half_width + std::abs(plane.b) * tile.half_height + 2.0 * plane.error;
  return {value - reach, value + reach};
}

/// Bounds of a quadratic function over the tile.
Range range_over(const FilterQuadratic& of, const Middle& tile) {
  const double value = of.c + tile.x * (of.x + of.xx * tile.x + of.xy * tile.y) + tile.y * (of.y + of.yy * tile.y);
  const double along_x = of.x + 2.0 * of.xx * tile.x + of.xy * tile.y;
  const double along_y = of.y + 2.0 * of.yy * tile.y + of.xy * tile.x;
  const double reach = std::abs(along_x) * tile.half_width + std::abs(along_y) * tile.half_height +
                       std::abs(of.xy) * tile.half_width * tile.half_height + 4.0 * of.error;
  const double xx = of.xx * tile.half_width * tile.half_width;
  const double yy = of.yy * tile.half_height * tile.half_height;
  return {value - reach + std::min(xx, 0.0) + std::min(yy, 0.0), value + reach + std::max(xx, 0.0) + std::max(yy, 0.0)};
}

/// Bounds over the tile of the ends of the ray parts inside a quadric; empty if there are none.
Range range_over(const SightQuadric& quadric, const Middle& tile) {
  const Range square = range_over(quadric.square, tile);
  if (quadric.opening < 0) return {-infinity, infinity};
  if (square.high < 0.0) return {infinity, -infinity};
  if (quadric.opening == 0 || !std::isfinite(square.high)) return {-infinity, infinity};
  const Range middle = range_over(quadric.middle, tile);
  const double root = std::sqrt(square.high) * (1.0 + std::numeric_limits<double>::epsilon());
  return {middle.low - root, middle.high + root};
}

enum class Containment : std::uint8_t { all, none, part };

Containment containment(facet::Halfspace edge, const Sight& sight, const Middle& tile) {
  const Range range = range_over(sight.plane(edge.plane), tile);
  if (range.high < 0.0) return edge.positive ? Containment::all : Containment::none;
  if (range.low > 0.0) return edge.positive ? Containment::none : Containment::all;
  return Containment::part;
}

/// Narrows one primitive after the other.
class Narrowing {
 public:
  Narrowing(const Pieces& from, const Sight& sight, const Middle& tile) : from_(from), sight_(sight), tile_(tile) {}

  Pieces run() {
    for (const Piece& piece : from_.pieces) {
      const auto mark = static_cast<std::ptrdiff_t>(into_.halfspaces.size());
      if (!add(piece)) into_.halfspaces.erase(into_.halfspaces.begin() + mark, into_.halfspaces.end());
    }
    return std::move(into_);
  }

 private:
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(into_.halfspaces.size()); }

  /// Adds the half-spaces and quadrics of the primitive that matter in the tile. Returns false if the primitive is
  /// nowhere in the tile.
  bool add(const Piece& piece) {
    Piece kept{piece.primitive, {size(), 0}, {}, {}, {}};
    for (const facet::Halfspace& edge : from_.of(piece.edges)) {
      const Containment part = containment(edge, sight_, tile_);
      if (part == Containment::none) return false;
      if (part == Containment::part) into_.halfspaces.push_back(edge);
    }
    kept.edges.end = kept.fronts.begin = size();
    Range all{-infinity, infinity};
    for (const facet::QuadricSide& side : from_.quadrics_in(piece)) {
      const Range range = range_over(sight_.quadrics().quadric(side.quadric), tile_);
      all = {std::max(all.low, range.low), std::min(all.high, range.high)};
    }
    double front = all.low;
    for (const facet::Halfspace& plane : from_.of(piece.fronts)) front = std::max(front, range(plane).low);
    double back = all.high;
    for (const facet::Halfspace& plane : from_.of(piece.backs)) back = std::min(back, range(plane).high);
    if (front > back) return false;
    for (const facet::Halfspace& plane : from_.of(piece.fronts)) {
      if (range(plane).high >= front) into_.halfspaces.push_back(plane);
    }
    kept.fronts.end = kept.backs.begin = size();
    for (const facet::Halfspace& plane : from_.of(piece.backs)) {
      if (range(plane).low <= back) into_.halfspaces.push_back(plane);
    }
    kept.backs.end = size();
    kept.quadrics.begin = static_cast<std::uint32_t>(into_.quadrics.size());
    const auto quadrics = from_.quadrics_in(piece);
    into_.quadrics.insert(into_.quadrics.end(), quadrics.begin(), quadrics.end());
    kept.quadrics.end = static_cast<std::uint32_t>(into_.quadrics.size());
    into_.pieces.push_back(kept);
    return true;
  }

  [[nodiscard]] Range range(facet::Halfspace plane) const { return range_over(sight_.plane(plane.plane), tile_); }

  const Pieces& from_;
  const Sight& sight_;
  const Middle& tile_;
  Pieces into_;
};

}  // namespace

Pieces all_pieces(const facet::Geometry& geometry, const Sight& sight) {
  Pieces all;
  const auto size = [&] { return static_cast<std::uint32_t>(all.halfspaces.size()); };
  const auto add = [&](const facet::Convex& solid, Role role) {
    const std::uint32_t begin = size();
    for (const facet::Halfspace& halfspace : solid.halfspaces) {
      Role is = sight.plane(halfspace.plane).role;
      if (is != Role::edge && !halfspace.positive) is = is == Role::front ? Role::back : Role::front;
      if (is == role) all.halfspaces.push_back(halfspace);
    }
    if (role == Role::front && sight.is_perspective()) all.halfspaces.push_back({sight.near_plane(), true});
    if (role == Role::back && sight.is_perspective() && !solid.quadrics.empty()) {
      all.halfspaces.push_back({sight.horizon(), true});
    }
    return Run{begin, size()};
  };
  for (std::uint32_t primitive = 0; primitive < geometry.solids.size(); ++primitive) {
    const facet::Convex& solid = geometry.solids[primitive];
    const Run edges = add(solid, Role::edge);
    const Run fronts = add(solid, Role::front);
    const Run backs = add(solid, Role::back);
    const auto begin = static_cast<std::uint32_t>(all.quadrics.size());
    all.quadrics.insert(all.quadrics.end(), solid.quadrics.begin(), solid.quadrics.end());
    const Run quadrics{begin, static_cast<std::uint32_t>(all.quadrics.size())};
    // A solid must be bounded along every ray.
    const bool bounded = fronts.begin < fronts.end && backs.begin < backs.end;
    if (bounded || !solid.quadrics.empty()) all.pieces.push_back({primitive, edges, fronts, backs, quadrics});
  }
  return all;
}

Pieces prune_to_tile(const Pieces& pieces, const Sight& sight, const Tile& tile, std::uint32_t width,
                     std::uint32_t height) {
  return Narrowing(pieces, sight, tile_middle(tile, width, height)).run();
}

}  // namespace csgsim::judges
