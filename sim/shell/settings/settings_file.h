// Reads and writes settings files (TOML).
// Used by command_line.h, mistakes.cpp, recorded_run.h and settings_dump.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/session/options/option_list.h"

namespace csgsim::shell {

using namespace session;

inline constexpr std::size_t max_list_values = 10'000;  ///< values of an option in a file

// Names of the options for settings files, which every command with options has.
inline constexpr std::string_view config_name = "--config";
inline constexpr std::string_view dump_name = "--dump-config";

/// A command and its options that a settings file may give.
struct SettableCommand {
  std::string name;
  std::vector<SettableOption> options;
};

/// An option given by a settings file, in the form of the command line.
struct Setting {
  std::string name;
  std::vector<std::string> values;
  std::string place;  ///< file:line:column
};

/// Reads the settings in a TOML text for one of the commands. `file` is its name; relative file names are relative to
/// its folder. A top-level key applies to every command with that option; a key in a command's table, as in [render],
/// applies to that command only and takes precedence. Throws InputError with file:line:column for unknown keys, with
/// the nearest known one, and for values of the wrong type, whatever command they belong to.
std::vector<Setting> read_settings(std::string_view text, const std::string& file,
                                   std::span<const SettableCommand> commands, std::string_view command);

/// A settings file with every option of the command; options without a value appear as commented examples.
std::string settings_text(const std::string& command, std::span<const OptionValue> options);

}  // namespace csgsim::shell
