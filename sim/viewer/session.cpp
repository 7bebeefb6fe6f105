#include "sim/viewer/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "host/read/source.h"
#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/kinds/load.h"
#include "sim/observe/stats_json.h"
#include "sim/report/configuration.h"
#include "sim/report/pictures.h"
#include "sim/report/run_page.h"
#include "sim/shell/advice.h"
#include "sim/shell/compiled_model.h"
#include "sim/shell/memory.h"
#include "sim/shell/paths.h"
#include "sim/shell/primitive_name.h"
#include "sim/shell/run_options.h"
#include "sim/shell/usage.h"
#include "sim/shell/verdict.h"
#include "sim/story/answer.h"
#include "sim/viewer/effects_form.h"
#include "sim/viewer/knobs.h"
#include "sim/viewer/png.h"
#include "sim/viewer/recorded.h"
#include "sim/viewer/two.h"

namespace csgsim::viewer {

namespace {

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

/// Of csgsim wave: which pixel and levels, and when. As one word each, so that no text is taken for another option.
std::vector<std::string> probing_options(const Json& wish) {
  std::vector<std::string> options;
  for (const char* const name : {"pixel", "window"}) {
    if (wish.contains(name)) options.push_back(fmt::format("--{}={}", name, text_in(wish, name)));
  }
  for (const std::string& probe : texts_in(wish, "probes")) options.push_back("--probe=" + probe);
  return options;
}

/// Beside an instant: what the surface is compared with that its instruction draws.
void put_active_tree(Drawing& drawing, Json& instant) {
  if (!instant.contains("piece")) return;
  if (!drawing.active_trees)
    drawing.active_trees = std::make_unique<ActiveTrees>(drawing.model, drawing.options, drawing.machine);
  std::optional<Json> active =
      drawing.active_trees->of(instant["piece"].get<std::uint32_t>(), instant["segment"].get<std::uint32_t>());
  if (active) instant["active"] = std::move(*active);
}

Json stats_of(const shell::CompiledModel& model, const machines::Machine& machine, const shell::Drawn& drawn,
              std::span<const observe::Knob> turned = {}) {
  const observe::Report report{model.program, machine, "functional", drawn.result, drawn.stats, drawn.seconds, turned};
  return report::without_wall_times(observe::to_json(report));
}

}  // namespace

Json Session::draw(const Json& wish, Lock& /*lock*/) {
  const std::shared_ptr<Drawing> held = drawings_.drawn(wish);
  const Drawing& drawing = *held;
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

Json Session::explain(const Json& wish, Lock& /*lock*/) {
  const std::shared_ptr<Drawing> held = drawings_.compiled(wish);
  const Drawing& drawing = *held;
  const isa::Program& program = drawing.model.program;
  const shell::Pixel pixel = shell::pixel_named(program, text_in(wish, "pixel"), "pixel");
  const std::string why_not = text_in(wish, "why_not");
  std::optional<std::uint32_t> missed;
  if (!why_not.empty()) missed = shell::primitive_named(program, why_not, "why not");
  return shell::with_memory_for_picture(drawing.machine.array, [&]() -> Json {
    const story::HalfspaceFinder finder = shell::halfspaces_of(drawing.model, drawing.options, drawing.machine);
    story::Answer told = story::answer_of({program, &finder}, drawing.machine, pixel.x, pixel.y, missed);
    return {{"text", std::move(told.text)}, {"story", std::move(told.json)}};
  });
}

Json Session::instant(const Json& wish, Lock& /*lock*/) {
  const std::shared_ptr<Drawing> held = drawings_.compiled(wish);
  Drawing& drawing = *held;
  const InstantWish instant{.number = number_in(wish, "number").value_or(0),
                            .field = text_in(wish, "field"),
                            .is_tinted = flag_in(wish, "tinted"),
                            .primitive = number_in(wish, "primitive"),
                            .clock = number_in(wish, "clock")};
  return shell::with_memory_for_picture(drawing.machine.array, [&] {
    if (!drawing.instants) drawing.instants = std::make_unique<Instants>(drawing.model.program, drawing.machine);
    Json answer = drawing.instants->at(instant);
    put_active_tree(drawing, answer);
    return answer;
  });
}

Json Session::tree(const Json& wish, Lock& /*lock*/) {
  const std::shared_ptr<Drawing> drawing = drawings_.compiled(wish);
  return {{"tree", tree_of(drawing->model.tree, drawing->model.program.facts)}};
}

std::string Session::recorded_of(const isa::Program& program, const std::vector<std::string>& options, Lock& lock) {
  lock.unlock();
  const std::lock_guard one_at_a_time(recording_);
  return recorded(program, options);
}

Json Session::lanes(const Json& wish, Lock& lock) {
  const std::shared_ptr<Drawing> drawing = drawings_.compiled(wish);
  std::vector<std::string> options = probing_options(wish);
  options.push_back("--lanes");
  std::shared_ptr<const Lanes> lanes = wish.contains("pixel") ? nullptr : drawing->lanes;
  if (!lanes) {
    lanes = std::make_shared<Lanes>(recorded_of(drawing->model.program, options, lock));
    lock.lock();
    if (!wish.contains("pixel")) drawing->lanes = lanes;
  }
  const std::uint64_t begin = number_in(wish, "begin").value_or(lanes->begin());
  const std::uint64_t end = number_in(wish, "end").value_or(lanes->end());
  return {{"first", lanes->begin()},
          {"last", lanes->end()},
          {"begin", begin},
          {"end", end},
          {"lanes", lanes->between(begin, end)}};
}

Json Session::wave(const Json& wish, Lock& lock) {
  const std::shared_ptr<Drawing> drawing = drawings_.compiled(wish);
  return {{"wave", recorded_of(drawing->model.program, probing_options(wish), lock)}};
}

Json Session::advice(const Json& wish, Lock& /*lock*/) {
  const std::shared_ptr<Drawing> drawing = drawings_.drawn(wish);
  const engine::RunResult& result = drawing->drawn->result;
  const shell::Advice advice{
      .machine = drawing->options.machine, .is_asked = true, .ask = {}, .settings = [&](const engine::RunResult& of) {
        return shell::setting_knobs(drawing->model, drawing->options, drawing->machine, of);
      }};
  const std::vector<observe::Knob> turned = shell::knobs_of(advice, drawing->model.program, drawing->machine, result);
  return {{"knobs", stats_of(drawing->model, drawing->machine, *drawing->drawn, turned).at("knobs")}};
}

Json Session::verdict(const Json& wish, Lock& /*lock*/) {
  const std::shared_ptr<Drawing> drawing = drawings_.drawn(wish);
  Json accuracy;
  std::string text = shell::verdict(drawing->model, drawing->options, drawing->drawn->frame, accuracy);
  return {{"accuracy", std::move(accuracy)}, {"text", std::move(text)}};
}

Json Session::two(const Json& wish, Lock& /*lock*/) {
  const std::shared_ptr<Drawing> a = drawings_.drawn(object_in(wish, "a"));
  const std::shared_ptr<Drawing> b = drawings_.drawn(object_in(wish, "b"));
  return two_at_once({a->model.program, a->drawn->frame}, {b->model.program, b->drawn->frame});
}

std::string Session::report() const {
  const Drawing* const drawing = drawings_.latest();
  if (drawing == nullptr || !drawing->drawn) throw WishError("nothing has been drawn yet");
  const story::HalfspaceFinder finder = shell::halfspaces_of(drawing->model, drawing->options, drawing->machine);
  return report::to_html(report::run_page(stats_of(drawing->model, drawing->machine, *drawing->drawn),
                                          drawing->drawn->frame, drawing->model.program, drawing->machine,
                                          {drawing->command, {}}, &finder));
}

Json Session::about() const {
  const Beginning& beginning = drawings_.beginning();
  Json machines = kinds::built_in_names();
  const shell::ModelOptions usual;
  const Json begun_with = beginning.knobs.value("machine", Json());
  if (begun_with.is_string() && std::ranges::find(machines, begun_with) == machines.end())
    machines.insert(machines.begin(), begun_with);
  return {{"model", beginning.model},
          {"source", read_file(beginning.model, read::model_file)},
          {"knobs", beginning.knobs},
          {"names", knobs},
          {"machines", std::move(machines)},
          {"strategies", shell::strategy_names()},
          {"effects", effects_form()},
          {"usual", {{"machine", usual.machine}, {"strategy", usual.strategy}, {"z-bits", usual.z_bits}}}};
}

/// What is asked by a POST.
struct Session::Question {
  std::string_view name;
  Json (Session::*answer)(const Json& wish, Lock& lock);
};

const Session::Question Session::questions[] = {
    {"draw", &Session::draw},     {"explain", &Session::explain}, {"instant", &Session::instant},
    {"tree", &Session::tree},     {"lanes", &Session::lanes},     {"wave", &Session::wave},
    {"advice", &Session::advice}, {"verdict", &Session::verdict}, {"two", &Session::two},
};

Reply Session::answered(const Request& request, std::string_view path, Lock& lock) {
  if (request.method == "GET" && path == "about") return json_reply(about());
  if (request.method == "GET" && path == "report")
    return {.type = "text/html; charset=utf-8", .body = report(), .has_scripts = true};
  const auto question = std::ranges::find(questions, path, &Question::name);
  if (request.method != "POST" || question == std::end(questions))
    return {.status = 404, .body = "there is nothing of that name\n"};
  const Json wish = Json::parse(request.body);
  if (!wish.is_object()) throw WishError("a wish has to be an object");
  return json_reply((this->*question->answer)(wish, lock));
}

Reply Session::answer(const Request& request, std::string_view path) {
  Lock lock(mutex_);
  try {
    return answered(request, path, lock);
  } catch (const Json::exception& error) {
    return json_reply({{"error", error.what()}}, 400);
  } catch (const WishError& error) {
    return json_reply({{"error", error.what()}}, 400);
  } catch (const shell::UsageError& error) {
    return json_reply({{"error", error.what()}}, 422);
  } catch (const InputError& error) {
    return json_reply(error_json(error.what(), shell::shown_name(drawings_.beginning().model)), 422);
  } catch (const std::bad_alloc&) {
    return json_reply({{"error", "there is not enough memory"}}, 422);
  }
}

}  // namespace csgsim::viewer
