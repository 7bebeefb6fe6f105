#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/report/page.h"

namespace csgsim::report {

/// What a command was told, and where its page goes.
struct Context {
  std::string command;                                         ///< with its arguments, quoted for a POSIX shell
  std::vector<std::pair<std::string, std::string>> options{};  ///< names and values, given or by default
  std::vector<Json> machines{};                                ///< as the `machine` of a stats file's configuration
  std::string explain{};  ///< of a run: explain_command (sim/session/run/explain.h)
};

/// The leaves of a part of the data as rows, named by their keys, `array.width`, but for nulls; long lists are told by
/// their length.
Table leaves(const Json& data, const std::string& at, const std::string& caption);

/// How the data came to be: `configuration` of the data where they hold it, else what the command was told.
Section configuration_section(const Json& data, const Context& context);

/// What of a list of sentences, each a string or an object with `sentence`, the data hold at that pointer.
std::vector<Part> sentences(const Json& data, const std::string& at);

}  // namespace csgsim::report
