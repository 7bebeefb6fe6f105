#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/software/coherences/first_point.h"
#include "sim/software/cost/operations.h"

namespace csgsim::software {

/// What is known of the points behind an event.
enum class Class : std::uint8_t { unknown, out, in };

constexpr Class class_of(bool is_in) { return is_in ? Class::in : Class::out; }

/// The class that is kept; where it is unknown, it is looked up for a point behind one first surface alone, else
/// `evaluate()` finds it out.
template <class Count, class Evaluate>
bool is_in_kept(Class& kept, bool is_first, std::uint32_t primitive, const Alone<Count>& alone,
                const Evaluate& evaluate, Count& count) {
  if (kept != Class::unknown) {
    count.look_up();
    return kept == Class::in;
  }
  const bool is_in = is_first ? alone.is_in(primitive, count) : evaluate();
  kept = class_of(is_in);
  count(Operation::store);
  return is_in;
}

/// The list of the last ray's surfaces and classes is read again as long as surfaces come in the same order; from the
/// first other one on it is made anew (thesis 4.5.2). First points are looked up.
///
/// Points between events at one depth are no points: their class stays unknown until a ray has them apart.
template <class Count>
class OneList {
 public:
  OneList(const Tree& tree, Count& count) : alone_(tree, count) {}

  void begin_ray() {}

  template <class Evaluate>
  bool is_in(std::span<const Event> events, std::size_t begin, std::size_t end, const Evaluate& evaluate,
             Count& count) {
    for (std::size_t i = begin; i < end; ++i) follow(events[i].primitive(), i, count);
    Class& kept = list_[end - 1].kept;
    count(Operation::load);
    count(Operation::compare);
    count(kept == Class::unknown ? Operation::branch_taken : Operation::branch);
    return is_in_kept(kept, is_first_alone(begin, end), events[0].primitive(), alone_, evaluate, count);
  }

  /// An element has a pointer to the next, and a primitive with its class.
  [[nodiscard]] std::uint64_t words() const { return alone_.words() + 2 * most_; }

 private:
  struct Element {
    std::uint32_t primitive;
    Class kept;
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
    list_.push_back({primitive, Class::unknown});
    most_ = std::max<std::uint64_t>(most_, list_.size());
    count.list_element();
    count(Operation::store, 2);
    count(Operation::store_long, 2);
  }

  Alone<Count> alone_;
  std::vector<Element> list_;
  std::uint64_t most_ = 0;
};

}  // namespace csgsim::software
