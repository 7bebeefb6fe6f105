#include <hwy/targets.h>

#include <cstdint>
#include <stdexcept>
#include <string>

#include "hw/base/module.h"

// What rooms with vector code ask of Highway's library, in its stead: it is opened when it is first asked. A program
// that has it loaded from the start waits 3 ms while it times its clock, which is more than many commands take.
// A program that is linked with the library itself gets these from there.

namespace {

/// A function of the library, which is never closed.
template <class Function>
Function* function_named(const char* symbol) {
  const csgsim::OpenedModule opened = csgsim::open_module(CSGSIM_HIGHWAY_LIBRARY, symbol);
  if (opened.symbol == nullptr)
    throw std::runtime_error("Highway's library, " CSGSIM_HIGHWAY_LIBRARY ", cannot be opened: " + opened.error);
  return reinterpret_cast<Function*>(const_cast<void*>(opened.symbol));
}

}  // namespace

namespace hwy {

std::int64_t SupportedTargets() {
  static const auto theirs = function_named<std::int64_t()>("_ZN3hwy16SupportedTargetsEv");
  return theirs();
}

ChosenTarget& GetChosenTarget() {
  static const auto theirs = function_named<ChosenTarget&()>("_ZN3hwy15GetChosenTargetEv");
  return theirs();
}

}  // namespace hwy
