#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "hw/isa/depth_scale.h"
#include "sim/judges/sight.h"
#include "sim/judges/tiles.h"
#include "sim/judges/tree_on_ray.h"
#include "sim/judges/truth.h"

namespace csgsim::judges {

namespace {

/// Tiles of at most this side are drawn pixel by pixel.
constexpr std::uint32_t small_tile = 4;

/// A point of a ray where it enters or leaves a primitive.
struct Event {
  Sheet sheet;
  std::uint32_t primitive;
  bool enters;
};

/// The farthest (sign 1) or nearest (sign -1) of the planes on a ray, exact.
std::optional<Sheet> extreme(const Sight& sight, std::span<const facet::Halfspace> planes, Place place, int sign) {
  if (planes.empty()) return std::nullopt;
  std::uint32_t best = planes.front().plane;
  for (const facet::Halfspace& other : planes.subspan(1)) {
    if (sight.compare(other.plane, best, place) * sign > 0) best = other.plane;
  }
  return Sheet{best, Root::only};
}

/// The farther (sign 1) or nearer (sign -1) of two sheets on a ray, either of which may be missing.
std::optional<Sheet> extreme(const Sight& sight, std::optional<Sheet> a, std::optional<Sheet> b, Place place,
                             int sign) {
  if (!a || !b) return a ? a : b;
  return sight.compare(*b, *a, place) * sign > 0 ? b : a;
}

class Painter {
 public:
  Painter(const model::Tree& tree, const Sight& sight, Truth& truth) : sight_(sight), truth_(truth), on_ray_(tree) {}

  /// Divides the tile into quarters until it is small, and narrows the pieces at each level.
  void paint(const Pieces& pieces, const Tile& tile) {
    if (pieces.pieces.empty()) return;
    if (std::max(tile.width(), tile.height()) <= small_tile) {
      for (std::uint32_t y = tile.y0; y < tile.y1; ++y) {
        for (std::uint32_t x = tile.x0; x < tile.x1; ++x) paint_pixel(pieces, x, y);
      }
      return;
    }
    const std::uint32_t half = std::max(tile.width(), tile.height()) / 2;
    for (std::uint32_t y = tile.y0; y < tile.y1; y += half) {
      for (std::uint32_t x = tile.x0; x < tile.x1; x += half) {
        const Tile part{x, y, std::min(x + half, tile.x1), std::min(y + half, tile.y1)};
        paint(prune_to_tile(pieces, sight_, part, truth_.width, truth_.height), part);
      }
    }
  }

 private:
  void paint_pixel(const Pieces& pieces, std::uint32_t x, std::uint32_t y) {
    const Place place = make_place(x, y, truth_.width, truth_.height);
    events_.clear();
    for (const Piece& piece : pieces.pieces) add_events(pieces, piece, place);
    if (events_.empty()) return;
    std::sort(events_.begin(), events_.end(),
              [&](const Event& a, const Event& b) { return sight_.compare(a.sheet, b.sheet, place) < 0; });
    const Event* seen = first_seen(on_ray_, std::span<const Event>(events_), [&](const Event& a, const Event& b) {
      return sight_.compare(a.sheet, b.sheet, place) == 0;
    });
    if (seen == nullptr) return;
    const std::size_t pixel = static_cast<std::size_t>(y) * truth_.width + x;
    truth_.distance[pixel] = sight_.distance(seen->sheet, place);
    truth_.owner[pixel] = seen->primitive;
    truth_.plane[pixel] = sight_.surface(seen->sheet);
  }

  void add_events(const Pieces& pieces, const Piece& piece, Place place) {
    for (const facet::Halfspace& edge : pieces.of(piece.edges)) {
      if (sight_.edge_contains_ray(edge.plane, place) != edge.positive) return;
    }
    const Part between{extreme(sight_, pieces.of(piece.fronts), place, 1),
                       extreme(sight_, pieces.of(piece.backs), place, -1)};
    const std::optional<Part> part = within(between, pieces.quadrics_in(piece), place);
    if (!part) return;
    events_.push_back({*part->front, piece.primitive, true});
    events_.push_back({*part->back, piece.primitive, false});
  }

  /// The part of a ray that the quadrics leave. It is a single part, as solids are convex.
  [[nodiscard]] std::optional<Part> within(const Part& part, std::span<const facet::QuadricSide> sides,
                                           Place place) const {
    if (sides.empty()) {
      const bool is_any = part.front && part.back && sight_.compare(*part.front, *part.back, place) < 0;
      return is_any ? std::optional(part) : std::nullopt;
    }
    for (const Part& in : sight_.quadrics().parts(sides.front(), place)) {
      const Part common{extreme(sight_, part.front, in.front, place, 1),
                        extreme(sight_, part.back, in.back, place, -1)};
      if (const auto found = within(common, sides.subspan(1), place)) return found;
    }
    return std::nullopt;
  }

  const Sight& sight_;
  Truth& truth_;
  TreeOnRay on_ray_;
  std::vector<Event> events_;
};

}  // namespace

Truth exact_truth(const model::Tree& tree, const facet::Geometry& geometry, const Sight& sight) {
  const std::uint32_t width = sight.camera().width;
  const std::uint32_t height = sight.camera().height;
  Truth truth = empty_truth(width, height);
  if (tree.root == model::no_index) return truth;
  Painter(tree, sight, truth).paint(all_pieces(geometry, sight), {0, 0, width, height});
  return truth;
}

Truth exact_truth(const model::Tree& tree, const facet::Geometry& geometry, const view::Camera& camera,
                  std::uint32_t width, std::uint32_t height, const isa::DepthScale& depth) {
  if (tree.root == model::no_index) return empty_truth(width, height);
  return exact_truth(tree, geometry, Sight(geometry, camera, width, height, depth));
}

}  // namespace csgsim::judges
