#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "sim/shell/command_line.h"
#include "sim/shell/usage.h"

namespace csgsim::testing {

using Texts = std::vector<std::string>;

/// Options of a command as a command line of these words says them.
template <class Options>
struct Parsed {
  shell::CommandLine line{"csgsim", "csgsim"};
  shell::Command command = line.add("asked", "asks", "");
  Options options{};

  explicit Parsed(Texts words) {
    options.add_to(command);
    words.insert(words.begin(), "asked");
    static_cast<void>(line.read(words, {}));
  }
};

/// What the UsageError says that the call ends with; empty if there is none.
template <class Call>
std::string usage_error_of(Call call) {
  try {
    call();
  } catch (const shell::UsageError& error) {
    return error.what();
  }
  return "";
}

template <class Options>
std::string option_error(const Texts& words) {
  return usage_error_of([&] { Parsed<Options> parsed(words); });
}

}  // namespace csgsim::testing
