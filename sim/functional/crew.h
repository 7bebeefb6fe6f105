// A pool of threads for short jobs.
// Used by tiles.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace csgsim::functional {

/// Threads that share jobs of some microseconds with the calling thread.
class Crew {
 public:
  /// Executes job number `job` on thread number `thread` of the crew.
  using Work = std::function<void(std::size_t job, unsigned thread)>;

  /// `threads` includes the caller's thread, which has number 0.
  explicit Crew(unsigned threads);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;
  Crew(Crew&&) = delete;
  Crew& operator=(Crew&&) = delete;

  [[nodiscard]] unsigned threads() const { return static_cast<unsigned>(shares_.size()); }

  /// Executes the jobs 0 to `job_count` - 1 in any order and returns when all are done. `work` must not throw.
  void run(std::size_t job_count, const Work& work);

 private:
  void wait_for_jobs(unsigned thread, const std::stop_token& stop);
  void take_jobs(unsigned thread);

  /// Number of a thread's jobs that are not started. The jobs of thread k of n are k, k + n and so on, so that a job
  /// runs on the same thread, with the same caches, in each call. A thread that has finished its own jobs takes over
  /// jobs of others.
  struct alignas(64) Share {
    std::atomic<std::size_t> open{0};
  };
  std::size_t run_jobs_of_share(unsigned share, unsigned thread);

  // A thread that decrements the count of a share sees `work_` as it was set before the count was raised.
  const Work* work_ = nullptr;
  std::vector<Share> shares_;
  std::atomic<std::size_t> done_{0};
  std::atomic<std::uint64_t> calls_{0};  ///< changes when there are new jobs
  std::vector<std::jthread> others_;
};

}  // namespace csgsim::functional
