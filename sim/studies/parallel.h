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

/// Calls work(i, finish) for i below `count` on that many threads; work hands what is done on by finish(f), which calls
/// f(), one at a time, and tells whether to go on. The first exception ends it and is thrown again; no f is called
/// after it. The threads can be interrupted as this one.
template <class Work>
void share_out(std::size_t count, unsigned threads, const Work& work) {
  std::atomic<std::size_t> next = 0;
  std::mutex lock;
  std::exception_ptr failure;
  // What f() throws is kept before the lock is let go: nobody else calls one after that.
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
  const std::stop_token stop = stop_of_thread();
  const auto take = [&] {
    const Interruptible looks_for(stop);
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
    for (std::size_t i = 0; i < std::min<std::size_t>(threads, count); ++i) workers.emplace_back(take);
  }
  if (failure) std::rethrow_exception(failure);
}

/// Calls measure(i) for i below `count` on that many threads, and finished(result) with each result, one at a time, in
/// the order in which they are done. Exceptions as above.
template <class Measure, class Finished>
void measure_each(std::size_t count, unsigned threads, const Measure& measure, const Finished& finished) {
  share_out(count, threads, [&](std::size_t i, const auto& finish) {
    auto result = measure(i);
    static_cast<void>(finish([&] { finished(std::move(result)); }));
  });
}

}  // namespace csgsim::studies
