#pragma once

#include <functional>
#include <string>

#include "hw/base/error.h"

namespace csgsim::app {

/// For CLI11: the text is as the function wants it, or what is wrong with it.
template <class Parse>
std::function<std::string(const std::string&)> is_read_by(Parse parse) {
  return [parse](const std::string& text) -> std::string {
    try {
      parse(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
}

}  // namespace csgsim::app
