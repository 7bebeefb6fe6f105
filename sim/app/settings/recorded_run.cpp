#include "sim/app/settings/recorded_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/text.h"
#include "sim/app/settings/configuration.h"
#include "sim/app/settings/file_options.h"
#include "sim/app/version.h"

namespace csgsim::app {

namespace {

using Json = nlohmann::ordered_json;

constexpr InputKind stats_input{"name a stats file, .json", std::size_t{256} << 20U, "that is no stats file"};

/// Commands that write stats.
constexpr auto commands = std::to_array<std::string_view>({"render", "run"});

/// Options without effect on picture and counts, beside names of what is written.
constexpr auto without_effect = std::to_array<std::string_view>({"checkpoint-every", "progress", "quiet"});

constexpr std::size_t most_differences = 10;  ///< that are told
constexpr int most_depth = 100;               ///< of brackets: values are compared by recursion

std::string place_of(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte == 0 ? 0 : byte - 1, text.size()));
  const std::size_t line = before.rfind('\n') == before.npos ? 0 : before.rfind('\n') + 1;
  return fmt::format("{}:{}", std::count(before.begin(), before.end(), '\n') + 1, before.size() - line + 1);
}

const Json& member(const RecordedRun& run, const Json& json, const std::string& key) {
  if (!json.is_object() || !json.contains(key)) {
    throw InputError(
        fmt::format("{}: there is no '{}' in its configuration; take a stats file as csgsim wrote it", run.file, key));
  }
  return json.at(key);
}

std::string text_in(const RecordedRun& run, const Json& json) {
  try {
    return bytes_of(json);
  } catch (const InputError&) {
    throw InputError(
        fmt::format("{}: its configuration has {} where a text should be; take a stats file as csgsim "
                    "wrote it",
                    run.file, printable(json.dump().substr(0, 40))));
  }
}

std::string word_of(const RecordedRun& run, const std::string& name, const Json& value) {
  const std::string text = value.is_number() ? value.dump() : text_in(run, value);
  return fmt::format("--{}={}", name, text);
}

bool is_name(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; });
}

bool has_effect(std::string_view option) {
  return role_of(option) != FileRole::output && std::ranges::find(without_effect, option) == without_effect.end();
}

/// What an option holds that was not given.
bool says_nothing(const Json& value) {
  const auto* const text = value.get_ptr<const Json::string_t*>();
  return value.is_null() || value == false || (text != nullptr && text->empty());
}

std::string command_of(const RecordedRun& run) {
  const Json& words = member(run, run.configuration, "command");
  std::string name = words.is_array() && words.size() > 1 ? text_in(run, words.at(1)) : "";
  if (std::ranges::find(commands, name) == commands.end()) {
    throw InputError(fmt::format("{}: it is of 'csgsim {}'; only stats of render and run can be run again", run.file,
                                 printable(name)));
  }
  return name;
}

std::string shown(const Json& json) { return printable(json.dump().substr(0, 60)); }

/// Without what tells of the run and not of its result.
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
  RecordedRun run{printable(file), {}, {}};
  const std::string text = read_file(file, stats_input);
  try {
    run.stats = Json::parse(text, [&](int depth, Json::parse_event_t /*event*/, const Json& /*parsed*/) {
      if (depth > most_depth) throw InputError(run.file + ": too many brackets in brackets; name a stats file");
      return true;
    });
  } catch (const Json::parse_error& error) {
    throw InputError(fmt::format("{}:{}: this is no JSON; name a stats file, as csgsim render --stats writes it",
                                 run.file, place_of(text, error.byte)));
  }
  if (!run.stats.is_object() || !run.stats.contains("configuration")) {
    throw InputError(run.file +
                     ": it has no configuration, so that nothing tells what it is of; name a stats file of "
                     "csgsim render or run");
  }
  run.configuration = run.stats.at("configuration");
  return run;
}

std::vector<std::string> words_of(const RecordedRun& run) {
  const Json& options = member(run, run.configuration, "options");
  std::vector<std::string> lists;  // before the others, since they take what stands behind them
  std::vector<std::string> words;
  const std::string command = command_of(run);
  const std::string operand = command == "render" ? "model" : "program";
  for (const auto& [name, value] : options.items()) {
    if (!is_name(name)) throw InputError(fmt::format("{}: '{}' is no option", run.file, printable(name)));
    if (name == operand || !has_effect(name) || says_nothing(value)) continue;
    if (value == true) {
      words.push_back("--" + name);
    } else if (value.is_array()) {
      for (const Json& one : value) lists.push_back(word_of(run, name, one));
    } else {
      words.push_back(word_of(run, name, value));
    }
  }
  words.insert(words.begin(), lists.begin(), lists.end());
  words.insert(words.begin(), command);
  words.insert(words.end(), {"--progress=auto", "--", text_in(run, member(run, options, operand))});
  return words;
}

std::vector<std::string> changes_since(const RecordedRun& run) {
  std::vector<std::string> changes;
  const std::string version = text_in(run, member(run, run.configuration, "version"));
  if (version != version_and_build())
    changes.push_back(fmt::format("it is of csgsim {}, and this is {}", printable(version), version_and_build()));
  for (const Json& input : member(run, run.configuration, "inputs")) {
    const std::string file = text_in(run, member(run, input, "file"));
    const Json now = hash_of_file(file);
    if (now.is_null()) {
      changes.push_back(
          fmt::format("{} can be read only once, so that nothing tells whether it is the same", printable(file)));
    } else if (now != member(run, input, "hash")) {
      changes.push_back(fmt::format("{} has changed", printable(file)));
    }
  }
  return changes;
}

std::vector<std::string> changes_between(const RecordedRun& run, const Json& configuration) {
  std::vector<std::string> changes;
  const auto hash = [&](const Json& of, const char* what) { return member(run, member(run, of, what), "hash"); };
  if (hash(run.configuration, "machine") != hash(configuration, "machine"))
    changes.push_back(fmt::format("the machine {} has other figures", configuration.at("machine").value("name", "")));
  if (hash(run.configuration, "model") != hash(configuration, "model"))
    changes.push_back(fmt::format("{}, or a file that it takes in, has changed",
                                  printable(bytes_of(configuration.at("model").at("file")))));
  return changes;
}

std::vector<std::string> differences(const RecordedRun& run, const Json& stats) {
  std::vector<std::string> found;
  if (picture_of(run.stats) != picture_of(stats)) found.emplace_back("the picture");
  const Json before = counts_of(run.stats);
  const Json now = counts_of(stats);
  for (const Json& one : Json::diff(before, now)) {
    if (found.size() == most_differences) break;
    const Json::json_pointer place(one.at("path").get<std::string>());
    found.push_back(fmt::format("{} was {}, is {}", printable(place.to_string()),
                                before.contains(place) ? shown(before.at(place)) : "not there",
                                now.contains(place) ? shown(now.at(place)) : "not there"));
  }
  return found;
}

}  // namespace csgsim::app
