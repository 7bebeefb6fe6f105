#include "sim/plots/labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "sim/plots/text_size.h"

namespace csgsim::plots {

namespace {

constexpr double gap = 2;               ///< pixels from a mark to the label next to it
constexpr double away_from_others = 6;  ///< preferred distance in pixels from other marks
constexpr double first_ring = 12;       ///< distance in pixels from a mark to a label with a leader
constexpr double ring_step = 8;
constexpr unsigned rings = 12;
constexpr unsigned directions = 16;

/// Directions around the point, in order of preference: top right first.
constexpr auto beside = std::to_array<Pixel>({{1, -1}, {1, 0}, {1, 1}, {0, -1}, {0, 1}, {-1, -1}, {-1, 0}, {-1, 1}});

/// A box `width` wide in the given direction from `at`, with its nearest point at `distance`.
Box box_towards(const Pixel& at, const Pixel& direction, double distance, double width) {
  const double x = at.x + direction.x * distance + std::clamp(direction.x * 2, -1.0, 1.0) * width / 2;
  const double y = at.y + direction.y * distance + std::clamp(direction.y * 2, -1.0, 1.0) * line_height / 2;
  return {x - width / 2, y - line_height / 2, x + width / 2, y + line_height / 2};
}

Segment leader_to(const Pixel& at, const Box& box) {
  return {at, {std::clamp(at.x, box.left, box.right), std::clamp(at.y, box.top, box.bottom)}};
}

class Placer {
 public:
  explicit Placer(const Surroundings& surroundings) : around_(surroundings) {}

  /// Tries to place a text of the given width; returns whether it succeeded.
  bool place(std::size_t request, const LabelRequest& what, double width, std::optional<unsigned> number) {
    const Pixel& at = what.at;
    for (const double distance : {away_from_others, 0.0}) {
      for (const Pixel& direction : beside) {
        const Box box = box_towards(at, direction, what.clearance + gap, width);
        if (!is_near_another(box, at, distance) && take(request, box, std::nullopt, number)) return true;
      }
    }
    for (unsigned ring = 0; ring < rings; ++ring) {
      for (unsigned i = 0; i < directions; ++i) {
        const double turn = std::numbers::pi * (2.0 * i / directions - 0.25);
        const Box box =
            box_towards(at, {std::cos(turn), std::sin(turn)}, what.clearance + first_ring + ring_step * ring, width);
        if (take(request, box, leader_to(at, box), number)) return true;
      }
    }
    return false;
  }

  [[nodiscard]] const std::vector<PlacedLabel>& placed() const { return placed_; }

 private:
  bool take(std::size_t request, const Box& box, const std::optional<Segment>& leader, std::optional<unsigned> number) {
    if (!is_clear(box) || (leader && !is_clear(*leader))) return false;
    placed_.push_back({request, box, leader, number});
    return true;
  }

  /// Whether a mark of another point is so close to the box that the label could be read as belonging to it.
  [[nodiscard]] bool is_near_another(const Box& box, const Pixel& at, double distance) const {
    const Box wide{box.left - distance, box.top - distance, box.right + distance, box.bottom + distance};
    return std::ranges::any_of(around_.boxes, [&](const Box& one) {
      return boxes_overlap(one, wide) && !boxes_overlap(one, plots::square_around(at, 1));
    });
  }

  [[nodiscard]] bool is_clear(const Box& box) const {
    const auto is_hit = [&](const Segment& segment) { return segment_meets_box(segment, box); };
    return is_within(box, around_.area) &&
           std::ranges::none_of(around_.boxes, [&](const Box& one) { return boxes_overlap(one, box); }) &&
           std::ranges::none_of(around_.segments, is_hit) &&
           std::ranges::none_of(placed_, [&](const PlacedLabel& label) {
             return boxes_overlap(label.box, box) || (label.leader && is_hit(*label.leader));
           });
  }

  [[nodiscard]] bool is_clear(const Segment& leader) const {
    const auto holds = [&](const Box& box) { return boxes_overlap(plots::square_around(leader.from, 0.01), box); };
    return std::ranges::none_of(around_.boxes,
                                [&](const Box& box) { return segment_meets_box(leader, box) && !holds(box); }) &&
           std::ranges::none_of(placed_, [&](const PlacedLabel& label) {
             return segment_meets_box(leader, label.box) || (label.leader && segments_cross(leader, *label.leader));
           });
  }

  const Surroundings& around_;
  std::vector<PlacedLabel> placed_;
};

}  // namespace

std::vector<PlacedLabel> place_labels(std::span<const LabelRequest> requests, const Surroundings& surroundings) {
  Placer placer(surroundings);
  unsigned numbers = 0;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (placer.place(i, requests[i], requests[i].width, std::nullopt)) continue;
    if (placer.place(i, requests[i], text_width(std::to_string(numbers + 1)), numbers + 1)) ++numbers;
  }
  return placer.placed();
}

}  // namespace csgsim::plots
