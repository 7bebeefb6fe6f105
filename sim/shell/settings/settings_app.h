#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sim/shell/settings/settings_file.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

/// The part of the command line that takes options from settings files: --config of every command that has options.
namespace csgsim::shell {

/// What the library that reads the command line begins with; the command that is run gets what its settings say.
std::unique_ptr<CLI::App> make_settings_app(const std::string& description, const std::string& program);

/// Reads the settings file that the arguments name, if they name one; to be called before they are parsed. Throws
/// InputError.
void load_settings(CLI::App& app, std::span<char* const> arguments);

/// Takes these for the command that the arguments ask for, as if a settings file said them; no file is read. Command
/// lines that csgsim records of it then say all of them.
void load_settings(CLI::App& app, std::span<char* const> arguments, std::vector<Setting> settings);

/// Where a message about an option is about a value from the settings file: its file:line:column; else empty.
std::string place_of(const CLI::App& app, const std::string& message);

/// The arguments are parsed for what they say alone: CLI::Success is thrown where a command would be run. No settings
/// file is read.
void only_read(CLI::App& app, std::span<char* const> arguments);

/// Every option and operand of the command that settings know.
std::vector<SettableOption> settable_options(const CLI::App& command);

/// The option as settings know it; of --help and --config, and of options without a long name, the name is empty.
SettableOption settable(const CLI::Option& option);

}  // namespace csgsim::shell
