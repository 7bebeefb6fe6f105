// Prints results to standard output, unless the thread silences them.
// Used by host/setup, sim/studies and sim/python.
#pragma once

#include <string_view>

namespace csgsim {

/// Prints text of a result to standard output, unchanged.
void print_text(std::string_view text);

/// Discards what this thread passes to print_text() during the object's lifetime, for callers that only use a
/// function's return value.
class SilentPrints {
 public:
  SilentPrints() noexcept;
  ~SilentPrints();
  SilentPrints(const SilentPrints&) = delete;
  SilentPrints& operator=(const SilentPrints&) = delete;

 private:
  bool before_;
};

}  // namespace csgsim
