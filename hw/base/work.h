#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "hw/base/error.h"

namespace csgsim {

/// Work has reached its limit.
class WorkError : public InputError {
 public:
  using InputError::InputError;
};

/// Counts the steps that a model takes to read or to compile, against a limit. Some numbers in a small file ask for
/// work that does not end in any time worth waiting for; no count of its parts, known beforehand, tells them all. A
/// step is about as much as holding one point against one plane, and is counted, not timed: a model that is drawn on
/// one machine is drawn on all. Copies count together.
class Work {
 public:
  Work() = default;  ///< without a limit
  explicit Work(std::uint64_t limit);

  /// Throws WorkError where the limit is passed, which says what was done: "cutting a solid into convex pieces".
  void charge(std::uint64_t steps, std::string_view doing) const;

  /// Nothing counted yet, and the same limit.
  [[nodiscard]] Work afresh() const;

  /// So far; 0 without a limit.
  [[nodiscard]] std::uint64_t done() const;

 private:
  struct Count {
    std::uint64_t done = 0;
    std::uint64_t limit = 0;
  };

  std::shared_ptr<Count> count_;
};

}  // namespace csgsim
