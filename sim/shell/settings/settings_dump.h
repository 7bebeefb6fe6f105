#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/shell/settings/settings_file.h"

namespace csgsim::shell {

/// An option with the value that it has.
struct DumpedOption {
  SettableOption option;
  std::string meaning;
  std::vector<std::string> values;  ///< none where nothing is said
};

/// A settings file (TOML) with every option of the command; where nothing is said, an example is commented out.
std::string dump(const std::string& command, std::span<const DumpedOption> options);

}  // namespace csgsim::shell
