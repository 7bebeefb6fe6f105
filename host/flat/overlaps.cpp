#include "host/flat/overlaps.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace csgsim::flat {

namespace {

using ClipperLib::cInt;
using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;
__extension__ using Wide = __int128;

constexpr std::uint64_t search_steps = 200;  ///< steps of work per side

/// A line through grid points: all points x, y with along_x * y - along_y * x == offset.
struct Line {
  cInt along_x = 0;  ///< positive, or 0 if along_y is positive; the two have no common factor
  cInt along_y = 0;
  Wide offset = 0;

  bool operator==(const Line&) const = default;
};

bool is_before(const Line& one, const Line& other) {
  if (one.along_x != other.along_x) return one.along_x < other.along_x;
  if (one.along_y != other.along_y) return one.along_y < other.along_y;
  return one.offset < other.offset;
}

bool is_before(const IntPoint& one, const IntPoint& other) {
  return one.X != other.X ? one.X < other.X : one.Y < other.Y;
}

/// A part of a line, from its lower end to its higher one.
struct LineSide {
  Line line;
  IntPoint low;
  IntPoint high;
};

LineSide make_line_side(IntPoint from, IntPoint to) {
  if (is_before(to, from)) std::swap(from, to);
  const cInt factor = std::gcd(to.X - from.X, to.Y - from.Y);
  const cInt x = (to.X - from.X) / factor;
  const cInt y = (to.Y - from.Y) / factor;
  return {{x, y, Wide{x} * from.Y - Wide{y} * from.X}, from, to};
}

/// The sides of all paths, sorted by line and by position along it.
std::vector<LineSide> sort_line_sides(const Paths& paths) {
  std::vector<LineSide> sides;
  for (const Path& path : paths) {
    for (std::size_t i = 0; i < path.size(); ++i) {
      const IntPoint& next = path[i + 1 < path.size() ? i + 1 : 0];
      if (path[i] != next) sides.push_back(make_line_side(path[i], next));
    }
  }
  std::sort(sides.begin(), sides.end(), [](const LineSide& one, const LineSide& other) {
    return one.line == other.line ? is_before(one.low, other.low) : is_before(one.line, other.line);
  });
  return sides;
}

bool overlap_anywhere(const std::vector<LineSide>& sides) {
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (sides[i].line == sides[i - 1].line && is_before(sides[i].low, sides[i - 1].high)) return true;
  }
  return false;
}

using Ends = std::pair<IntPoint, IntPoint>;

/// Adds the parts of a line along which an odd number of sides run. These parts end at the points at which an odd
/// number of sides end.
void add_odd_parts(std::vector<Ends>& parts, std::span<const LineSide> sides) {
  std::vector<IntPoint> ends;
  for (const LineSide& side : sides) ends.insert(ends.end(), {side.low, side.high});
  std::sort(ends.begin(), ends.end(), [](const IntPoint& a, const IntPoint& b) { return is_before(a, b); });
  std::vector<IntPoint> odd;
  for (const IntPoint& end : ends) {
    if (!odd.empty() && odd.back() == end) {
      odd.pop_back();
    } else {
      odd.push_back(end);
    }
  }
  for (std::size_t i = 0; i + 1 < odd.size(); i += 2) parts.emplace_back(odd[i], odd[i + 1]);
}

/// Joins parts into closed paths. An even number of parts meet at each point.
class Joiner {
 public:
  explicit Joiner(const std::vector<Ends>& parts) : is_used_(parts.size()) {
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
      at_.push_back({parts[i].first, parts[i].second, i});
      at_.push_back({parts[i].second, parts[i].first, i});
    }
    std::sort(at_.begin(), at_.end(), [](const Start& a, const Start& b) { return is_before(a.from, b.from); });
    next_.resize(at_.size());
    std::iota(next_.begin(), next_.end(), std::size_t{0});
  }

  Paths join() {
    Paths paths;
    for (std::size_t i = 0; i < at_.size(); ++i) {
      if (is_used_[at_[i].part]) continue;
      Path& path = paths.emplace_back();
      std::size_t start = i;
      while (true) {
        is_used_[at_[start].part] = true;
        path.push_back(at_[start].from);
        start = first_unused(at_[start].to);
        if (start == at_.size()) break;
      }
    }
    return paths;
  }

 private:
  /// A part, as seen from one of its ends.
  struct Start {
    IntPoint from;
    IntPoint to;
    std::uint32_t part = 0;
  };

  /// The first unused part at a point; at_.size() if all parts there are used.
  std::size_t first_unused(const IntPoint& point) {
    const auto found = std::lower_bound(at_.begin(), at_.end(), point,
                                        [](const Start& one, const IntPoint& p) { return is_before(one.from, p); });
    std::size_t& next = next_[static_cast<std::size_t>(found - at_.begin())];
    for (; next < at_.size() && at_[next].from == point; ++next) {
      if (!is_used_[at_[next].part]) return next;
    }
    return at_.size();
  }

  std::vector<Start> at_;
  std::vector<bool> is_used_;
  std::vector<std::size_t> next_;  ///< for the first part at each point, an index before which all parts are used
};

}  // namespace

Paths remove_coincident_sides(Paths paths, const Work& work) {
  const std::vector<LineSide> sides = sort_line_sides(paths);
  work.charge(search_steps * sides.size(), "finding coincident sides of 2-D shapes");
  if (!overlap_anywhere(sides)) return paths;
  std::vector<Ends> parts;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].line == sides[begin].line) ++end;
    add_odd_parts(parts, std::span(sides).subspan(begin, end - begin));
  }
  return Joiner(parts).join();
}

}  // namespace csgsim::flat
