#pragma once

#include "sim/session/options/option_list.h"
#include "sim/session/options/usage.h"
#include "tests/support/test.h"

namespace csgsim::testing {

using Texts = std::vector<std::string>;

/// A request, as words of a command line say it.
template <class Options>
struct Parsed {
  session::OptionList list{"asked"};
  Options options{};

  explicit Parsed(const Texts& words) {
    options.add_to(list);
    list.give_words(words);
    list.take();
  }
};

/// What the UsageError says that the call ends with; empty if there is none.
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
