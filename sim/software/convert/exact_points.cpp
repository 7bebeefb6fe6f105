#include "sim/software/convert/exact_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

namespace csgsim::software::convert {

namespace {

/// Number of the cell that contains a coordinate. The width of a cell is about 2^-40 of the coordinate.
std::uint64_t cell_of(double coordinate) {
  constexpr unsigned dropped_bits = 12;
  return std::bit_cast<std::uint64_t>(coordinate) >> dropped_bits;
}

std::uint64_t hash_of(std::span<const std::uint64_t> words) {
  std::uint64_t sum = 0;
  for (const std::uint64_t word : words) {
    sum = (sum ^ word) * 0x9e3779b97f4a7c15U;
    sum ^= sum >> 32U;
  }
  return sum;
}

std::uint64_t cell_at(const glm::dvec3& place) {
  const std::array<std::uint64_t, 3> cells{cell_of(place.x), cell_of(place.y), cell_of(place.z)};
  return hash_of(cells);
}

/// Calls visit(hash) for each cell that may contain an equal point with a differently rounded position.
template <class Visit>
void for_each_near_cell(const glm::dvec3& place, const Visit& visit) {
  std::array<std::array<std::uint64_t, 2>, 3> cells{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    cells[i] = {cell_of(place[axis] * (1 - error_of_place)), cell_of(place[axis] * (1 + error_of_place))};
  }
  for (std::size_t corner = 0; corner < 8; ++corner) {
    std::array<std::uint64_t, 3> cell{};
    bool is_repeated = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t which = corner >> i & 1U;
      is_repeated = is_repeated || (which == 1 && cells[i][0] == cells[i][1]);
      cell[i] = cells[i][which];
    }
    if (!is_repeated) visit(hash_of(cell));
  }
}

/// A plane of `point` that does not contain the other, different point, and that point's side of it.
struct Beyond {
  std::uint32_t plane = 0;
  int side = 0;
};

Beyond beyond(const WholePlanes& planes, const Meeting& point, const Meeting& other) {
  for (const std::uint32_t plane : point.planes)
    if (const int side = planes.side(other, plane); side != 0) return {plane, side};
  return {};
}

}  // namespace

std::size_t ExactPoints::TripleHash::operator()(const Triple& triple) const {
  const std::array<std::uint64_t, 3> words{triple[0], triple[1], triple[2]};
  return hash_of(words);
}

std::uint32_t ExactPoints::add(const Triple& planes) {
  const auto [entry, is_new] = known_.try_emplace(planes, 0);
  if (!is_new) return entry->second;
  const glm::dvec3 place = planes_.exact_position(planes);
  const auto added = static_cast<std::uint32_t>(places_.size());
  std::uint32_t found = added;
  for_each_near_cell(place, [&](std::uint64_t cell) {
    const auto [begin, end] = at_.equal_range(cell);
    for (auto one = begin; one != end && found == added; ++one)
      if (planes_.is_on_all(triples_[one->second], planes)) found = one->second;
  });
  entry->second = found;
  if (found != added) return found;
  triples_.push_back(planes);
  places_.push_back(place);
  at_.emplace(cell_at(place), added);
  return added;
}

std::vector<std::uint32_t> points_between(const WholePlanes& planes, const ExactPoints& points, std::uint32_t from,
                                          std::uint32_t to, std::array<std::uint32_t, 2> line,
                                          std::span<const std::uint32_t> candidates) {
  struct Found {
    Meeting at;
    std::uint32_t point;
  };
  const Meeting start = points.meeting(from);
  const Meeting end = points.meeting(to);
  const Beyond after_start = beyond(planes, start, end);
  const Beyond before_end = beyond(planes, end, start);
  std::vector<Found> found;
  for (const std::uint32_t candidate : candidates) {
    if (!planes.is_on_all(points.planes(candidate), line)) continue;
    const Meeting at = points.meeting(candidate);
    const bool is_between =
        planes.side(at, after_start.plane) == after_start.side && planes.side(at, before_end.plane) == before_end.side;
    if (is_between) found.push_back({at, candidate});
  }
  // A point precedes another if the start lies beyond it as seen from the other.
  std::ranges::sort(found, [&](const Found& one, const Found& other) {
    const Beyond of_other = beyond(planes, other.at, one.at);
    return of_other.side != 0 && planes.side(start, of_other.plane) == of_other.side;
  });
  std::vector<std::uint32_t> numbers;
  numbers.reserve(found.size());
  for (const Found& one : found) numbers.push_back(one.point);
  return numbers;
}

}  // namespace csgsim::software::convert
