#include "sim/shell/settings/recorded_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/nearest.h"
#include "hw/base/text.h"
#include "sim/session/options/json_text.h"
#include "sim/session/options/option_table.h"
#include "sim/session/options/version.h"
#include "sim/session/run/recorded_bytes.h"

namespace csgsim::shell {

namespace {

using Json = nlohmann::ordered_json;

constexpr InputKind stats_input{"a stats file, .json", std::size_t{256} << 20U, "it is not a stats file"};

/// Commands that write stats.
constexpr auto recorded_commands = std::to_array<std::string_view>({"render", "run"});

/// Options that do not affect picture and counts, in addition to names of outputs.
constexpr auto without_effect =
    std::to_array<std::string_view>({"checkpoint-every", "openscad-time", "progress", "quiet", "verbose"});

constexpr std::size_t max_differences = 10;  ///< reported at most

std::string place_of(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte == 0 ? 0 : byte - 1, text.size()));
  const std::size_t line = before.rfind('\n') == before.npos ? 0 : before.rfind('\n') + 1;
  return fmt::format("{}:{}", std::count(before.begin(), before.end(), '\n') + 1, before.size() - line + 1);
}

/// Records where a text stops being valid JSON.
struct FirstFault : nlohmann::detail::json_sax_acceptor<Json> {
  std::size_t byte = 0;

  bool parse_error(std::size_t position, const std::string& /*token*/, const nlohmann::detail::exception& /*why*/) {
    byte = position;
    return false;
  }
};

std::string place_of_fault(const std::string& text) {
  FirstFault fault;
  static_cast<void>(Json::sax_parse(text, &fault));
  return place_of(text, fault.byte);
}

const Json& member(const RecordedRun& run, const Json& json, std::string_view key) {
  if (!json.is_object() || !json.contains(key)) {
    throw InputError(fmt::format("{}: its configuration lacks '{}'; use an unmodified stats file", run.file, key));
  }
  return json.at(key);
}

[[noreturn]] void fail_value(const RecordedRun& run, const Json& value, std::string_view wanted) {
  throw InputError(fmt::format("{}: its configuration has {} where {} should be; use an unmodified stats file",
                               run.file, printable(value.dump().substr(0, 40)), wanted));
}

/// A recorded text. Rejects zero bytes, which neither command lines nor file names can hold.
std::string text_in(const RecordedRun& run, const Json& json) {
  try {
    std::string text = bytes_from_json(json);
    if (text.find('\0') == std::string::npos) return text;
  } catch (const InputError&) {
    // the error below covers this case
  }
  fail_value(run, json, "a string");
}

std::string number_in(const RecordedRun& run, const Json& value) {
  return value.is_number() ? value.dump() : text_in(run, value);
}

/// The values of an option; empty if it was not given.
std::vector<std::string> values_of(const RecordedRun& run, const SettableOption& option, const Json& value) {
  if (value.is_null()) return {};
  std::vector<std::string> values;
  switch (option.takes) {
    case Takes::flag:
      if (!value.is_boolean()) fail_value(run, value, "true or false");
      if (value.get<bool>()) values.emplace_back("true");
      return values;
    case Takes::whole_number:
    case Takes::number: return {number_in(run, value)};
    case Takes::text:
      values.push_back(text_in(run, value));
      if (values.front().empty()) values.clear();
      return values;
    case Takes::texts: break;
  }
  if (!value.is_array() || value.size() > max_list_values)
    fail_value(run, value, fmt::format("a list of at most {} texts", max_list_values));
  for (const Json& one : value) values.push_back(text_in(run, one));
  return values;
}

bool has_effect(std::string_view option) {
  return known_option(option).role != FileRole::output &&
         std::ranges::find(without_effect, option) == without_effect.end();
}

const SettableOption& option_named(const RecordedRun& run, std::string_view name,
                                   std::span<const SettableOption> options) {
  const auto found = std::ranges::find(options, name, &SettableOption::name);
  if (found != options.end()) return *found;
  std::vector<std::string_view> known;
  for (const SettableOption& option : options) known.push_back(option.name);
  throw InputError(fmt::format("{}: '{}' is not an option that csgsim {} records in a stats file; the nearest is '{}'",
                               run.file, printable(name), recorded_command(run), nearest(name, known)));
}

std::string shown(const Json& json) { return printable(json.dump().substr(0, 60)); }

/// Removes what describes the run rather than its result.
Json counts_of(const Json& stats) {
  Json counts = stats;
  counts.erase("configuration");
  counts.erase("wall_seconds");
  return counts;
}

