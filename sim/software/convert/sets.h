// Disjoint sets.
// Used by mesh conversion.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace csgsim::software::convert {

/// Disjoint sets of the numbers from 0; each is represented by its smallest number.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0U); }

  std::uint32_t find(std::uint32_t number) {
    while (parents_[number] != number) number = parents_[number] = parents_[parents_[number]];
    return number;
  }

  void join(std::uint32_t first, std::uint32_t second) {
    first = find(first);
    second = find(second);
    parents_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<std::uint32_t> parents_;
};

}  // namespace csgsim::software::convert
