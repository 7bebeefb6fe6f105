// Coherence with the list of the previous ray.
// One of the rows of coherences().
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/software/coherences/first_point.h"
#include "sim/software/cost/operations.h"

namespace csgsim::software {

/// Classification of the points after an event.
enum class PointClass : std::uint8_t { unknown, out, in };

constexpr PointClass point_class_of(bool is_in) { return is_in ? PointClass::in : PointClass::out; }

/// Whether a point is inside. If its stored class `kept` is unknown, the class is looked up for a point behind one
/// surface only, or else computed by `evaluate()`, and stored.
template <class Count, class Evaluate>
bool is_in_cached(PointClass& kept, bool is_first, std::uint32_t primitive, const SolePrimitivePoints<Count>& alone,
                  const Evaluate& evaluate, Count& count) {
  if (kept != PointClass::unknown) {
    count.look_up();
    return kept == PointClass::in;
  }
  const bool is_in = is_first ? alone.is_in(primitive, count) : evaluate();
  kept = point_class_of(is_in);
  count(Operation::store);
  return is_in;
}

/// Reuses the list of the previous ray's surfaces and classes while surfaces come in the same order, and rebuilds it
/// from the first difference on (thesis 4.5.2). First points are looked up.
///
/// There are no points between events at the same depth: their class stays unknown until a ray has them at different
/// depths.
template <class Count>
class OneList {
 public:
  OneList(const Tree& tree, Count& count) : alone_(tree, count) {}

  void begin_ray() {}

  template <class Evaluate>
  bool is_in(std::span<const Event> events, std::size_t begin, std::size_t end, const Evaluate& evaluate,
             Count& count) {
    for (std::size_t i = begin; i < end; ++i) follow(events[i].primitive(), i, count);
    PointClass& kept = list_[end - 1].kept;
    count(Operation::load);
    count(Operation::compare);
    count(kept == PointClass::unknown ? Operation::branch_taken : Operation::branch);
    return is_in_cached(kept, is_first_alone(begin, end), events[0].primitive(), alone_, evaluate, count);
  }

  /// An element has a pointer to the next, and a primitive with its class.
  [[nodiscard]] std::uint64_t words() const { return alone_.words() + 2 * max_length_; }

 private:
  struct Element {
    std::uint32_t primitive;
    PointClass kept;
  };

  void follow(std::uint32_t primitive, std::size_t place, Count& count) {
    count(Operation::load_long);
    count(Operation::load, 2);
    count(Operation::compare, 2);
    if (place < list_.size() && list_[place].primitive == primitive) {
      count.list_step();
      count(Operation::branch, 2);
      return;
    }
    count(Operation::branch_taken);
    list_.resize(place);
    list_.push_back({primitive, PointClass::unknown});
    max_length_ = std::max<std::uint64_t>(max_length_, list_.size());
    count.list_element();
    count(Operation::store, 2);
    count(Operation::store_long, 2);
  }

  SolePrimitivePoints<Count> alone_;
  std::vector<Element> list_;
  std::uint64_t max_length_ = 0;
};

}  // namespace csgsim::software
