#include "sim/viewer/drawings.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "host/read/source.h"
#include "hw/base/input_file.h"
#include "hw/base/messages.h"
#include "hw/base/seconds.h"
#include "hw/base/text.h"
#include "hw/kinds/load.h"
#include "sim/shell/paths.h"
#include "sim/viewer/knobs.h"

namespace csgsim::viewer {

namespace {

constexpr std::size_t most_kept = 2;  ///< two are compared

std::optional<std::string> source_in(const Json& wish) {
  const Json& text = member_in(wish, "source", Json::value_t::string, "a text");
  return text.is_null() ? std::nullopt : std::optional(text.get<std::string>());
}

/// A machine's file is read if it is the one that the session began with, and no other.
void refuse_other_file(const std::string& machine, const Json& begun_with) {
  const std::string_view file = machines::file_of(machine);
  const std::string known = begun_with.is_string() ? begun_with.get<std::string>() : "";
  if (!file.empty() && file != machines::file_of(known))
    throw WishError(fmt::format("machine: {} is a file; begin csgsim view with it: --machine {}", file, file));
}

void add_words(std::vector<std::string>& words, const std::string& name, const Json& value) {
  if (value.is_boolean()) {
    if (value.get<bool>()) words.push_back("--" + name);
    return;
  }
  if (!value.is_string()) throw WishError(name + " has to be a text");
  for (std::string& word : shell::option_words(name, value.get<std::string>())) words.push_back(std::move(word));
}

std::string shell_command(const std::vector<std::string>& words) {
  std::string command = "csgsim";
  for (const std::string& word : words) command += " " + shell_word(word);
  return command;
}

Json knob_of(const Json& wish, const char* name) { return object_in(wish, "knobs").value(name, Json()); }

}  // namespace

Drawings::Drawings(Beginning beginning) : beginning_(std::move(beginning)) {
  static_cast<void>(read_file(beginning_.model, read::model_file));
}

std::vector<std::string> Drawings::words_of(const Json& wish) const {
  std::vector<std::string> words{beginning_.model};
  words.insert(words.end(), beginning_.words.begin(), beginning_.words.end());
  const Json wished = object_in(wish, "knobs");
  for (const auto& [name, value] : wished.items()) {
    if (std::ranges::find(knobs, name) == knobs.end()) throw WishError(fmt::format("there is no knob '{}'", name));
    if (name == "machine" && value.is_string())
      refuse_other_file(value.get<std::string>(), beginning_.knobs.value("machine", Json()));
    if (name != "set") {
      add_words(words, name, value);
      continue;
    }
    if (!value.is_array()) throw WishError("set has to be an array of texts");
    for (const Json& one : value) add_words(words, name, one);
  }
  return words;
}

/// The tree as it was read last, if the same would be read.
shell::ModelFile Drawings::model_of(const Json& wish, const shell::ModelOptions& options,
                                    const std::string& text) const {
  const Drawing* const last = latest();
  const bool is_read = last != nullptr && last->text == text && knob_of(last->wish, "snap") == knob_of(wish, "snap") &&
                       knob_of(last->wish, "set") == knob_of(wish, "set");
  return is_read ? shell::ModelFile{last->model.tree, last->model.hash} : shell::read_model_text(options, text);
}

std::shared_ptr<Drawing> Drawings::compiled(const Json& asked) {
  Json wish{{"knobs", object_in(asked, "knobs")}};
  const std::optional<std::string> source = source_in(asked);
  if (source) wish["source"] = *source;
  std::vector<std::string> words = words_of(wish);
  const shell::ModelOptions options = shell::model_options_in(words);
  std::string text = source ? *source : read_file(options.model, read::model_file);
  const auto is_same = [&](const auto& one) { return one->wish == wish && one->text == text; };
  if (const auto same = std::ranges::find_if(kept_, is_same); same != kept_.end()) {
    std::rotate(kept_.begin(), same, same + 1);
    return kept_.front();
  }
  const KeptLines told;
  const auto begin = std::chrono::steady_clock::now();
  machines::Machine machine = shell::machine_of(options);
  shell::CompiledModel model = shell::compile_model(model_of(wish, options, text), options, machine);
  words.insert(words.begin(), "render");
  auto next = std::make_shared<Drawing>(Drawing{.wish = std::move(wish),
                                                .text = std::move(text),
                                                .options = options,
                                                .machine = std::move(machine),
                                                .model = std::move(model),
                                                .command = shell_command(words),
                                                .warnings = told.lines(),
                                                .compiling = seconds_since(begin)});
  kept_.insert(kept_.begin(), std::move(next));
  if (kept_.size() > most_kept) kept_.pop_back();
  return kept_.front();
}

std::shared_ptr<Drawing> Drawings::drawn(const Json& wish) {
  std::shared_ptr<Drawing> drawing = compiled(wish);
  if (!drawing->drawn) drawing->drawn = shell::draw(drawing->model.program, drawing->machine);
  return drawing;
}

}  // namespace csgsim::viewer
