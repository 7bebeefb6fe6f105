// Parallel loops with serialized results.
// Used by the studies to measure points.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

#include "hw/base/interruption.h"

namespace csgsim::studies {

/// Calls work(i, finish) for each i below `count` on `threads` threads. Work delivers a result with finish(f), which
/// calls f() for one thread at a time and returns whether to continue. The first exception ends the loop and is
/// rethrown; no f is called after it. The threads are interruptible like the calling thread.
template <class Work>
void parallel_for(std::size_t count, unsigned threads, const Work& work) {
  std::atomic<std::size_t> next = 0;
  std::mutex lock;
  std::exception_ptr failure;
  // An exception of f() is stored before the lock is released, so that no other thread calls an f after it.
  const auto finish = [&](const auto& f) {
    const std::lock_guard guard(lock);
    if (failure) return false;
    try {
      f();
    } catch (...) {
      failure = std::current_exception();
      next = count;
    }
    return !failure;
  };
  const std::stop_token stop = thread_stop_token();
  const auto run_jobs = [&] {
    const Interruptible interruptible(stop);
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i, finish);
      } catch (...) {
        static_cast<void>(finish([] { throw; }));
      }
    }
  };
  {
    std::vector<std::jthread> workers;
    for (std::size_t i = 0; i < std::min<std::size_t>(threads, count); ++i) workers.emplace_back(run_jobs);
  }
  if (failure) std::rethrow_exception(failure);
}

/// Calls measure(i) for each i below `count` on `threads` threads, and finished(result) for one result at a time, in
/// order of completion. Exceptions as in parallel_for.
template <class Measure, class Finished>
void measure_each(std::size_t count, unsigned threads, const Measure& measure, const Finished& finished) {
  parallel_for(count, threads, [&](std::size_t i, const auto& finish) {
    auto result = measure(i);
    static_cast<void>(finish([&] { finished(std::move(result)); }));
  });
}

}  // namespace csgsim::studies
