#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace csgsim::studies {

/// Calls measure(i) for i below `count` on that many threads, and finished(result) with each result, one at a time, in
/// the order in which they are done. The first exception, of either, ends it and is thrown again; finished() is not
/// called after it.
template <class Measure, class Finished>
void measure_each(std::size_t count, unsigned threads, const Measure& measure, const Finished& finished) {
  std::atomic<std::size_t> next = 0;
  std::mutex lock;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      std::optional<std::invoke_result_t<const Measure&, std::size_t>> result;
      std::exception_ptr thrown;
      try {
        result = measure(i);
      } catch (...) {
        thrown = std::current_exception();
      }
      // What finished() throws is kept before the lock is let go: nobody else calls it after that.
      const std::lock_guard guard(lock);
      if (failure) return;
      try {
        if (thrown) std::rethrow_exception(thrown);
        finished(std::move(*result));
      } catch (...) {
        failure = std::current_exception();
        next = count;
      }
    }
  };
  {
    std::vector<std::jthread> workers;
    for (std::size_t i = 0; i < std::min<std::size_t>(threads, count); ++i) workers.emplace_back(work);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace csgsim::studies
