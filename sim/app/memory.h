#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <new>
#include <string>
#include <string_view>

#include "hw/base/error.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::app {

/// Calls the function; where there is not enough memory for it, throws an InputError that says for what.
template <class Call>
auto with_memory_for(const std::string& what, Call call) {
  try {
    return call();
  } catch (const std::bad_alloc&) {
    throw InputError(fmt::format("there is not enough memory for {}; take a smaller one", what));
  }
}

/// The same for a picture.
template <class Call>
auto with_memory_for_picture(const isa::ArrayShape& shape, Call call) {
  return with_memory_for(
      fmt::format("a picture of {} x {} pixels of {} bits", shape.width, shape.height, shape.memory_bits), call);
}

/// Memory that a run takes beside what every process does, about: what a pixel takes was measured with pictures of
/// 4096 x 4096 pixels (docs/speed.md).
std::uint64_t memory_estimate(const machines::Machine& machine, const isa::ArrayShape& picture, std::string_view level);

/// Says on standard error what a run will take if that is much: somebody may rather not begin.
void announce_memory(const machines::Machine& machine, const isa::ArrayShape& picture, std::string_view level);

}  // namespace csgsim::app
