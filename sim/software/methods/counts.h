#pragma once

#include <cstdint>

#include "sim/software/cost/operations.h"

namespace csgsim::software {

/// What a method did, in the terms of the field. Words have 32 bits.
struct Counts {
  std::uint64_t points = 0;         ///< of rays that were classified; events at one depth are one
  std::uint64_t evaluations = 0;    ///< of the tree, for a point of a ray
  std::uint64_t precomputed = 0;    ///< evaluations before the first ray
  std::uint64_t looked_up = 0;      ///< points whose class was kept from before
  std::uint64_t pruned_nodes = 0;   ///< nodes that were looked at to prune trees
  std::uint64_t node_visits = 0;    ///< nodes of trees, or words of strings of bits, that were looked at
  std::uint64_t early_outs = 0;     ///< operands that were left out since the other one decided
  std::uint64_t list_steps = 0;     ///< elements of lists that were looked at
  std::uint64_t list_elements = 0;  ///< elements that were made
  std::uint64_t ties = 0;           ///< points at which several surfaces could be the seen one
  std::uint64_t words = 0;          ///< of memory, at most at one time
  Operations operations;            ///< of classification: rays and events are there before
  Operations traversal;             ///< of these, the traversal's own: its flips and evaluations
};

/// What methods are compiled with to count.
class CountingMethod : public Counting {
 public:
  void point() { ++counts_.points; }
  void evaluation() { ++counts_.evaluations; }
  void precomputation() { ++counts_.precomputed; }
  void look_up() { ++counts_.looked_up; }
  void prune(std::uint64_t nodes) { counts_.pruned_nodes += nodes; }
  void visit(std::uint64_t nodes = 1) { counts_.node_visits += nodes; }
  void early_out() { ++counts_.early_outs; }
  void list_step() { ++counts_.list_steps; }
  void list_element() { ++counts_.list_elements; }
  void tie() { ++counts_.ties; }
  /// Does what is part of a traversal. Returns what it returns.
  template <class Step>
  auto traverse(const Step& step) {
    const Operations before = done();
    const auto result = step();
    Operations added = done();
    added -= before;
    counts_.traversal += added;
    return result;
  }

  [[nodiscard]] Counts counts_so_far() const {
    Counts all = counts_;
    all.operations = done();
    return all;
  }

 private:
  Counts counts_;
};

/// What they are compiled with to be fast.
class UncountedMethod : public Uncounted {
 public:
  void point() const {}
  void evaluation() const {}
  void precomputation() const {}
  void look_up() const {}
  void prune(std::uint64_t /*nodes*/) const {}
  void visit(std::uint64_t /*nodes*/ = 1) const {}
  void early_out() const {}
  void list_step() const {}
  void list_element() const {}
  void tie() const {}
  template <class Step>
  auto traverse(const Step& step) const {
    return step();
  }
  [[nodiscard]] Counts counts_so_far() const { return {}; }
};

}  // namespace csgsim::software
