#include "hw/base/work.h"

#include "tests/support/test.h"

using namespace csgsim;

TEST_CASE("an unlimited Work object accepts every charge and counts none") {
  const Work work;
  work.charge(~std::uint64_t{0}, "counting");
  work.charge(~std::uint64_t{0}, "counting");
  CHECK(work.done() == 0);
}

TEST_CASE("Work accepts charges up to its limit and names the activity that exceeds it") {
  const Work work(2'500'000);
  work.charge(2'000'000, "counting");
  work.charge(500'000, "counting");
  CHECK(work.done() == 2'500'000);
  CHECK(testing::error_of([&] { work.charge(1, "folding paper"); }) ==
        "folding paper needs more work than the limit of 2.5 million steps; use fewer or coarser parts in "
        "the model, or raise --limit");
}

TEST_CASE("Work rejects a charge that would overflow its sum") {
  const Work work(10);
  work.charge(5, "counting");
  CHECK_THROWS_AS(work.charge(~std::uint64_t{0}, "counting"), WorkError);
}

TEST_CASE("Work rejects every charge after its limit was exceeded") {
  const Work work(10);
  CHECK_THROWS_AS(work.charge(11, "counting"), WorkError);
  CHECK_THROWS_AS(work.charge(1, "counting"), WorkError);
}

TEST_CASE("copies of a Work object share one count") {
  const Work work(10);
  const Work copy = work;  // NOLINT(performance-unnecessary-copy-initialization): the test needs a copy
  copy.charge(6, "counting");
  CHECK(work.done() == 6);
  CHECK_THROWS_AS(work.charge(5, "counting"), WorkError);
}
