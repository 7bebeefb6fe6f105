// Counts of classification methods.
// Used by the methods and by the studies of software.
#pragma once

#include <cstdint>

#include "sim/software/cost/operations.h"

namespace csgsim::software {

/// Counts of a method. Words have 32 bits.
struct Counts {
  std::uint64_t points = 0;         ///< classified points of rays; events at the same depth are one point
  std::uint64_t evaluations = 0;    ///< evaluations of the tree, each for a point of a ray
  std::uint64_t precomputed = 0;    ///< evaluations before the first ray
  std::uint64_t looked_up = 0;      ///< points whose class was already stored
  std::uint64_t pruned_nodes = 0;   ///< nodes visited to prune trees
  std::uint64_t node_visits = 0;    ///< visited nodes of trees, or words of bit strings
  std::uint64_t early_outs = 0;     ///< operands skipped because the other one decides
  std::uint64_t list_steps = 0;     ///< visited list elements
  std::uint64_t list_elements = 0;  ///< created list elements
  std::uint64_t ties = 0;           ///< points with several candidates for the visible surface
  std::uint64_t words = 0;          ///< maximum memory in use at one time
  Operations operations;            ///< operations of classification, without ray intersection and sorting
  Operations traversal;             ///< subset of `operations`: flips and evaluations by the traversal
};

/// Counter of a classification method: operations, points, evaluations and visits. UncountedMethod ignores them.
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
  /// Runs a step and attributes its operations to the traversal. Returns the step's result.
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

/// Counter with the functions of CountingMethod that counts nothing, for full speed.
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
