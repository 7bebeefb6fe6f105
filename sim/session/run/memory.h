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

/// What to say where there is not enough memory to compile a model.
std::string short_of_memory(const std::string& model, std::size_t halfspaces);

/// What to say where a run, of Programs one after another on an array of that shape, fills memory: that of them or of
/// the pixels, whichever is more.
std::string short_of_memory(std::span<const isa::Program> programs, const isa::ArrayShape& array);

/// Calls the function; where there is not enough memory for it, throws an InputError with what say() returns.
template <class Say, class Call>
auto with_memory(Say say, Call call) {
  try {
    return call();
  } catch (const std::bad_alloc&) {
    throw InputError(say());
  }
}

/// The same, for what may be taken smaller.
template <class Call>
auto with_memory_for(const std::string& what, Call call) {
  return with_memory([&] { return fmt::format("there is not enough memory for {}; take a smaller one", what); }, call);
}

template <class Call>
auto with_memory_for_picture(const isa::ArrayShape& array, Call call) {
  return with_memory([&] { return short_of_memory({}, array); }, call);
}

/// For a run: short_of_memory.
template <class Call>
auto with_memory_for_run(std::span<const isa::Program> programs, const isa::ArrayShape& array, Call call) {
  return with_memory([&] { return short_of_memory(programs, array); }, call);
}

/// For what is measured at the same time, on so many threads: `points`, `choices`.
template <class Call>
auto with_memory_for_threads(unsigned threads, const char* what, Call call) {
  const auto say = [&] {
    if (threads == 1) return std::string("there is not enough memory; take a smaller picture or model");
    return fmt::format("there is not enough memory for {} {} at once; take fewer --threads", threads, what);
  };
  return with_memory(say, call);
}

/// Memory that a run takes beside what every process does, about: what a pixel takes was measured with pictures of
/// 4096 x 4096 pixels (docs/performance.md).
std::uint64_t memory_estimate(const machines::Machine& machine, const isa::ArrayShape& picture, std::string_view level);

/// Says on standard error what a run will take if that is much: somebody may rather not begin.
void announce_memory(const machines::Machine& machine, const isa::ArrayShape& picture, std::string_view level);

}  // namespace csgsim::session
