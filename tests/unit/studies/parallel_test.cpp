#include "sim/studies/parallel.h"

#include <doctest/doctest.h>

#include <atomic>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <stop_token>

#include "hw/base/interruption.h"

using namespace csgsim;

namespace {

constexpr std::size_t many = 64;

}  // namespace

TEST_CASE("every point of a study is measured once and delivered once") {
  std::set<std::size_t> handed_on;
  studies::measure_each(
      many, 4, [](std::size_t i) { return i; }, [&](std::size_t i) { handed_on.insert(i); });
  CHECK(handed_on.size() == many);
  CHECK(*handed_on.rbegin() == many - 1);
}

TEST_CASE("no result of a study is delivered after its receiver has failed") {
  for (int round = 0; round < 2000; ++round) {
    int calls = 0;
    const auto fails = [&](std::size_t) {
      ++calls;
      throw std::runtime_error("full");
    };
    CHECK_THROWS_AS(studies::measure_each(
                        many, 4, [](std::size_t i) { return i; }, fails),
                    std::runtime_error);
    REQUIRE(calls == 1);
  }
}

TEST_CASE("an exception of one point's measurement ends the loop and is rethrown") {
  std::atomic<int> measured = 0;
  const auto throws_at_once = [&](std::size_t i) {
    ++measured;
    if (i == 0) throw std::runtime_error("first");
    return i;
  };
  CHECK_THROWS_WITH_AS(studies::measure_each(1000, 1, throws_at_once, [](std::size_t) {}), "first", std::runtime_error);
  CHECK(measured == 1);
}

TEST_CASE("interrupting the coordinating thread of a study interrupts its workers") {
  std::stop_source source;
  const Interruptible looks_for(source.get_token());
  std::atomic<unsigned> begun = 0;
  const auto measure = [&](std::size_t point) {
    if (++begun == 3) source.request_stop();
    throw_if_interrupted();
    return point;
  };
  CHECK_THROWS_AS(studies::measure_each(1000, 2, measure, [](std::size_t) {}), Interrupted);
  CHECK(begun <= 5);
}
