#pragma once

#include <fmt/format.h>

#include <new>

#include "hw/base/error.h"
#include "hw/isa/program.h"

namespace csgsim::app {

/// Calls the function; where there is not enough memory for it, throws an InputError that says for which picture.
template <class Call>
auto with_memory_for(const isa::ArrayShape& shape, Call call) {
  try {
    return call();
  } catch (const std::bad_alloc&) {
    throw InputError(
        fmt::format("there is not enough memory for a picture of {} x {} pixels of {} bits; take a smaller one",
                    shape.width, shape.height, shape.memory_bits));
  }
}

}  // namespace csgsim::app
