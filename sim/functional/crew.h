#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace csgsim::functional {

/// Threads that share out jobs of some microseconds, with the thread that has them.
class Crew {
 public:
  /// Does the job of that number, on that thread of the crew.
  using Work = std::function<void(std::size_t job, unsigned thread)>;

  /// So many threads, the caller's among them, of number 0.
  explicit Crew(unsigned threads);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;
  Crew(Crew&&) = delete;
  Crew& operator=(Crew&&) = delete;

  [[nodiscard]] unsigned threads() const { return static_cast<unsigned>(shares_.size()); }

  /// Does jobs 0 to `jobs` - 1 in any order and returns when all are done. `work` must not throw.
  void run(std::size_t jobs, const Work& work);

 private:
  void stand_by(unsigned thread, const std::stop_token& stop);
  void take_jobs(unsigned thread);

  /// Jobs that nobody has begun: of thread k of n, k, k + n and so on, so that a job has the same thread's caches call
  /// after call. Who is done with its own takes others'.
  struct alignas(64) Share {
    std::atomic<std::size_t> open{0};
  };
  std::size_t take_from(unsigned share, unsigned thread);

  // A thread that takes the count of a share down sees the work that was there before the count was raised.
  const Work* work_ = nullptr;
  std::vector<Share> shares_;
  std::atomic<std::size_t> done_{0};
  std::atomic<std::uint64_t> calls_{0};  ///< changes when there are new jobs
  std::vector<std::jthread> others_;
};

}  // namespace csgsim::functional
