#pragma once

#include <exception>
#include <stop_token>

namespace csgsim {

/// Work ended since somebody asked it to stop. No error: nothing is wrong with what it worked on.
class Interrupted : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "the work was interrupted"; }
};

/// While it lives, this thread's work looks now and then whether it is to stop.
class Interruptible {
 public:
  explicit Interruptible(std::stop_token stop) noexcept;
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  friend void end_if_interrupted();
  friend std::stop_token stop_of_thread();

  std::stop_token stop_;
  const Interruptible* before_;
};

/// Throws Interrupted where this thread's work is to stop. Called where nothing is lost by it: between instructions of
/// a run, between steps of reading and compiling.
void end_if_interrupted();

/// By what this thread's work is asked to stop, for threads that share it; by nothing where nobody does.
std::stop_token stop_of_thread();

}  // namespace csgsim
