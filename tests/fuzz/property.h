#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "hw/base/error.h"

namespace csgsim::fuzz {

/// Ends the process where a promise is broken, so that the fuzzer keeps the input.
[[noreturn]] void broken(std::string_view promise);

inline void require(bool holds, std::string_view promise) {
  if (!holds) broken(promise);
}

/// The message has to be one printable line, which begins with `file` and a colon where a file is named.
void check_message(const InputError& error, std::string_view file = "");

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace csgsim::fuzz

/// Looks at one input; returns 0. What libFuzzer calls.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
