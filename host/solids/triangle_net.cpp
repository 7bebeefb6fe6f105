#include "host/solids/triangle_net.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace csgsim::solids {

namespace {

/// Maximum excess over 180 degrees, in radians, of the two angles opposite to a diagonal that is not flipped.
constexpr double slack = 0.01;

/// Positive if the middle one of three points, in sweep order, is above the line through the others.
float above(const ProjectedPoint& left, const ProjectedPoint& middle, const ProjectedPoint& right) {
  const float to_left = middle.s - left.s;
  const float to_right = right.s - middle.s;
  if (to_left + to_right <= 0) return 0;
  return (middle.t - right.t) * to_left + (middle.t - left.t) * to_right;
}

/// The angle at the middle one of three points.
float angle(const ProjectedPoint& one, const ProjectedPoint& at, const ProjectedPoint& other) {
  const ProjectedPoint a{other.s - at.s, other.t - at.t};
  const ProjectedPoint b{one.s - at.s, one.t - at.t};
  const double size =
      std::sqrt(static_cast<double>(a.s * a.s + a.t * a.t)) * std::sqrt(static_cast<double>(b.s * b.s + b.t * b.t));
  float cosine = a.s * b.s + a.t * b.t;
  if (const auto rounded = static_cast<float>(size); rounded > 0) cosine /= rounded;
  return static_cast<float>(std::acos(static_cast<double>(std::clamp(cosine, -1.0F, 1.0F))));
}

}  // namespace

TriangleNet::TriangleNet(std::span<const ProjectedPoint> points, std::span<const Link> sides,
                         std::span<const Link> diagonals)
    : points_(points) {
  for (const Link& side : sides) add_edge(side, false);
  for (const Link& diagonal : diagonals) add_edge(diagonal, true);
  join_around_points();
  find_parts();
}

TriangleNet::Half TriangleNet::add_edge(const Link& link, bool is_diagonal) {
  edges_.push_back({.from = link.first});
  edges_.push_back({.from = link.second, .is_inside = is_diagonal});
  return static_cast<Half>(edges_.size() - 2);
}

void TriangleNet::join(Half half, Half next) {
  edges_[half].next = next;
  edges_[next].previous = half;
}

/// Links each half to the half that turns farthest to the left at its end.
void TriangleNet::join_around_points() {
  const auto direction = [&](Half half) {
    return std::atan2(static_cast<double>(to(half).t) - static_cast<double>(from(half).t),
                      static_cast<double>(to(half).s) - static_cast<double>(from(half).s));
  };
  std::map<std::uint32_t, std::vector<Half>> leaving;
  for (Half half = 0; half < edges_.size(); ++half) leaving[edges_[half].from].push_back(half);
  for (auto& [point, halves] : leaving) {
    std::stable_sort(halves.begin(), halves.end(), [&](Half a, Half b) { return direction(a) < direction(b); });
    for (std::size_t i = 0; i < halves.size(); ++i) join(other(halves[(i + 1) % halves.size()]), halves[i]);
  }
}

void TriangleNet::find_parts() {
  std::vector<bool> is_found(edges_.size(), false);
  for (Half first = 0; first < edges_.size(); ++first) {
    if (is_found[first] || !edges_[first].is_inside) continue;
    parts_.push_back(first);
    for (Half half = first; !is_found[half]; half = next(half)) is_found[half] = true;
  }
}

void TriangleNet::cut_parts() {
  for (auto part = parts_.begin(); part != parts_.end(); ++part) cut_part(part);
}

/// Cuts off the triangle of two consecutive halves. Returns the half of the closing edge that remains in the part.
TriangleNet::Half TriangleNet::cut_off_triangle(Half first, Half second, std::list<Half>::iterator part) {
  const Half before = previous(first);
  const Half after = next(second);
  const Half closing = add_edge({edges_[other(second)].from, edges_[first].from}, true);
  join(second, closing);
  join(closing, first);
  join(before, other(closing));
  join(other(closing), after);
  parts_.insert(part, closing);
  *part = other(closing);
  return other(closing);
}

void TriangleNet::cut_part(std::list<Half>::iterator part) {
  Half upper = *part;  // starts at the right end of the remaining part and runs along its upper side
  while (goes_left(upper)) upper = previous(upper);
  while (goes_right(upper)) upper = next(upper);
  *part = upper;
  Half lower = previous(upper);  // runs along the lower side of the part to its right end
  while (next(upper) != lower) {
    if (precedes(to(upper), from(lower))) {
      while (next(lower) != upper && (goes_left(next(lower)) || above(from(lower), to(lower), to(next(lower))) <= 0)) {
        lower = cut_off_triangle(lower, next(lower), part);
      }
      lower = previous(lower);
    } else {
      while (next(lower) != upper &&
             (goes_right(previous(upper)) || above(to(upper), from(upper), from(previous(upper))) >= 0)) {
        upper = cut_off_triangle(previous(upper), upper, part);
      }
      upper = next(upper);
    }
  }
  while (next(next(lower)) != upper) lower = cut_off_triangle(lower, next(lower), part);
}

std::vector<TriangleNet::Half> TriangleNet::queue_diagonals() {
  std::vector<Half> found;
  for (const Half part : parts_) {
    for (const Half half : {part, next(part), previous(part)}) {
      edges_[half].is_queued = is_diagonal(half);
      if (is_diagonal(half) && !edges_[other(half)].is_queued) found.push_back(half);
    }
  }
  return found;
}

/// The angle opposite to a half in the triangle to its left.
float TriangleNet::opposite_angle(Half half) const { return angle(to(half), from(previous(half)), from(half)); }

void TriangleNet::flip_diagonal(Half half) {
  const Half back = other(half);
  const std::array<Half, 2> left{next(half), previous(half)};
  const std::array<Half, 2> right{next(back), previous(back)};
  edges_[half].from = edges_[right[1]].from;
  edges_[back].from = edges_[left[1]].from;
  join(half, left[1]);
  join(left[1], right[0]);
  join(right[0], half);
  join(back, right[1]);
  join(right[1], left[0]);
  join(left[0], back);
}

void TriangleNet::enqueue(Half half, std::vector<Half>& stack) {
  if (edges_[half].is_queued || !is_diagonal(half)) return;
  edges_[half].is_queued = edges_[other(half)].is_queued = true;
  stack.push_back(half);
}

void TriangleNet::flip_diagonals() {
  std::vector<Half> stack = queue_diagonals();
  while (!stack.empty()) {
    const Half half = stack.back();
    stack.pop_back();
    edges_[half].is_queued = edges_[other(half)].is_queued = false;
    if (!(opposite_angle(half) + opposite_angle(other(half)) >= std::numbers::pi + slack)) continue;
    flip_diagonal(half);
    // The fourth edge is not requeued, as in libtess2.
    enqueue(next(half), stack);
    enqueue(previous(half), stack);
    enqueue(next(other(half)), stack);
  }
  parts_.clear();
  find_parts();
}

std::vector<OutlineTriangle> TriangleNet::triangles() const {
  std::vector<OutlineTriangle> made;
  for (const Half part : parts_) {
    made.push_back({edges_[part].from, edges_[next(part)].from, edges_[previous(part)].from});
  }
  return made;
}

}  // namespace csgsim::solids