Json picture_of(const Json& stats) {
  const Json::json_pointer place("/configuration/picture/hash");
  return stats.contains(place) ? stats.at(place) : Json();
}

}  // namespace

RecordedRun read_recorded_run(const std::string& file) {
  return parse_recorded_run(read_file(file, stats_input), file);
}

RecordedRun parse_recorded_run(const std::string& text, const std::string& file) {
  RecordedRun run{printable(file), {}, {}};
  try {
    run.stats = parse_json(text, {});
  } catch (const JsonLimitError& error) {
    throw InputError(fmt::format("{}: {}; name a stats file", run.file, error.what()));
  } catch (const Json::exception&) {
    throw InputError(fmt::format("{}:{}: not valid JSON; name a stats file, as written by csgsim render --stats",
                                 run.file, place_of_fault(text)));
  }
  if (!run.stats.is_object() || !run.stats.contains("configuration")) {
    throw InputError(run.file +
                     ": it has no configuration that describes its run; name a stats file of csgsim render "
                     "or run");
  }
  run.configuration = run.stats.at("configuration");
  return run;
}

std::string recorded_command(const RecordedRun& run) {
  const Json& words = member(run, run.configuration, "command");
  std::string name = words.is_array() && words.size() > 1 ? text_in(run, words.at(1)) : "";
  if (std::ranges::find(recorded_commands, name) == recorded_commands.end()) {
    throw InputError(fmt::format("{}: it was written by 'csgsim {}'; only runs of render and run can be repeated",
                                 run.file, printable(name)));
  }
  return name;
}

std::vector<Setting> recorded_settings(const RecordedRun& run, std::span<const SettableOption> options) {
  const Json& recorded = member(run, run.configuration, "options");
  const std::string operand = recorded_command(run) == "render" ? "model" : "program";
  std::vector<Setting> settings{{operand, {text_in(run, member(run, recorded, operand))}, run.file}};
  for (const auto& [name, value] : recorded.items()) {
    std::vector<std::string> values = values_of(run, option_named(run, name, options), value);
    if (name != operand && has_effect(name) && !values.empty()) settings.push_back({name, std::move(values), run.file});
  }
  return settings;
}

std::vector<std::string> describe_changes_since(const RecordedRun& run) {
  std::vector<std::string> changes;
  const std::string version = text_in(run, member(run, run.configuration, "version"));
  if (version != version_and_build())
    changes.push_back(
        fmt::format("it was written by csgsim {}, and this is {}", printable(version), version_and_build()));
  const Json& inputs = member(run, run.configuration, "inputs");
  if (!inputs.is_array()) fail_value(run, inputs, "a list of files");
  for (const Json& input : inputs) {
    const std::string file = text_in(run, member(run, input, "file"));
    const Json now = hash_of_file(file);
    if (now.is_null()) {
      changes.push_back(fmt::format("{} can be read only once, so it cannot be checked for changes", printable(file)));
    } else if (now != member(run, input, "hash")) {
      changes.push_back(fmt::format("{} has changed", printable(file)));
    }
  }
  return changes;
}

std::vector<std::string> describe_configuration_changes(const RecordedRun& run, const Json& configuration) {
  std::vector<std::string> changes;
  const auto hash = [&](const Json& of, const char* what) { return member(run, member(run, of, what), "hash"); };
  if (hash(run.configuration, "machine") != hash(configuration, "machine"))
    changes.push_back(fmt::format("the parameters of the machine {} differ from the recorded ones",
                                  configuration.at("machine").value("name", "")));
  if (hash(run.configuration, "model") != hash(configuration, "model"))
    changes.push_back(fmt::format("{}, or a file that it includes, has changed",
                                  printable(bytes_from_json(configuration.at("model").at("file")))));
  return changes;
}

std::vector<std::string> describe_count_differences(const RecordedRun& run, const Json& stats) {
  std::vector<std::string> found;
  if (picture_of(run.stats) != picture_of(stats)) found.emplace_back("the picture");
  const Json before = counts_of(run.stats);
  const Json now = counts_of(stats);
  for (const Json& one : Json::diff(before, now)) {
    if (found.size() == max_differences) break;
    const Json::json_pointer place(one.at("path").get<std::string>());
    found.push_back(fmt::format("{} was {}, is {}", printable(place.to_string()),
                                before.contains(place) ? shown(before.at(place)) : "not there",
                                now.contains(place) ? shown(now.at(place)) : "not there"));
  }
  return found;
}

}  // namespace csgsim::shell
