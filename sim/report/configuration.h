// Configuration section of pages.
// Used by sim/report and sim/viewer.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/report/page.h"

namespace csgsim::report {

/// The command of a page, with its options.
struct Context {
  std::string command;                                         ///< command line, quoted for a POSIX shell
  std::vector<std::pair<std::string, std::string>> options{};  ///< names and values, given or by default
  std::vector<Json> machines{};                                ///< format of `machine` in a stats file's configuration
  std::string explain{};  ///< result of explain_command (sim/session/run/explain.h); empty for studies
};

/// The leaves of the data at a JSON pointer as rows named by their keys, as in `array.width`, without nulls. A long
/// list appears as its length.
Table leaf_table(const Json& data, const std::string& pointer, const std::string& caption);

/// The section on the inputs of the data: `configuration` of the data if present, otherwise the command's options.
Section configuration_section(const Json& data, const Context& context);

/// The sentences at a JSON pointer into the data: a list whose elements are strings or objects with `sentence`.
std::vector<Part> sentences(const Json& data, const std::string& pointer);

}  // namespace csgsim::report
