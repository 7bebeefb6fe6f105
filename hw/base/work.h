// Counts the work of reading and compiling a model against a limit.
// Used throughout host and by sim/software.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "hw/base/error.h"

namespace csgsim {

/// The work limit was reached.
class WorkError : public InputError {
 public:
  using InputError::InputError;
};

/// Counts the steps of reading or compiling a model against a limit. A few large numbers in a small file can cause
/// practically endless work, which cannot be predicted from the size of the model. One step costs about as much as
/// testing a point against a plane. Steps are counted, not timed, so that a model accepted on one computer is accepted
/// on all. Copies share one count.
class Work {
 public:
  Work() = default;  ///< unlimited
  explicit Work(std::uint64_t limit);

  /// Throws WorkError if the limit is exceeded. `activity` completes the message, as in "cutting a solid into convex
  /// pieces".
  void charge(std::uint64_t steps, std::string_view activity) const;

  /// A Work object with the same limit and its own count of 0.
  [[nodiscard]] Work with_zero_count() const;

  /// Steps charged until now; always 0 if there is no limit.
  [[nodiscard]] std::uint64_t done() const;

 private:
  struct Count {
    std::uint64_t done = 0;
    std::uint64_t limit = 0;
  };

  std::shared_ptr<Count> count_;
};

}  // namespace csgsim
