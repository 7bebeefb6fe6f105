// List structure coherence.
// One of the rows of coherences(), also used by csg_buffer.h and sequences.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/software/coherences/one_list.h"
#include "sim/software/cost/operations.h"

namespace csgsim::software {

/// All sequences of surfaces along rays, as a tree of elements: `child` follows along a ray, `sibling` is an
/// alternative on other rays, `parent` precedes (thesis 4.5.3 and algorithm 4.1). The depth of an element is its
/// position along the ray; a ray is inside a primitive if it occurs an odd number of times from the element up to the
/// root.
template <class Count>
class ListElements {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  ListElements(const Tree& tree, Count& count) : alone_(tree, count), roots_(tree.leaf_of.size(), none) {}

  /// The element of a surface after `parent`, or of a first surface if `parent` is none; created if it is new.
  std::uint32_t after(std::uint32_t parent, std::uint32_t primitive, Count& count) {
    count(Operation::compare_long);
    count(Operation::branch);
    if (parent == none) {
      count(Operation::add);
      count(Operation::load_long);
      count(Operation::compare_long);
      count(Operation::branch);
      if (roots_[primitive] == none) roots_[primitive] = add_element(primitive, none, none, count);
      count.list_step();
      return roots_[primitive];
    }
    count(Operation::load_long);
    for (std::uint32_t at = elements_[parent].child; at != none; at = elements_[at].sibling) {
      count.list_step();
      count(Operation::load);
      count(Operation::compare);
      count(Operation::compare_long);
      count(Operation::branch);
      if (elements_[at].primitive == primitive) return at;
      count(Operation::load_long);
      count(Operation::branch_taken);
    }
    // A new branch becomes the first.
    const std::uint32_t child = add_element(primitive, parent, elements_[parent].child, count);
    elements_[parent].child = child;
    return child;
  }

  /// Whether the points after an element are inside; if unknown, `evaluate()` computes it. `is_first`: whether
  /// they are behind one surface only.
  template <class Evaluate>
  bool is_in(std::uint32_t element, bool is_first, const Evaluate& evaluate, Count& count) {
    count(Operation::load);
    count(Operation::compare);
    count(Operation::branch);
    Element& one = elements_[element];
    return is_in_cached(one.kept, is_first, one.primitive, alone_, evaluate, count);
  }

  /// The preceding surface along a ray; none for the first.
  [[nodiscard]] std::uint32_t parent_of(std::uint32_t element) const { return elements_[element].parent; }
  [[nodiscard]] std::uint32_t primitive_of(std::uint32_t element) const { return elements_[element].primitive; }
  /// Counts following pointers back to the first element.
  void count_walk_back(std::size_t elements, Count& count) const {
    count(Operation::load_long, elements);
    count(Operation::load, elements);
    count(Operation::branch_taken, elements);
  }

  /// An element has three pointers, and a primitive with its class.
  [[nodiscard]] std::uint64_t words() const {
    return alone_.words() + roots_.size() + 4 * std::uint64_t{elements_.size()};
  }

 private:
  struct Element {
    std::uint32_t primitive;
    std::uint32_t parent;
    std::uint32_t sibling;
    std::uint32_t child;
    PointClass kept;
  };

  std::uint32_t add_element(std::uint32_t primitive, std::uint32_t parent, std::uint32_t sibling, Count& count) {
    elements_.push_back({primitive, parent, sibling, none, PointClass::unknown});
    count.list_element();
    count(Operation::call);
    count(Operation::store, 2);
    count(Operation::store_long, 4);
    count(Operation::add_long);
    count(Operation::come_back);
    return static_cast<std::uint32_t>(elements_.size() - 1);
  }

  SolePrimitivePoints<Count> alone_;
  std::vector<std::uint32_t> roots_;  ///< per primitive, the element of sequences that begin with it
  std::vector<Element> elements_;
};

/// Evaluates every sequence once, ray by ray.
template <class Count>
class ListStructure {
 public:
  ListStructure(const Tree& tree, Count& count) : elements_(tree, count) {}

  void begin_ray() { at_ = ListElements<Count>::none; }

  template <class Evaluate>
  bool is_in(std::span<const Event> events, std::size_t begin, std::size_t end, const Evaluate& evaluate,
             Count& count) {
    for (std::size_t i = begin; i < end; ++i) at_ = elements_.after(at_, events[i].primitive(), count);
    return elements_.is_in(at_, is_first_alone(begin, end), evaluate, count);
  }

  [[nodiscard]] std::uint64_t words() const { return elements_.words(); }

 private:
  ListElements<Count> elements_;
  std::uint32_t at_ = ListElements<Count>::none;
};

}  // namespace csgsim::software
