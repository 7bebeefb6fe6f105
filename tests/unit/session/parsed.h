#pragma once

#include "sim/session/options/option_list.h"
#include "sim/session/options/usage.h"
#include "tests/support/test.h"

namespace csgsim::testing {

using Texts = std::vector<std::string>;

/// A request parsed from the words of a command line.
template <class Options>
struct Parsed {
  session::OptionList list{"asked"};
  Options options{};

  explicit Parsed(const Texts& words) {
    options.add_to(list);
    list.give_words(words);
    list.check_and_apply();
  }
};

/// Returns the message of the call's UsageError; empty if there is none.
template <class Call>
std::string usage_error_of(Call call) {
  try {
    call();
  } catch (const session::UsageError& error) {
    return error.what();
  }
  return "";
}

template <class Options>
std::string option_error(const Texts& words) {
  return usage_error_of([&] { Parsed<Options> parsed(words); });
}

}  // namespace csgsim::testing
