#pragma once

#include <string>

#include "hw/base/error.h"
#include "sim/session/options/option_list.h"
#include "sim/session/options/usage.h"

namespace csgsim::session {

/// The text is as the function wants it, or what is wrong with it.
template <class Parse>
Check is_read_by(Parse parse) {
  return [parse](const std::string& text) -> std::string {
    try {
      parse(text);
    } catch (const InputError& error) {
      return error.what();
    } catch (const UsageError& error) {
      return error.what();
    }
    return {};
  };
}

/// Calls a function that looks at what an option says: what is wrong with that is wrong with the command line.
template <class Call>
auto for_option(const std::string& option, Call call) {
  try {
    return call();
  } catch (const InputError& error) {
    throw UsageError(option, error.what());
  }
}

}  // namespace csgsim::session
