// Stats files, as rerun reads them: what is taken for options, and what differs from another run's stats.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/app/settings/file_options.h"
#include "sim/app/settings/recorded_run.h"
#include "sim/app/version.h"
#include "tests/fuzz/property.h"

namespace app = csgsim::app;
namespace fuzz = csgsim::fuzz;

std::string app::version_and_build() { return "0.1.0 fuzz"; }

namespace {

/// As render has them: one of each type, and what rerun passes over.
const std::vector<app::SettableOption> options{
    {"model", app::Takes::text},          {"program", app::Takes::text},  {"size", app::Takes::text},
    {"machine", app::Takes::text},        {"set", app::Takes::texts},     {"view-all", app::Takes::flag},
    {"z-bits", app::Takes::whole_number}, {"near", app::Takes::number},   {"output", app::Takes::text},
    {"stats", app::Takes::text},          {"report", app::Takes::text},   {"checkpoint", app::Takes::text},
    {"resume", app::Takes::text},         {"progress", app::Takes::text}, {"quiet", app::Takes::flag}};

/// A text that is none, so that files are not read.
constexpr const char* other_run = R"({"clocks": 7, "parts": [1, 2], "configuration": {"command": ["csgsim", "render"],
  "options": {"model": "m.csg"}, "machine": {"name": "m", "hash": "1"}, "model": {"file": "m.csg", "hash": "2"},
  "picture": {"hash": "3"}}, "wall_seconds": 1})";

void check(const app::Setting& setting) {
  const auto option = std::ranges::find(options, setting.name, &app::SettableOption::name);
  fuzz::require(option != options.end(), "a setting is of an option of the command");
  fuzz::require(app::role_of(setting.name) != app::FileRole::output, "no setting names what is written");
  fuzz::require(!setting.values.empty(), "a setting has a value");
  fuzz::require(option->takes == app::Takes::texts || setting.values.size() == 1, "an option has one value");
  for (const std::string& value : setting.values)
    fuzz::require(value.find('\0') == std::string::npos, "a value could stand on a command line");
  if (option->takes == app::Takes::flag) fuzz::require(setting.values.front() == "true", "a flag is on");
}

/// Looks at it in one way; an error has to be one line with the file's name.
template <class Look>
void look(const Look& look_at) {
  try {
    look_at();
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, "fuzz.json");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const app::RecordedRun other = app::recorded_run_of(other_run, "other.json");
  look([&] {
    const app::RecordedRun run = app::recorded_run_of(std::string(fuzz::text_of(data, size)), "fuzz.json");
    look([&] {
      const std::vector<app::Setting> settings = app::settings_of(run, options);
      for (const app::Setting& setting : settings) check(setting);
    });
    look([&] { static_cast<void>(app::changes_between(run, other.configuration)); });
    fuzz::require(app::differences(run, run.stats).empty(), "a run is like itself");
    fuzz::require(app::differences(run, other.stats).empty() == app::differences(other, run.stats).empty(),
                  "of two runs the one differs from the other as the other from the one");
  });
  return 0;
}
