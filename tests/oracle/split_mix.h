#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace csgsim::testing {

/// SplitMix64: a small generator with the same numbers on every computer.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t below(std::uint64_t limit) {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return (z ^ (z >> 31U)) % limit;
  }

  /// A random element.
  template <class Value>
  Value one_of(std::initializer_list<Value> values) {
    return values.begin()[static_cast<std::size_t>(below(values.size()))];
  }

  double unit() { return static_cast<double>(below(1'000'001)) / 1'000'000.0; }

 private:
  std::uint64_t state_;
};

}  // namespace csgsim::testing
