// Stats files, as read by rerun: accepted options, and differences from another run's stats.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/session/options/option_table.h"
#include "sim/session/options/version.h"
#include "sim/shell/settings/recorded_run.h"
#include "tests/fuzz/property.h"

namespace shell = csgsim::shell;
namespace session = csgsim::session;
namespace fuzz = csgsim::fuzz;

std::string session::version_and_build() { return "0.1.0 fuzz"; }

namespace {

/// Options like those of render: one of each type, and those that rerun skips.
const std::vector<session::SettableOption> options{
    {"model", session::Takes::text},          {"program", session::Takes::text},  {"size", session::Takes::text},
    {"machine", session::Takes::text},        {"set", session::Takes::texts},     {"view-all", session::Takes::flag},
    {"z-bits", session::Takes::whole_number}, {"near", session::Takes::number},   {"output", session::Takes::text},
    {"stats", session::Takes::text},          {"report", session::Takes::text},   {"checkpoint", session::Takes::text},
    {"resume", session::Takes::text},         {"progress", session::Takes::text}, {"quiet", session::Takes::flag},
    {"verbose", session::Takes::flag}};

/// Stats of another run, without files to read.
constexpr const char* other_run = R"({"clocks": 7, "parts": [1, 2], "configuration": {"command": ["csgsim", "render"],
  "options": {"model": "m.csg"}, "machine": {"name": "m", "hash": "1"}, "model": {"file": "m.csg", "hash": "2"},
  "picture": {"hash": "3"}}, "wall_seconds": 1})";

void check(const shell::Setting& setting) {
  const auto option = std::ranges::find(options, setting.name, &session::SettableOption::name);
  fuzz::require(option != options.end(), "a setting belongs to an option of the command");
  fuzz::require(session::known_option(setting.name).role != session::FileRole::output, "no setting names an output");
  fuzz::require(!setting.values.empty(), "a setting has a value");
  fuzz::require(option->takes == session::Takes::texts || setting.values.size() == 1, "an option has one value");
  for (const std::string& value : setting.values)
    fuzz::require(value.find('\0') == std::string::npos, "a value is valid on a command line");
  if (option->takes == session::Takes::flag) fuzz::require(setting.values.front() == "true", "a flag is on");
}

/// Checks the input in one way; an error must be one line with the file's name.
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
  static const shell::RecordedRun other = shell::parse_recorded_run(other_run, "other.json");
  look([&] {
    const shell::RecordedRun run = shell::parse_recorded_run(std::string(fuzz::text_of(data, size)), "fuzz.json");
    look([&] {
      const std::vector<shell::Setting> settings = shell::recorded_settings(run, options);
      for (const shell::Setting& setting : settings) check(setting);
    });
    look([&] { static_cast<void>(shell::describe_configuration_changes(run, other.configuration)); });
    fuzz::require(shell::describe_count_differences(run, run.stats).empty(), "a run equals itself");
    fuzz::require(shell::describe_count_differences(run, other.stats).empty() ==
                      shell::describe_count_differences(other, run.stats).empty(),
                  "differences between two runs are symmetric");
  });
  return 0;
}
