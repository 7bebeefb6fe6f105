// Settings files, for a command with an option of each type; accepted settings are printed like --dump-config and read
// again.

#include <algorithm>
#include <string>
#include <vector>

#include "sim/shell/settings/settings_file.h"
#include "tests/fuzz/property.h"

namespace shell = csgsim::shell;
namespace session = csgsim::session;
namespace fuzz = csgsim::fuzz;

namespace {

const std::vector<session::SettableOption> options{
    {"view-all", session::Takes::flag}, {"z-bits", session::Takes::whole_number}, {"near", session::Takes::number},
    {"camera", session::Takes::text},   {"machines", session::Takes::text},       {"set", session::Takes::texts},
    {"output", session::Takes::text},   {"levels", session::Takes::text}};

const std::vector<shell::SettableCommand> commands{
    {"render", options}, {"levels", {{"z-bits", session::Takes::text}, {"turn", session::Takes::number}}}};

const session::SettableOption& option_named(const std::string& name) {
  const auto found = std::ranges::find(options, name, &session::SettableOption::name);
  fuzz::require(found != options.end(), "a setting belongs to an option of the command");
  return *found;
}

void check(const shell::Setting& setting) {
  const session::SettableOption& option = option_named(setting.name);
  fuzz::require(option.takes == session::Takes::texts || setting.values.size() == 1, "an option has one value");
  fuzz::require(setting.place.starts_with("fuzz.toml:"), "a setting has a place");
  for (const std::string& value : setting.values) {
    fuzz::require(value.find('\0') == std::string::npos, "a value is valid on a command line");
    if (option.takes == session::Takes::flag) fuzz::require(value == "true" || value == "false", "a flag is on or off");
    if (option.takes == session::Takes::whole_number)
      fuzz::require(std::ranges::all_of(value, [](char c) { return c >= '0' && c <= '9'; }),
                    "a whole number consists of digits");
  }
}

/// Checks that dumped settings are read unchanged.
void check_dump(const std::vector<shell::Setting>& settings) {
  std::vector<session::OptionValue> dumped;
  for (const shell::Setting& setting : settings) {
    dumped.push_back({option_named(setting.name), false, "a meaning", setting.values});
    if (setting.values.empty()) dumped.pop_back();
  }
  const std::vector<shell::Setting> again =
      shell::read_settings(shell::settings_text("render", dumped), "fuzz.toml", commands, "render");
  fuzz::require(again.size() == dumped.size(), "a dump can be read again");
  for (std::size_t i = 0; i < again.size(); ++i)
    fuzz::require(again[i].name == dumped[i].name && again[i].values == dumped[i].values,
                  "a dump contains the original settings");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::vector<shell::Setting> settings =
        shell::read_settings(fuzz::text_of(data, size), "fuzz.toml", commands, "render");
    for (const shell::Setting& setting : settings) check(setting);
    check_dump(settings);
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, "fuzz.toml");
  }
  return 0;
}
