#include "host/solids/axis_parts.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace csgsim::solids {

namespace {

/// A non-horizontal side of the area.
struct AreaSide {
  glm::dvec2 low;
  glm::dvec2 high;

  [[nodiscard]] glm::dvec2 at(double y) const {
    if (y == low.y) return low;
    if (y == high.y) return high;
    return {low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y)), y};
  }
};

/// The left or right boundary of a convex polygon that grows upwards.
struct Chain {
  std::vector<glm::dvec2> corners;
  AreaSide last;  ///< side of the area at which the chain ends
};

/// A convex polygon whose top can still grow.
struct Stack {
  Chain left;
  Chain right;
};

bool operator==(const AreaSide& a, const AreaSide& b) { return a.low == b.low && a.high == b.high; }

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
}

/// Turn of a chain if `side` continues it: positive to the left, 0 if straight.
double turn(const Chain& chain, const AreaSide& side, double high) {
  if (chain.last == side) return 0;
  return turn(chain.corners[chain.corners.size() - 2], chain.corners.back(), side.at(high));
}

void extend(Chain& chain, const AreaSide& side, double high) {
  if (turn(chain, side, high) == 0.0) chain.corners.pop_back();
  chain.corners.push_back(side.at(high));
  chain.last = side;
}

class TrapezoidStacker {
 public:
  explicit TrapezoidStacker(const flat::Area& area) {
    for (const flat::Outline& outline : area.outlines) {
      for (std::size_t i = 0; i < outline.size(); ++i) add(outline[i], outline[(i + 1) % outline.size()]);
    }
    std::sort(levels_.begin(), levels_.end());
    levels_.erase(std::unique(levels_.begin(), levels_.end()), levels_.end());
    std::stable_sort(sides_.begin(), sides_.end(),
                     [](const AreaSide& a, const AreaSide& b) { return a.low.y < b.low.y; });
  }

  std::vector<flat::Outline> operator()() {
    std::vector<AreaSide> active;
    auto next = sides_.begin();
    for (std::size_t level = 0; level + 1 < levels_.size(); ++level) {
      const double low = levels_[level];
      const double high = levels_[level + 1];
      std::erase_if(active, [&](const AreaSide& side) { return side.high.y <= low; });
      for (; next != sides_.end() && next->low.y <= low; ++next) active.push_back(*next);
      std::stable_sort(active.begin(), active.end(), [&](const AreaSide& a, const AreaSide& b) {
        return a.at(low).x + a.at(high).x < b.at(low).x + b.at(high).x;
      });
      slab(active, low, high);
    }
    for (const Stack& stack : open_) close(stack);
    return std::move(parts_);
  }

 private:
  void add(const glm::dvec2& a, const glm::dvec2& b) {
    levels_.push_back(a.y);
    if (a.y < b.y) sides_.push_back({a, b});
    if (a.y > b.y) sides_.push_back({b, a});
  }

  void slab(const std::vector<AreaSide>& active, double low, double high) {
    std::vector<Stack> grown;
    for (std::size_t i = 0; i + 1 < active.size(); i += 2) {
      const AreaSide& left = active[i];
      const AreaSide& right = active[i + 1];
      if (left.at(low).x == right.at(low).x && left.at(high).x == right.at(high).x) continue;
      grown.push_back(grow(left, right, low, high));
    }
    for (const Stack& stack : open_) close(stack);
    open_ = std::move(grown);
  }

  /// Appends a trapezoid to an open stack if the result is convex; otherwise starts a new stack.
  Stack grow(const AreaSide& left, const AreaSide& right, double low, double high) {
    for (Stack& stack : open_) {
      if (stack.left.corners.empty() || left.at(low) == right.at(low)) continue;
      if (stack.left.corners.back() != left.at(low) || stack.right.corners.back() != right.at(low)) continue;
      if (turn(stack.left, left, high) > 0.0 || turn(stack.right, right, high) < 0.0) continue;
      extend(stack.left, left, high);
      extend(stack.right, right, high);
      return std::exchange(stack, {});
    }
    return {{{left.at(low), left.at(high)}, left}, {{right.at(low), right.at(high)}, right}};
  }

  void close(const Stack& stack) {
    if (stack.left.corners.empty()) return;
    flat::Outline outline = stack.right.corners;
    outline.insert(outline.end(), stack.left.corners.rbegin(), stack.left.corners.rend());
    outline.erase(std::unique(outline.begin(), outline.end()), outline.end());
    if (outline.front() == outline.back()) outline.pop_back();
    parts_.push_back(std::move(outline));
  }

  std::vector<double> levels_;
  std::vector<AreaSide> sides_;
  std::vector<Stack> open_;
  std::vector<flat::Outline> parts_;
};

}  // namespace

std::vector<flat::Outline> axis_parts(const flat::Area& area) { return TrapezoidStacker(area)(); }

}  // namespace csgsim::solids
