// Adapters from parsers to option checks.
// Used by sim/session, sim/app and sim/studies.
#pragma once

#include <string>

#include "hw/base/error.h"
#include "sim/session/options/option_list.h"
#include "sim/session/options/usage.h"

namespace csgsim::session {

/// A check that calls the parser and returns its error message.
template <class Parse>
Check check_by_parsing(Parse parse) {
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

/// Calls a function that parses an option's text. Its InputError becomes a UsageError of that option.
template <class Call>
auto for_option(const std::string& option, Call call) {
  try {
    return call();
  } catch (const InputError& error) {
    throw UsageError(option, error.what());
  }
}

}  // namespace csgsim::session
