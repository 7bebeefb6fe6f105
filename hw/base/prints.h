#pragma once

#include <string_view>

namespace csgsim {

/// Prints text of a result on standard output, as it is.
void print_text(std::string_view text);

/// While it lives, what this thread prints so goes nowhere: its caller gets the result itself.
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
