#pragma once

#include <string>

#include "hw/base/error.h"

namespace csgsim::testing {

/// Returns the text of the InputError that the call throws; empty if it throws none.
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
