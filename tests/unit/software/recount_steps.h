#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "sim/software/cost/operations.h"

namespace csgsim::processors {

inline Operations operator+(Operations one, const Operations& other) { return one += other; }

}  // namespace csgsim::processors

namespace csgsim::testing {

using software::Operation;
using software::Operations;

/// An operation with a repeat count.
struct Step {
  Operation kind;
  std::uint64_t times = 1;

  Step(Operation one) : kind(one) {}
  Step(Operation one, std::uint64_t many) : kind(one), times(many) {}
};

/// Operations of a part of an algorithm.
inline Operations steps(std::initializer_list<Step> all) {
  Operations operations;
  for (const Step& step : all) operations.counts[static_cast<std::size_t>(step.kind)] += step.times;
  return operations;
}

/// Arithmetic of longs in fixed point: a product takes four products of words and their sums; a quotient has two
/// digits.
inline Operations products(std::uint64_t times) {
  return times * steps({{Operation::multiply, 4}, {Operation::add_long, 3}, {Operation::move, 2}});
}
inline Operations quotients(std::uint64_t times) {
  return times * steps({{Operation::divide, 2}, {Operation::multiply, 2}, {Operation::add_long, 2}});
}
inline Operations comparisons(std::uint64_t times) {
  return times * steps({Operation::load_long, Operation::compare_long, Operation::branch});
}
/// A call and its return.
inline Operations calls(std::uint64_t times) { return times * steps({Operation::call, Operation::come_back}); }
/// Comparisons of a library's sort; each moves a long.
inline Operations sorted(std::uint64_t compared) {
  return compared *
         steps({{Operation::load_long, 2}, Operation::compare_long, Operation::branch_taken, Operation::store_long});
}

/// Corners, planes and edges are transformed into the picture: a corner takes nine products and two quotients, a plane
/// six and three, an edge two products; a product of longs is four of words, and a quotient has two digits.
inline Operations transformed(std::uint64_t corners, std::uint64_t planes, std::uint64_t edges) {
  Operations sum = (9 * corners + 6 * planes + 2 * edges) *
                   steps({{Operation::multiply, 4}, {Operation::add_long, 5}, {Operation::load_long, 2}});
  sum += (2 * corners + 3 * planes) *
         steps({{Operation::multiply, 2}, {Operation::divide, 2}, {Operation::add_long, 2}, {Operation::load_long, 2}});
  sum += steps({{Operation::store_long, 3 * corners + 6 * planes + 6 * edges}});
  sum += calls(corners + planes + edges);
  return sum;
}

}  // namespace csgsim::testing
