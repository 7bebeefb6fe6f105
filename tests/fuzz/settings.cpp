// Settings files, for a command with an option of each type; what is taken is what --dump-config would print, and the
// same again.

#include <algorithm>
#include <string>
#include <vector>

#include "sim/app/settings/settings_dump.h"
#include "sim/app/settings/settings_file.h"
#include "tests/fuzz/property.h"

namespace app = csgsim::app;
namespace fuzz = csgsim::fuzz;

namespace {

const std::vector<app::SettableOption> options{{"view-all", app::Takes::flag}, {"z-bits", app::Takes::whole_number},
                                               {"near", app::Takes::number},   {"camera", app::Takes::text},
                                               {"machines", app::Takes::text}, {"set", app::Takes::texts},
                                               {"output", app::Takes::text},   {"levels", app::Takes::text}};

const std::vector<app::SettableCommand> commands{
    {"render", options}, {"levels", {{"z-bits", app::Takes::text}, {"turn", app::Takes::number}}}};

const app::SettableOption& option_named(const std::string& name) {
  const auto found = std::ranges::find(options, name, &app::SettableOption::name);
  fuzz::require(found != options.end(), "a setting is of an option of the command");
  return *found;
}

void check(const app::Setting& setting) {
  const app::SettableOption& option = option_named(setting.name);
  fuzz::require(option.takes == app::Takes::texts || setting.values.size() == 1, "an option has one value");
  fuzz::require(setting.place.starts_with("fuzz.toml:"), "a setting has a place");
  for (const std::string& value : setting.values) {
    fuzz::require(value.find('\0') == std::string::npos, "a value could stand on a command line");
    if (option.takes == app::Takes::flag) fuzz::require(value == "true" || value == "false", "a flag is on or off");
    if (option.takes == app::Takes::whole_number)
      fuzz::require(std::ranges::all_of(value, [](char c) { return c >= '0' && c <= '9'; }), "a whole number is one");
  }
}

/// Those that are read of what was dumped are those that were dumped.
void check_dump(const std::vector<app::Setting>& settings) {
  std::vector<app::DumpedOption> dumped;
  for (const app::Setting& setting : settings) {
    dumped.push_back({option_named(setting.name), "a meaning", setting.values});
    if (setting.values.empty()) dumped.pop_back();
  }
  const std::vector<app::Setting> again =
      app::read_settings(app::dump("render", dumped), "fuzz.toml", commands, "render");
  fuzz::require(again.size() == dumped.size(), "a dump is read again");
  for (std::size_t i = 0; i < again.size(); ++i)
    fuzz::require(again[i].name == dumped[i].option.name && again[i].values == dumped[i].values,
                  "a dump says what was there");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::vector<app::Setting> settings =
        app::read_settings(fuzz::text_of(data, size), "fuzz.toml", commands, "render");
    for (const app::Setting& setting : settings) check(setting);
    check_dump(settings);
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, "fuzz.toml");
  }
  return 0;
}
