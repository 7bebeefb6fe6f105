#include "host/swept/orientation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>

#include "hw/base/error.h"

namespace csgsim::swept {

namespace {

constexpr glm::dvec3 y_axis{0, 1, 0};
/// Minimum length of the projection of the y axis that determines v. For smaller lengths, the tangent is within 5.7
/// degrees of the axis.
constexpr double min_projection = 0.1;
constexpr std::size_t samples = 256;  ///< samples per segment in the search for gaps
constexpr double nowhere = -1;

double projection(const glm::dvec3& tangent) { return std::sqrt(std::max(0.0, 1 - tangent.y * tangent.y)); }

glm::dvec3 projected(const glm::dvec3& tangent) { return glm::normalize(y_axis - tangent.y * tangent); }

glm::dvec3 turned(const glm::dvec3& vector, const glm::dvec3& axis, double angle) {
  return std::cos(angle) * vector + std::sin(angle) * glm::cross(axis, vector) +
         (1 - std::cos(angle)) * glm::dot(axis, vector) * axis;
}

/// Applies to a vector the smallest rotation from one tangent to the other.
glm::dvec3 carried(const glm::dvec3& vector, const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 axis = glm::cross(from, to);
  const double sine = glm::length(axis);
  if (sine < 1e-15) return vector;
  return turned(vector, axis / sine, std::atan2(sine, glm::dot(from, to)));
}

[[noreturn]] void fail_stationary(std::size_t segment) {
  throw InputError(fmt::format("all points of segment {} of the trajectory coincide; remove points", segment + 1));
}

}  // namespace

glm::dvec3 Path::leaving(std::size_t segment) const {
  const Segment& one = segments[segment];
  for (std::uint32_t i = 1; i <= one.degree; ++i) {
    const glm::dvec3 step = one.coefficients[i] - one.first();
    if (const double length = glm::length(step); length > 0) return step / length;
  }
  fail_stationary(segment);
}

glm::dvec3 Path::arriving(std::size_t segment) const {
  const Segment& one = segments[segment];
  for (std::uint32_t i = one.degree; i-- > 0;) {
    const glm::dvec3 step = one.last() - one.coefficients[i];
    if (const double length = glm::length(step); length > 0) return step / length;
  }
  fail_stationary(segment);
}

glm::dvec3 Path::tangent(double position) const {
  const std::size_t count = segments.size();
  const double whole = std::floor(position);
  const auto segment = static_cast<std::size_t>(whole);
  if (position != whole) {
    const glm::dvec3 step = slope(segments[segment % count], position - whole);
    if (const double length = glm::length(step); length > 0) return step / length;
    return leaving(segment % count);
  }
  if (!is_closed && segment == 0) return leaving(0);
  if (!is_closed && segment == count) return arriving(count - 1);
  const glm::dvec3 sum = arriving((segment + count - 1) % count) + leaving(segment % count);
  constexpr double opposite = 0.02;
  if (glm::length(sum) < opposite)
    throw InputError(fmt::format("the trajectory reverses at the end of its segment {}; move that point", segment));
  return glm::normalize(sum);
}

Orientation::Orientation(const Path& path) {
  const std::size_t steps = path.has_corners ? 1 : samples;
  const std::size_t count = path.segments.size() * steps + (path.is_closed ? 0 : 1);
  if (path.is_closed) length_ = static_cast<double>(path.segments.size());
  const auto place = [&](std::size_t i) { return static_cast<double>(i) / static_cast<double>(steps); };
  std::vector<bool> is_upright(count);
  for (std::size_t i = 0; i < count; ++i) is_upright[i] = projection(path.tangent(place(i))) >= min_projection;
  const auto first_upright = std::ranges::find(is_upright, true);
  const std::size_t start = path.is_closed && first_upright != is_upright.end()
                                ? static_cast<std::size_t>(first_upright - is_upright.begin())
                                : 0;
  for (std::size_t i = start; i < start + count;) {
    if (is_upright[i % count]) {
      ++i;
      continue;
    }
    const std::size_t first = i;
    while (i < start + count && !is_upright[i % count]) ++i;
    const bool has_before = first > start;
    const bool has_behind = i < start + count || (path.is_closed && start + count > first && is_upright[start]);
    add_gap(path, has_before ? place(first - 1) : nowhere, place(first), place(i - 1), has_behind ? place(i) : nowhere);
  }
}

/// Finds the boundary of a gap by bisection, between a position outside the gap (`upright`) and one inside (`along`,
/// where the trajectory runs along the y axis). At corners there are no positions in between.
double Orientation::find_gap_boundary(const Path& path, double upright, double along) {
  if (path.has_corners) return upright;
  constexpr int halvings = 40;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (upright + along);
    (projection(path.tangent(middle)) >= min_projection ? upright : along) = middle;
  }
  return upright;
}

void Orientation::add_gap(const Path& path, double upright_before, double first_along, double last_along,
                          double upright_after) {
  Gap gap;
  gap.from = upright_before == nowhere ? first_along : find_gap_boundary(path, upright_before, first_along);
  gap.to = upright_after == nowhere ? last_along : find_gap_boundary(path, upright_after, last_along);
  gap.tangent = path.tangent(upright_before == nowhere && upright_after != nowhere ? gap.to : gap.from);
  if (upright_before == nowhere && upright_after == nowhere) {
    const glm::dvec3 z_axis{0, 0, gap.tangent.y > 0 ? -1 : 1};
    gap.v = glm::normalize(z_axis - glm::dot(z_axis, gap.tangent) * gap.tangent);
  } else {
    gap.v = projected(gap.tangent);
  }
  if (upright_before != nowhere && upright_after != nowhere) {
    const glm::dvec3 end = path.tangent(gap.to);
    const glm::dvec3 there = carried(gap.v, gap.tangent, end);
    const glm::dvec3 meant = projected(end);
    gap.turn = std::atan2(glm::dot(end, glm::cross(there, meant)), glm::dot(there, meant));
  }
  gaps_.push_back(gap);
}

glm::dvec3 Orientation::upward(double position, const glm::dvec3& tangent) const {
  // Gaps are sorted by start; the last gap of a closed path may extend past the path's end.
  for (const double there : {position, position + length_}) {
    const auto behind = std::ranges::upper_bound(gaps_, there, {}, &Gap::from);
    if (behind == gaps_.begin()) continue;
    const Gap& gap = *std::prev(behind);
    if (there > gap.to) continue;
    const double part = gap.to > gap.from ? (there - gap.from) / (gap.to - gap.from) : 0;
    return turned(carried(gap.v, gap.tangent, tangent), tangent, part * gap.turn);
  }
  return projected(tangent);
}

}  // namespace csgsim::swept
