#pragma once

#include <string>

#include "hw/base/error.h"
#include "sim/shell/command_line.h"
#include "sim/shell/usage.h"

namespace csgsim::shell {

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

}  // namespace csgsim::shell
