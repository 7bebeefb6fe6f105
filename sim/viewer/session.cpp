#include "sim/viewer/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <utility>

#include "host/read/source.h"
#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/messages.h"
#include "hw/base/text.h"
#include "hw/kinds/load.h"
#include "sim/engine/engine.h"
#include "sim/observe/stats_json.h"
#include "sim/report/configuration.h"
#include "sim/report/pictures.h"
#include "sim/report/run_page.h"
#include "sim/shell/memory.h"
#include "sim/shell/paths.h"
#include "sim/shell/primitive_name.h"
#include "sim/shell/run_options.h"
#include "sim/shell/usage.h"
#include "sim/story/story.h"
#include "sim/story/story_json.h"
#include "sim/story/story_text.h"
#include "sim/story/why_not.h"
#include "sim/viewer/instants.h"
#include "sim/viewer/knobs.h"
#include "sim/viewer/png.h"
#include "sim/viewer/two.h"

namespace csgsim::viewer {

namespace {

/// What the page may not ask for.
class WishError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

const Json& member(const Json& wish, const char* key, Json::value_t type, const char* kind) {
  static const Json nothing;
  const auto found = wish.find(key);
  if (found == wish.end() || found->is_null()) return nothing;
  if (found->type() != type) throw WishError(fmt::format("{} is to be {}", key, kind));
  return *found;
}

std::string text_in(const Json& wish, const char* key) {
  const Json& text = member(wish, key, Json::value_t::string, "a text");
  return text.is_null() ? "" : text.get<std::string>();
}

std::optional<std::string> source_in(const Json& wish) {
  const Json& text = member(wish, "source", Json::value_t::string, "a text");
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
  if (!value.is_string()) throw WishError(name + " is to be a text");
  for (std::string& word : shell::option_words(name, value.get<std::string>())) words.push_back(std::move(word));
}

std::string shell_command(const std::vector<std::string>& words) {
  std::string command = "csgsim";
  for (const std::string& word : words) command += " " + shell_word(word);
  return command;
}

std::string camera_text(const view::Camera& camera) {
  return fmt::format("{},{},{},{},{},{}", camera.eye.x, camera.eye.y, camera.eye.z, camera.centre.x, camera.centre.y,
                     camera.centre.z);
}

/// Line and column of a message that begins with the file's name and these.
void put_place(Json& answer, const std::string& message, const std::string& file) {
  if (!message.starts_with(file + ":")) return;
  std::size_t at = file.size() + 1;
  for (const char* key : {"line", "column"}) {
    unsigned number = 0;
    const std::size_t begin = at;
    while (at < message.size() && message[at] >= '0' && message[at] <= '9' && number < 100'000'000)
      number = number * 10 + static_cast<unsigned>(message[at++] - '0');
    if (at == begin || at == message.size() || message[at] != ':') return;
    answer[key] = number;
    ++at;
  }
}

Json error_json(const std::string& message, const std::string& file) {
  Json answer{{"error", message}};
  put_place(answer, message, file);
  return answer;
}

Reply json_reply(const Json& json, int status = 200) {
  return {
      .status = status, .type = "application/json", .body = json.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

constexpr std::size_t most_kept = 2;  ///< drawings: two are compared

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

}  // namespace

/// A wish that was compiled, and what has been found out about it.
struct Session::Drawing {
  Json wish;
  std::string text;  ///< of the model, as it was read
  shell::ModelOptions options;
  machines::Machine machine;
  shell::CompiledModel model;
  std::string command;  ///< that draws the same
  std::vector<std::string> warnings;
  double compiling = 0;  ///< seconds
  std::optional<shell::Drawn> drawn;
  std::unique_ptr<Instants> instants;

  [[nodiscard]] view::View view() const {
    return view::make_view(model.scene, model.tree, model.camera, shell::sampling_of(options, machine));
  }
};

Session::Session(Beginning beginning) : beginning_(std::move(beginning)) {
  static_cast<void>(read_file(beginning_.model, read::model_file));
}

Session::~Session() = default;

std::vector<std::string> Session::words_of(const Json& wish) const {
  std::vector<std::string> words{beginning_.model};
  words.insert(words.end(), beginning_.words.begin(), beginning_.words.end());
  const Json& wished = member(wish, "knobs", Json::value_t::object, "an object");
  for (const auto& [name, value] : wished.items()) {
    if (std::ranges::find(knobs, name) == knobs.end()) throw WishError(fmt::format("there is no knob '{}'", name));
    if (name == "machine" && value.is_string())
      refuse_other_file(value.get<std::string>(), beginning_.knobs.value("machine", Json()));
    if (name != "set") {
      add_words(words, name, value);
      continue;
    }
    if (!value.is_array()) throw WishError("set is to be an array of texts");
    for (const Json& one : value) add_words(words, name, one);
  }
  return words;
}

Session::Drawing& Session::compiled(const Json& asked) {
  Json wish = asked;
  for (const char* key : {"pixel", "why_not", "number", "field", "tinted", "primitive"}) wish.erase(key);
  const std::optional<std::string> source = source_in(wish);
  std::vector<std::string> words = words_of(wish);
  const shell::ModelOptions options = shell::model_options_in(words);
  std::string text = source ? *source : read_file(options.model, read::model_file);
  const auto is_same = [&](const auto& one) { return one->wish == wish && one->text == text; };
  if (const auto same = std::ranges::find_if(kept_, is_same); same != kept_.end()) {
    std::rotate(kept_.begin(), same, same + 1);
    return *kept_.front();
  }
  const KeptLines told;
  const auto begin = Clock::now();
  const auto knob = [](const Json& of, const char* name) {
    return of.value("knobs", Json::object()).value(name, Json());
  };
  const bool is_read = !kept_.empty() && kept_.front()->text == text &&
                       knob(kept_.front()->wish, "snap") == knob(wish, "snap") &&
                       knob(kept_.front()->wish, "set") == knob(wish, "set");
  shell::ModelFile file = is_read ? shell::ModelFile{kept_.front()->model.tree, kept_.front()->model.hash}
                                  : shell::read_model_text(options, text);
  machines::Machine machine = shell::machine_of(options);
  shell::CompiledModel model = shell::compile_model(std::move(file), options, machine);
  words.insert(words.begin(), "render");
  auto next = std::make_unique<Drawing>(Drawing{.wish = std::move(wish),
                                                .text = std::move(text),
                                                .options = options,
                                                .machine = std::move(machine),
                                                .model = std::move(model),
                                                .command = shell_command(words),
                                                .warnings = told.lines(),
                                                .compiling = seconds_since(begin),
                                                .drawn = {},
                                                .instants = {}});
  kept_.insert(kept_.begin(), std::move(next));
  if (kept_.size() > most_kept) kept_.pop_back();
  return *kept_.front();
}

Session::Drawing& Session::drawn(const Json& wish) {
  Drawing& drawing = compiled(wish);
  if (!drawing.drawn) drawing.drawn = shell::draw(drawing.model.program, drawing.machine);
  return drawing;
}

namespace {

Json stats_of(const shell::CompiledModel& model, const machines::Machine& machine, const shell::Drawn& drawn) {
  const observe::Report report{model.program, machine, "functional", drawn.result, drawn.stats, drawn.seconds};
  return report::without_wall_times(observe::to_json(report));
}

}  // namespace

Json Session::draw(const Json& wish) {
  Drawing& drawing = drawn(wish);
  const shell::Drawn& done = *drawing.drawn;
  const report::Picture picture = report::picture_of(done.frame, drawing.model.program, "", "");
  return {{"picture", png_url(picture.png)},
          {"width", picture.width},
          {"height", picture.height},
          {"camera", camera_text(drawing.model.camera)},
          {"stats", stats_of(drawing.model, drawing.machine, done)},
          {"command", drawing.command},
          {"warnings", drawing.warnings},
          {"seconds", {{"compiling", drawing.compiling}, {"running", done.seconds}}}};
}

Json Session::explain(const Json& wish) {
  const Drawing& drawing = compiled(wish);
  const isa::Program& program = drawing.model.program;
  const shell::Pixel pixel = shell::pixel_named(program, text_in(wish, "pixel"), "pixel");
  return shell::with_memory_for_picture(drawing.machine.array, [&] {
    const story::Story told = story::Teller(program, drawing.machine).story_of(pixel.x, pixel.y);
    const view::View view = drawing.view();
    const story::HalfspaceFinder finder(drawing.model.tree, drawing.model.scene, view);
    const story::Subject of{program, &finder};
    Json answer{{"text", story::text_of(of, told)}, {"story", story::to_json(of, told)}};
    if (const std::string missed = text_in(wish, "why_not"); !missed.empty()) {
      const story::WhyNot why_not = story::why_not(of, told, shell::primitive_named(program, missed, "why not"));
      answer["why_not"] = story::text_of(of, told, why_not);
    }
    return answer;
  });
}

Json Session::instant(const Json& wish) {
  Drawing& drawing = compiled(wish);
  const Json& number = member(wish, "number", Json::value_t::number_unsigned, "a number");
  const Json& tinted = member(wish, "tinted", Json::value_t::boolean, "true or false");
  const Json& primitive = member(wish, "primitive", Json::value_t::number_unsigned, "a number");
  const InstantWish instant{
      .number = number.is_null() ? 0 : number.get<std::uint64_t>(),
      .field = text_in(wish, "field"),
      .is_tinted = tinted.is_boolean() && tinted.get<bool>(),
      .primitive = primitive.is_null() ? std::nullopt : std::optional(primitive.get<std::uint64_t>())};
  return shell::with_memory_for_picture(drawing.machine.array, [&] {
    if (!drawing.instants) drawing.instants = std::make_unique<Instants>(drawing.model.program, drawing.machine);
    return drawing.instants->at(instant);
  });
}

Json Session::two(const Json& wish) {
  const auto side = [&](const char* name) {
    const Json& asked = member(wish, name, Json::value_t::object, "an object");
    const Drawing& drawing = drawn(asked.is_null() ? Json::object() : asked);
    return report::DrawnProgram{drawing.model.program, drawing.drawn->frame};
  };
  const report::DrawnProgram a = side("a");
  const report::DrawnProgram b = side("b");
  return two_at_once(a, b);
}

std::string Session::report() const {
  if (kept_.empty() || !kept_.front()->drawn) throw WishError("nothing has been drawn yet");
  const Drawing& drawing = *kept_.front();
  const isa::Program& program = drawing.model.program;
  const view::View view = drawing.view();
  const story::HalfspaceFinder finder(drawing.model.tree, drawing.model.scene, view);
  return report::to_html(report::run_page(stats_of(drawing.model, drawing.machine, *drawing.drawn),
                                          drawing.drawn->frame, program, drawing.machine, {drawing.command, {}},
                                          &finder));
}

Json Session::about() const {
  Json machines = kinds::built_in_names();
  const shell::ModelOptions usual;
  const Json begun_with = beginning_.knobs.value("machine", Json());
  if (begun_with.is_string() && std::ranges::find(machines, begun_with) == machines.end())
    machines.insert(machines.begin(), begun_with);
  return {{"model", beginning_.model},
          {"source", read_file(beginning_.model, read::model_file)},
          {"knobs", beginning_.knobs},
          {"names", knobs},
          {"machines", std::move(machines)},
          {"strategies", shell::strategy_names()},
          {"usual", {{"machine", usual.machine}, {"strategy", usual.strategy}, {"z-bits", usual.z_bits}}}};
}

Reply Session::answer(const Request& request, std::string_view path) {
  const std::lock_guard lock(mutex_);
  const std::string file = shell::shown_name(beginning_.model);
  try {
    if (request.method == "GET" && path == "about") return json_reply(about());
    if (request.method == "GET" && path == "report")
      return {.type = "text/html; charset=utf-8", .body = report(), .has_scripts = true};
    if (request.method != "POST") return {.status = 404, .body = "there is nothing of that name\n"};
    const Json wish = Json::parse(request.body);
    if (!wish.is_object()) throw WishError("a wish is to be an object");
    if (path == "draw") return json_reply(draw(wish));
    if (path == "explain") return json_reply(explain(wish));
    if (path == "instant") return json_reply(instant(wish));
    if (path == "two") return json_reply(two(wish));
    return {.status = 404, .body = "there is nothing of that name\n"};
  } catch (const Json::exception& error) {
    return json_reply({{"error", error.what()}}, 400);
  } catch (const WishError& error) {
    return json_reply({{"error", error.what()}}, 400);
  } catch (const shell::UsageError& error) {
    return json_reply({{"error", error.what()}}, 422);
  } catch (const InputError& error) {
    return json_reply(error_json(error.what(), file), 422);
  } catch (const std::bad_alloc&) {
    return json_reply({{"error", "there is not enough memory"}}, 422);
  }
}

}  // namespace csgsim::viewer
