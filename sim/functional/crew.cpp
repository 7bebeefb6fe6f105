#include "sim/functional/crew.h"

namespace csgsim::functional {

namespace {

/// Number of polls of the value before the thread sleeps: a run usually has the next jobs within microseconds, and
/// waking a thread takes longer.
constexpr int polls = 2000;

template <class Number>
void wait_while(const std::atomic<Number>& value, Number old) {
  for (int i = 0; i < polls; ++i) {
    if (value.load(std::memory_order_acquire) != old) return;
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

Crew::Crew(unsigned threads) : shares_(threads) {
  for (unsigned thread = 1; thread < threads; ++thread)
    others_.emplace_back([this, thread](const std::stop_token& stop) { wait_for_jobs(thread, stop); });
}

Crew::~Crew() {
  for (std::jthread& other : others_) other.request_stop();
  calls_.fetch_add(1, std::memory_order_release);
  calls_.notify_all();
}

void Crew::run(std::size_t job_count, const Work& work) {
  if (job_count == 0) return;
  work_ = &work;
  done_.store(0, std::memory_order_relaxed);
  for (std::size_t share = 0; share < shares_.size(); ++share)
    shares_[share].open.store((job_count + shares_.size() - 1 - share) / shares_.size(), std::memory_order_release);
  if (job_count > 1 && !others_.empty()) {
    calls_.fetch_add(1, std::memory_order_release);
    calls_.notify_all();
  }
  take_jobs(0);
  for (std::size_t done = done_.load(std::memory_order_acquire); done != job_count;
       done = done_.load(std::memory_order_acquire))
    wait_while(done_, done);
}

void Crew::take_jobs(unsigned thread) {
  const auto shares = static_cast<unsigned>(shares_.size());
  for (unsigned i = 0; i < shares; ++i) {
    const std::size_t done = run_jobs_of_share((thread + i) % shares, thread);
    if (done == 0) continue;
    done_.fetch_add(done, std::memory_order_acq_rel);
    done_.notify_one();
  }
}

std::size_t Crew::run_jobs_of_share(unsigned share, unsigned thread) {
  std::atomic<std::size_t>& jobs = shares_[share].open;
  std::size_t done = 0;
  for (std::size_t open = jobs.load(std::memory_order_acquire); open > 0; open = jobs.load(std::memory_order_acquire)) {
    if (!jobs.compare_exchange_weak(open, open - 1, std::memory_order_acq_rel, std::memory_order_acquire)) continue;
    (*work_)((open - 1) * shares_.size() + share, thread);
    ++done;
  }
  return done;
}

void Crew::wait_for_jobs(unsigned thread, const std::stop_token& stop) {
  std::uint64_t seen = 0;
  while (!stop.stop_requested()) {
    wait_while(calls_, seen);
    seen = calls_.load(std::memory_order_acquire);
    take_jobs(thread);
  }
}

}  // namespace csgsim::functional
