#include "sim/functional/crew.h"

#include <atomic>
#include <chrono>
#include <thread>

#include "tests/support/test.h"

using csgsim::functional::Crew;

TEST_CASE("a crew runs each job exactly once for any number of jobs and threads") {
  for (const unsigned threads : {1U, 2U, 3U, 8U}) {
    CAPTURE(threads);
    Crew crew(threads);
    REQUIRE(crew.threads() == threads);
    for (const std::size_t jobs : {0U, 1U, 2U, 64U, 1U, 500U, 7U}) {
      for (int call = 0; call < 20; ++call) {
        std::vector<int> done(jobs);
        std::vector<std::size_t> of_thread(threads);
        crew.run(jobs, [&](std::size_t job, unsigned thread) {
          ++done[job];
          ++of_thread[thread];
        });
        std::size_t all = 0;
        for (const std::size_t count : of_thread) all += count;
        REQUIRE(done == std::vector<int>(jobs, 1));
        REQUIRE(all == jobs);
      }
    }
  }
}

TEST_CASE("a sleeping crew runs new jobs and an unused crew can be destroyed") {
  const Crew idle(4);
  Crew crew(2);
  for (int call = 0; call < 3; ++call) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    std::atomic<std::size_t> sum{0};
    crew.run(10, [&](std::size_t job, unsigned) { sum += job; });
    CHECK(sum == 45);
  }
}
