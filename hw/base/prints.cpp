#include "hw/base/prints.h"

#include <cstdio>
#include <utility>

namespace csgsim {

namespace {

thread_local bool is_silenced = false;

}  // namespace

void print_text(std::string_view text) {
  if (!is_silenced) std::fwrite(text.data(), 1, text.size(), stdout);
}

SilentPrints::SilentPrints() noexcept : before_(std::exchange(is_silenced, true)) {}

SilentPrints::~SilentPrints() { is_silenced = before_; }

}  // namespace csgsim
