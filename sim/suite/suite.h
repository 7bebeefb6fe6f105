// The list of the cases of the benchmark suite.
// Used by sim/suite.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace csgsim::suite {

/// A model with everything that its pictures and counts depend on, apart from the machine.
struct Case {
  std::string name;   ///< letters, digits and `_`; also the name of its files
  std::string group;  ///< `stand-in`, `corpus`, `hard` or `family`
  std::string about;
  std::string model;  ///< path of the model in csgsim's sources
  /// Every option of `csgsim compile` on which the Program depends, without dashes, and its value: one per setting_keys
  /// and in their order.
  std::vector<std::pair<std::string, std::string>> settings;
};

struct Suite {
  std::string version;
  std::vector<std::string> stored;    ///< machines that run the stored Programs
  std::vector<std::string> compiled;  ///< machines that divide the picture, so that each has its own Programs
  std::vector<Case> cases;
};

/// Reads the list (TOML); `file` is its name in messages. Keys of [settings] apply to all cases; a case may replace
/// them. Throws InputError of the form `file:line:column: what is wrong; what to do` for invalid TOML, an unknown or
/// missing key, a value of another type, and a name that occurs twice or is no file name.
Suite read_suite(std::string_view text, std::string_view file);

/// The case with that name. Throws InputError, with a suggestion, if there is none.
const Case& case_named(const Suite& suite, std::string_view name);

/// Names of the cases, in the order of the list.
std::vector<std::string> case_names(const Suite& suite);

}  // namespace csgsim::suite
