#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/session/options/option_list.h"

namespace csgsim::shell {

using namespace session;  // whose requests the shell reads and shows

inline constexpr std::size_t most_in_list = 10'000;  ///< values that a file gives an option

// Options of every command with options, about settings files.
inline constexpr std::string_view config_name = "--config";
inline constexpr std::string_view dump_name = "--dump-config";

struct SettableCommand {
  std::string name;
  std::vector<SettableOption> options;
};

/// An option that a settings file gives, as the command line would give it.
struct Setting {
  std::string name;
  std::vector<std::string> values;
  std::string place;  ///< file:line:column
};

/// What a settings file (TOML) says for one of the commands, whose options there are; `file` is its name, and relative
/// names of files are relative to its folder. A key at the top is for every command that has such an option; one in
/// a command's table, [render], is for that command alone and comes before. Throws InputError with file:line:column:
/// keys that no command has, with the nearest one, and values of the wrong type, for whatever command they are.
std::vector<Setting> read_settings(std::string_view text, const std::string& file,
                                   std::span<const SettableCommand> commands, std::string_view command);

/// A settings file with every option of the command; where nothing is said, an example is commented out.
std::string settings_text(const std::string& command, std::span<const OptionValue> options);

}  // namespace csgsim::shell
