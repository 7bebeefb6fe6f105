#pragma once

#include <memory>
#include <span>
#include <string>

#include "sim/app/settings/settings_file.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

/// The part of the command line that takes options from settings files: --config of every command that has options.
namespace csgsim::app {

/// What the library that reads the command line begins with; the command that is run gets what its settings say.
std::unique_ptr<CLI::App> make_settings_app(const std::string& description, const std::string& program);

/// Reads the settings file that the arguments name, if they name one; to be called before they are parsed. Throws
/// InputError.
void load_settings(CLI::App& app, std::span<char* const> arguments);

/// Where a message about an option is about a value from the settings file: its file:line:column; else empty.
std::string place_of(const CLI::App& app, const std::string& message);

/// The option as settings know it; of --help and --config, and of options without a long name, the name is empty.
SettableOption settable(const CLI::Option& option);

}  // namespace csgsim::app
