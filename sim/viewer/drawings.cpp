#include "sim/viewer/drawings.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string_view>
#include <utility>

#include "host/read/source.h"
#include "hw/base/input_file.h"
#include "hw/base/messages.h"
#include "hw/base/seconds.h"
#include "hw/kinds/load.h"
#include "sim/session/options/paths.h"
#include "sim/viewer/knobs.h"

namespace csgsim::viewer {

namespace {

constexpr std::size_t max_kept = 2;  ///< enough to compare two

std::optional<std::string> source_in(const Json& wish) {
  const Json& text = member_in(wish, "source", Json::value_t::string, "a string");
  return text.is_null() ? std::nullopt : std::optional(text.get<std::string>());
}

/// Rejects machine files other than that of the command line that started the session.
void refuse_other_file(const std::string& machine, const Json& begun_with) {
  const std::string_view file = machines::file_of(machine);
  const std::string known = begun_with.is_string() ? begun_with.get<std::string>() : "";
  if (!file.empty() && file != machines::file_of(known))
    throw WishError(fmt::format("machine: {} is a file; start csgsim view with --machine {}", file, file));
}

void add_words(std::vector<std::string>& words, const std::string& name, const Json& value) {
  if (value.is_boolean()) {
    if (value.get<bool>()) words.push_back("--" + name);
    return;
  }
  if (!value.is_string()) throw WishError(name + " must be a string");
  for (std::string& word : session::option_words(name, value.get<std::string>())) words.push_back(std::move(word));
}

std::size_t hash_of(const Json& wish, const std::string& text) {
  constexpr std::size_t factor = 31;
  const std::hash<std::string> hash;
  return factor * hash(text_of(wish)) + hash(text);
}

Json knob_of(const Json& wish, const char* name) { return object_in(wish, "knobs").value(name, Json()); }

}  // namespace

Drawings::Drawings(Beginning beginning) : beginning_(std::move(beginning)) {
  static_cast<void>(read_regular_file(beginning_.model, read::model_file));
}

std::vector<std::string> Drawings::words_of(const Json& wish) const {
  std::vector<std::string> words{beginning_.model};
  words.insert(words.end(), beginning_.words.begin(), beginning_.words.end());
  const Json wished = object_in(wish, "knobs");
  for (const auto& [name, value] : wished.items()) {
    if (std::ranges::find(knobs, name) == knobs.end()) throw WishError(fmt::format("there is no setting '{}'", name));
    if (name == "machine" && value.is_string())
      refuse_other_file(value.get<std::string>(), beginning_.knobs.value("machine", Json()));
    if (name != "set") {
      add_words(words, name, value);
      continue;
    }
    if (!value.is_array()) throw WishError("set must be an array of strings");
    for (const Json& one : value) add_words(words, name, one);
  }
  return words;
}

Drawings::ParsedWish Drawings::parse(const Json& request) const {
  Json wish{{"knobs", object_in(request, "knobs")}};
  const std::optional<std::string> source = source_in(request);
  if (source) wish["source"] = *source;
  std::vector<std::string> words = words_of(wish);
  session::ModelRequest options = session::model_request_in(words);
  std::string text = source ? *source : read_regular_file(options.model, read::model_file);
  return {std::move(wish), std::move(words), std::move(options), std::move(text)};
}

/// The model of the latest drawing if its file would be read the same way; otherwise reads it.
session::ModelFile Drawings::model_of(const ParsedWish& parsed) const {
  const std::shared_ptr<const Drawing> last = latest();
  const auto is_same = [&](const char* name) { return knob_of(last->wish, name) == knob_of(parsed.wish, name); };
  const bool is_read = last != nullptr && last->text == parsed.text && is_same("snap") && is_same("set");
  return is_read ? session::ModelFile{last->model.tree, last->model.hash}
                 : session::read_model_file(parsed.options, parsed.text);
}

std::shared_ptr<Drawing> Drawings::evaluate(ParsedWish parsed) const {
  const CollectedLines messages;
  const auto begin = std::chrono::steady_clock::now();
  machines::Machine machine = session::machine_of(parsed.options);
  session::ModelFile file = model_of(parsed);
  session::CompiledModel model =
      session::compile_model(std::move(file), session::choices_of(parsed.options, machine), machine);
  return std::make_shared<Drawing>(Drawing{.wish = std::move(parsed.wish),
                                           .text = std::move(parsed.text),
                                           .options = std::move(parsed.options),
                                           .machine = std::move(machine),
                                           .model = std::move(model),
                                           .words = std::move(parsed.words),
                                           .warnings = messages.lines(),
                                           .compiling = seconds_since(begin)});
}

std::string Drawing::command(const std::string& name) const {
  std::vector<std::string> all{name};
  all.insert(all.end(), words.begin(), words.end());
  return session::shell_command(all);
}

std::shared_ptr<const Drawing> Drawings::latest() const {
  const std::lock_guard lock(mutex_);
  return kept_.empty() ? nullptr : kept_.front();
}

std::shared_ptr<Drawing> Drawings::find_kept(const ParsedWish& parsed) {
  const std::lock_guard lock(mutex_);
  const auto is_same = [&](const auto& one) { return one->wish == parsed.wish && one->text == parsed.text; };
  const auto same = std::ranges::find_if(kept_, is_same);
  if (same == kept_.end()) return nullptr;
  std::rotate(kept_.begin(), same, same + 1);
  return kept_.front();
}

void Drawings::keep(const std::shared_ptr<Drawing>& next) {
  const std::lock_guard lock(mutex_);
  kept_.insert(kept_.begin(), next);
  if (kept_.size() > max_kept) kept_.pop_back();
}

std::shared_ptr<std::mutex> Drawings::find_turn(const ParsedWish& parsed) {
  const std::lock_guard lock(mutex_);
  std::erase_if(turns_, [](const auto& one) { return one.second.expired(); });
  std::weak_ptr<std::mutex>& turn = turns_[hash_of(parsed.wish, parsed.text)];
  std::shared_ptr<std::mutex> mine = turn.lock();
  if (!mine) turn = mine = std::make_shared<std::mutex>();
  return mine;
}

std::shared_ptr<Drawing> Drawings::compile(const Json& wish, Evaluation& evaluation) {
  ParsedWish request = parse(wish);
  if (std::shared_ptr<Drawing> same = find_kept(request)) return same;
  const std::shared_ptr<std::mutex> turn = find_turn(request);
  const std::lock_guard waits(*turn);
  if (std::shared_ptr<Drawing> same = find_kept(request)) return same;
  evaluation.begin(Stage::evaluating);
  std::shared_ptr<Drawing> next = evaluate(std::move(request));
  evaluation.begin(Stage::drawing);
  keep(next);
  return next;
}

std::shared_ptr<Drawing> Drawings::draw(const Json& wish, Evaluation& evaluation) {
  std::shared_ptr<Drawing> drawing = compile(wish, evaluation);
  const std::lock_guard lock(drawing->found->mutex);
  std::optional<session::Drawn>& drawn = drawing->found->drawn;
  if (!drawn) drawn = session::draw(drawing->model.program, drawing->machine);
  return drawing;
}

}  // namespace csgsim::viewer
