// First-point coherence.
// One of the rows of coherences(), also used by the others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/software/cost/operations.h"
#include "sim/software/rays/ray_band.h"
#include "sim/software/traversals/status.h"
#include "sim/software/tree/tree.h"

namespace csgsim::software {

/// One precomputed bit per primitive: whether the solid contains a point that is in this primitive only (thesis 4.5.1).
template <class Count>
class SolePrimitivePoints {
 public:
  SolePrimitivePoints(const Tree& tree, Count& count) : is_in_(tree.leaf_of.size()) {
    if (tree.is_constant()) return;
    StatusTree<Count> status(tree);
    for (std::uint32_t primitive = 0; primitive < is_in_.size(); ++primitive) {
      count(Operation::call, 3);
      status.flip(primitive, count);
      is_in_[primitive] = status.evaluate(count);
      status.flip(primitive, count);
      count.precomputation();
    }
  }

  [[nodiscard]] bool is_in(std::uint32_t primitive, Count& count) const {
    count.look_up();
    count(Operation::load, 2);
    count(Operation::logic);
    return is_in_[primitive];
  }

  [[nodiscard]] std::uint64_t words() const { return (is_in_.size() + 31) / 32; }

 private:
  std::vector<bool> is_in_;
};

/// Whether a point is the first of its ray and behind one surface only.
constexpr bool is_first_alone(std::size_t begin, std::size_t end) { return begin == 0 && end == 1; }

/// Looks up whether the first point of a ray is inside if it is behind one surface; evaluates all other points.
template <class Count>
class FirstPoint {
 public:
  FirstPoint(const Tree& tree, Count& count) : alone_(tree, count) {}

  void begin_ray() {}

  template <class Evaluate>
  bool is_in(std::span<const Event> events, std::size_t begin, std::size_t end, const Evaluate& evaluate,
             Count& count) {
    count(Operation::compare);
    count(Operation::branch);
    return is_first_alone(begin, end) ? alone_.is_in(events[0].primitive(), count) : evaluate();
  }

  [[nodiscard]] std::uint64_t words() const { return alone_.words(); }

 private:
  SolePrimitivePoints<Count> alone_;
};

}  // namespace csgsim::software
