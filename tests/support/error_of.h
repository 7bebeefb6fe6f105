#pragma once

#include <string>

#include "hw/base/error.h"

namespace csgsim::testing {

/// What the InputError says that the call ends with; empty if there is none.
template <class Run>
std::string error_of(Run run) {
  try {
    run();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace csgsim::testing
