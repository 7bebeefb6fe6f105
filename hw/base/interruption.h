// Cooperative cancellation of long work.
// Used by sim.
#pragma once

#include <exception>
#include <stop_token>

namespace csgsim {

/// Thrown when work ends early because a stop was requested. Not an error: the input may be valid.
class Interrupted : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "the work was interrupted"; }
};

/// Makes the work of this thread interruptible by `stop` during the object's lifetime.
class Interruptible {
 public:
  explicit Interruptible(std::stop_token stop) noexcept;
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  friend void throw_if_interrupted();
  friend std::stop_token thread_stop_token();

  std::stop_token stop_;
  const Interruptible* before_;
};

/// Throws Interrupted if a stop of this thread's work was requested. Called where no state is lost: between the
/// instructions of a run, and between steps of reading and compiling.
void throw_if_interrupted();

/// The current thread's stop_token, for threads that share its work; empty if the work is not interruptible.
std::stop_token thread_stop_token();

}  // namespace csgsim
