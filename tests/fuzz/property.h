#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "hw/base/error.h"

namespace csgsim::fuzz {

/// Aborts the process after a violated property, so that the fuzzer keeps the input.
[[noreturn]] void broken(std::string_view invariant);

inline void require(bool holds, std::string_view invariant) {
  if (!holds) broken(invariant);
}

/// Checks that the message is one printable line, which begins with `file` and a colon if a file is given.
void check_message(const InputError& error, std::string_view file = "");

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace csgsim::fuzz

/// Entry point of libFuzzer: checks one input and returns 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
