// Memory estimates, and messages for exhausted memory.
// Used by sim/session, sim/app, sim/studies and sim/viewer.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <new>
#include <span>
#include <string>
#include <string_view>

#include "hw/base/error.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::session {

/// The message if memory does not suffice to compile a model.
std::string out_of_memory_message(const std::string& model, std::size_t halfspaces);

/// The message if memory does not suffice for a run of Programs, one after another, on an array of that shape. It
/// blames the Programs or the pixels, whichever take more.
std::string out_of_memory_message(std::span<const isa::Program> programs, const isa::ArrayShape& array);

/// Calls the function. If memory does not suffice, throws an InputError with the text that `make_message` returns.
template <class MakeMessage, class Call>
auto with_memory(MakeMessage make_message, Call call) {
  try {
    return call();
  } catch (const std::bad_alloc&) {
    throw InputError(make_message());
  }
}

/// Calls the function. If memory does not suffice for `what`, throws an InputError that suggests a smaller model.
template <class Call>
auto with_memory_for(const std::string& what, Call call) {
  return with_memory([&] { return fmt::format("there is not enough memory for {}; use a smaller model", what); }, call);
}

/// Calls the function, which creates a picture of the array. If memory does not suffice, throws an InputError with the
/// message of out_of_memory_message().
template <class Call>
auto with_memory_for_picture(const isa::ArrayShape& array, Call call) {
  return with_memory([&] { return out_of_memory_message({}, array); }, call);
}

/// Calls the function, which runs Programs. If memory does not suffice, throws an InputError with the message of
/// out_of_memory_message().
template <class Call>
auto with_memory_for_run(std::span<const isa::Program> programs, const isa::ArrayShape& array, Call call) {
  return with_memory([&] { return out_of_memory_message(programs, array); }, call);
}

/// Calls the function, which works on several threads. If memory does not suffice, throws an InputError that suggests
/// fewer threads; `what` names the items of the work, as in `points`.
template <class Call>
auto with_memory_for_threads(unsigned threads, const char* what, Call call) {
  const auto say = [&] {
    if (threads == 1) return std::string("there is not enough memory; use a smaller picture or model");
    return fmt::format("there is not enough memory for {} {} at once; take fewer --threads", threads, what);
  };
  return with_memory(say, call);
}

/// Estimate of the memory of a run, in bytes, without the base memory of a process. The bytes per pixel were measured
/// with pictures of 4096 x 4096 pixels (docs/performance.md).
std::uint64_t memory_estimate(const machines::Machine& machine, const isa::ArrayShape& picture, std::string_view level);

/// Announces the memory of a large run on standard error, so that the user can stop it early.
void announce_memory(const machines::Machine& machine, const isa::ArrayShape& picture, std::string_view level);

}  // namespace csgsim::session
