#include "sim/viewer/drawings.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string_view>
#include <utility>

#include "host/read/source.h"
#include "hw/base/input_file.h"
#include "hw/base/messages.h"
#include "hw/base/seconds.h"
#include "hw/kinds/load.h"
#include "sim/session/model/subject.h"
#include "sim/session/options/paths.h"
#include "sim/viewer/knobs.h"

namespace csgsim::viewer {

namespace {

constexpr std::size_t max_kept = 2;  ///< maximum number of drawings kept; a comparison needs two

std::optional<std::string> source_in(const Json& request) {
  const Json& text = member_in(request, "source", Json::value_t::string, "a string");
  return text.is_null() ? std::nullopt : std::optional(text.get<std::string>());
}

/// Rejects machine files other than that of the command line that started the session.
void refuse_other_file(const std::string& machine, const Json& begun_with) {
  const std::string_view file = machines::file_of(machine);
  const std::string known = begun_with.is_string() ? begun_with.get<std::string>() : "";
  if (!file.empty() && file != machines::file_of(known))
    throw RequestError(fmt::format("machine: {} is a file; start csgsim view with --machine {}", file, file));
}

void add_words(std::vector<std::string>& words, const std::string& name, const Json& value) {
  if (value.is_boolean()) {
    if (value.get<bool>()) words.push_back("--" + name);
    return;
  }
  if (!value.is_string()) throw RequestError(name + " must be a string");
  for (std::string& word : session::option_words(name, value.get<std::string>())) words.push_back(std::move(word));
}

std::size_t hash_of(const Json& request, const std::string& text) {
  constexpr std::size_t factor = 31;
  const std::hash<std::string> hash;
  return factor * hash(text_of(request)) + hash(text);
}

Json knob_of(const Json& request, const char* name) { return object_in(request, "knobs").value(name, Json()); }

}  // namespace

std::string model_text(const std::string& model) {
  if (!session::has_mesh_name(model)) return read_regular_file(model, read::model_file);
  static_cast<void>(read_regular_file(model, read::mesh_file));
  return fmt::format("import(file = \"{}\");\n", std::filesystem::path(model).filename().native());
}

Drawings::Drawings(StartCommand beginning) : beginning_(std::move(beginning)) {
  static_cast<void>(model_text(beginning_.model));
}

std::vector<std::string> Drawings::command_words(const Json& request) const {
  std::vector<std::string> words{beginning_.model};
  words.insert(words.end(), beginning_.words.begin(), beginning_.words.end());
  const Json given = object_in(request, "knobs");
  for (const auto& [name, value] : given.items()) {
    if (std::ranges::find(knobs, name) == knobs.end())
      throw RequestError(fmt::format("there is no setting '{}'", name));
    if (name == "machine" && value.is_string())
      refuse_other_file(value.get<std::string>(), beginning_.knobs.value("machine", Json()));
    if (name != "set") {
      add_words(words, name, value);
      continue;
    }
    if (!value.is_array()) throw RequestError("set must be an array of strings");
    for (const Json& one : value) add_words(words, name, one);
  }
  return words;
}

Drawings::ParsedRequest Drawings::parse(const Json& request) const {
  Json used{{"knobs", object_in(request, "knobs")}};
  const std::optional<std::string> source = source_in(request);
  if (source) used["source"] = *source;
  std::vector<std::string> words = command_words(used);
  session::ModelRequest options = session::parse_model_request(words);
  std::string text = source ? *source : model_text(options.model);
  return {std::move(used), std::move(words), std::move(options), std::move(text)};
}

/// The model of the latest drawing if its file would be read the same way; otherwise reads it.
session::ModelFile Drawings::model_of(const ParsedRequest& parsed) const {
  const std::shared_ptr<const Drawing> last = latest();
  const auto is_same = [&](const char* name) { return knob_of(last->request, name) == knob_of(parsed.request, name); };
  const bool is_read = last != nullptr && last->text == parsed.text && is_same("snap") && is_same("set");
  return is_read ? session::ModelFile{last->model.tree, last->model.hash}
                 : session::read_model_file(parsed.options, parsed.text);
}

std::shared_ptr<Drawing> Drawings::evaluate(ParsedRequest parsed) const {
  const CollectedLines messages;
  const auto begin = std::chrono::steady_clock::now();
  machines::Machine machine = session::machine_of(parsed.options);
  session::ModelFile file = model_of(parsed);
  session::CompiledModel model =
      session::compile_model(std::move(file), session::choices_of(parsed.options, machine), machine);
  return std::make_shared<Drawing>(Drawing{.request = std::move(parsed.request),
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

std::shared_ptr<Drawing> Drawings::find_cached(const ParsedRequest& parsed) {
  const std::lock_guard lock(mutex_);
  const auto is_same = [&](const auto& one) { return one->request == parsed.request && one->text == parsed.text; };
  const auto same = std::ranges::find_if(kept_, is_same);
  if (same == kept_.end()) return nullptr;
  std::rotate(kept_.begin(), same, same + 1);
  return kept_.front();
}

void Drawings::cache(const std::shared_ptr<Drawing>& next) {
  const std::lock_guard lock(mutex_);
  kept_.insert(kept_.begin(), next);
  if (kept_.size() > max_kept) kept_.pop_back();
}

std::shared_ptr<std::mutex> Drawings::find_evaluation_mutex(const ParsedRequest& parsed) {
  const std::lock_guard lock(mutex_);
  std::erase_if(turns_, [](const auto& one) { return one.second.expired(); });
  std::weak_ptr<std::mutex>& turn = turns_[hash_of(parsed.request, parsed.text)];
  std::shared_ptr<std::mutex> mine = turn.lock();
  if (!mine) turn = mine = std::make_shared<std::mutex>();
  return mine;
}

std::shared_ptr<Drawing> Drawings::compile(const Json& request, Evaluation& evaluation) {
  ParsedRequest parsed = parse(request);
  if (std::shared_ptr<Drawing> same = find_cached(parsed)) return same;
  const std::shared_ptr<std::mutex> turn = find_evaluation_mutex(parsed);
  const std::lock_guard waits(*turn);
  if (std::shared_ptr<Drawing> same = find_cached(parsed)) return same;
  evaluation.begin(Stage::evaluating);
  std::shared_ptr<Drawing> next = evaluate(std::move(parsed));
  evaluation.begin(Stage::drawing);
  cache(next);
  return next;
}

std::shared_ptr<Drawing> Drawings::draw(const Json& request, Evaluation& evaluation) {
  std::shared_ptr<Drawing> drawing = compile(request, evaluation);
  const std::lock_guard lock(drawing->found->mutex);
  std::optional<session::DrawnRun>& drawn = drawing->found->drawn;
  if (!drawn) drawn = session::draw(drawing->model.program, drawing->machine);
  return drawing;
}

}  // namespace csgsim::viewer
