#include "sim/viewer/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "hw/base/error.h"
#include "hw/isa/facts.h"
#include "hw/kinds/load.h"
#include "sim/observe/stats_json.h"
#include "sim/report/configuration.h"
#include "sim/report/pictures.h"
#include "sim/report/run_page.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/primitive_name.h"
#include "sim/session/options/json_text.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/usage.h"
#include "sim/session/run/advice.h"
#include "sim/session/run/memory.h"
#include "sim/session/run/run_request.h"
#include "sim/session/run/verdict.h"
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

/// Reads a number of at most nine digits and advances `at` past it; nothing if there is no digit.
std::optional<unsigned> number_at(const std::string& text, std::size_t& at) {
  constexpr unsigned most = 100'000'000;
  const std::size_t begin = at;
  unsigned number = 0;
  while (at < text.size() && text[at] >= '0' && text[at] <= '9' && number < most)
    number = number * 10 + static_cast<unsigned>(text[at++] - '0');
  return at == begin ? std::nullopt : std::optional(number);
}

/// Adds line and column of a message that begins with the file's name and place.
void put_position(Json& answer, const std::string& message, const std::string& file) {
  if (!message.starts_with(file + ":")) return;
  std::size_t at = file.size() + 1;
  for (const char* key : {"line", "column"}) {
    const std::optional<unsigned> number = number_at(message, at);
    if (!number || at == message.size() || message[at] != ':') return;
    answer[key] = *number;
    ++at;
  }
}

Json error_json(const std::string& message, const std::string& file) {
  Json answer{{"error", message}};
  put_position(answer, message, file);
  return answer;
}

Reply json_reply(const Json& json, int status = 200) {
  return {.status = status, .type = "application/json", .body = text_of(json)};
}

/// Options of csgsim wave for pixel, window and tree levels. Each is one word, so that no text can act as another
/// option.
std::vector<std::string> probing_options(const Json& request) {
  std::vector<std::string> options;
  for (const char* const name : {"pixel", "window"}) {
    if (request.contains(name)) options.push_back(fmt::format("--{}={}", name, text_in(request, name)));
  }
  for (const std::string& probe : texts_in(request, "probes")) options.push_back("--probe=" + probe);
  return options;
}

/// Adds to an instant the active tree of the surface that its instruction draws.
void put_active_tree(const Drawing& drawing, Json& instant) {
  if (!instant.contains("piece")) return;
  std::unique_ptr<ActiveTrees>& trees = drawing.found->active_trees;
  if (!trees) trees = std::make_unique<ActiveTrees>(drawing.model, drawing.machine);
  std::optional<Json> active =
      trees->of(instant["piece"].get<std::uint32_t>(), instant["segment"].get<std::uint32_t>());
  if (active) instant["active"] = std::move(*active);
}

Json stats_of(const session::CompiledModel& model, const machines::Machine& machine, const session::DrawnRun& drawn,
              std::span<const observe::Knob> turned = {}) {
  const observe::Report report{model.program, machine, "functional", drawn.result, drawn.stats, drawn.seconds, turned};
  return report::without_wall_times(observe::to_json(report));
}

Reply not_found_reply() { return {.status = 404, .body = "there is no page of that name\n"}; }

bool is_drawn(const Drawing& drawing) {
  const std::lock_guard lock(drawing.found->mutex);
  return drawing.found->drawn.has_value();
}

/// The answer to a question whose work was stopped.
Reply ended_reply(EndReason why, const std::string& model, std::chrono::milliseconds time_limit) {
  switch (why) {
    case EndReason::overdue:
      return json_reply(
          {{"error", fmt::format("{}: evaluating it takes longer than {:g} s; simplify the model, or start csgsim "
                                 "view with a longer --evaluation-time SECONDS",
                                 model, std::chrono::duration<double>(time_limit).count())}},
          422);
    case EndReason::closed: return json_reply({{"error", "csgsim view is stopping"}}, 503);
    case EndReason::not_yet:
    case EndReason::cancelled: break;
  }
  return json_reply({{"error", model + ": cancelled"}, {"cancelled", true}}, 422);
}

}  // namespace

Json Session::draw(const Json& request, Evaluation& evaluation) {
  const std::shared_ptr<Drawing> held = drawings_.draw(request, evaluation);
  const Drawing& drawing = *held;
  const session::DrawnRun& done = *drawing.found->drawn;
  const report::Picture picture = report::picture_of(done.frame, drawing.model.program, "", "");
  return {{"picture", png_url(picture.png)},
          {"width", picture.width},
          {"height", picture.height},
          {"camera", camera_text(drawing.model.camera)},
          {"stats", stats_of(drawing.model, drawing.machine, done)},
          {"command", drawing.command("render")},
          {"warnings", drawing.warnings},
          {"seconds", {{"compiling", drawing.compiling}, {"running", done.seconds}}}};
}

Json Session::explain(const Json& request, Evaluation& evaluation) {
  const std::shared_ptr<Drawing> held = drawings_.compile(request, evaluation);
  const Drawing& drawing = *held;
  const isa::Program& program = drawing.model.program;
  const session::Pixel pixel = session::parse_pixel(program, text_in(request, "pixel"), "pixel");
  const std::string why_not = text_in(request, "why_not");
  std::optional<std::uint32_t> missed;
  if (!why_not.empty()) missed = session::parse_primitive(program, why_not, "why not");
  return session::with_memory_for_picture(drawing.machine.array, [&]() -> Json {
    const story::HalfspaceFinder finder = session::halfspaces_of(drawing.model);
    story::PixelExplanation history =
        story::explain_pixel({program, &finder}, drawing.machine, pixel.x, pixel.y, missed);
    return {{"text", std::move(history.text)}, {"story", std::move(history.json)}};
  });
}

Json Session::instant(const Json& request, Evaluation& evaluation) {
  const std::shared_ptr<Drawing> held = drawings_.compile(request, evaluation);
  const Drawing& drawing = *held;
  const InstantRequest instant{.number = number_in(request, "number").value_or(0),
                               .field = text_in(request, "field"),
                               .is_tinted = flag_in(request, "tinted"),
                               .primitive = number_in(request, "primitive"),
                               .clock = number_in(request, "clock")};
  const std::lock_guard lock(drawing.found->mutex);
  std::unique_ptr<Instants>& instants = drawing.found->instants;
  try {
    return session::with_memory_for_picture(drawing.machine.array, [&] {
      if (!instants) instants = std::make_unique<Instants>(drawing.model.program, drawing.machine);
      Json answer = instants->at(instant);
      put_active_tree(drawing, answer);
      return answer;
    });
  } catch (const Interrupted&) {
    instants.reset();  // the state may be between two instants
    throw;
  }
}

Json Session::tree(const Json& request, Evaluation& evaluation) {
  const std::shared_ptr<Drawing> drawing = drawings_.compile(request, evaluation);
  return {{"tree", tree_json(drawing->model.tree, *drawing->model.program.facts)}};
}

std::string Session::record(const isa::Program& program, const std::vector<std::string>& options) {
  const std::lock_guard one_at_a_time(recording_);
  return options_.recorder(program, options);
}

std::shared_ptr<const Lanes> Session::find_lanes(const Drawing& drawing, const Json& request) {
  // Lanes without a pixel cover the whole frame and are recorded once.
  const bool is_probed = request.contains("pixel");
  if (!is_probed) {
    const std::lock_guard lock(drawing.found->mutex);
    if (drawing.found->lanes) return drawing.found->lanes;
  }
  std::vector<std::string> options = probing_options(request);
  options.push_back("--lanes");
  auto lanes = std::make_shared<const Lanes>(record(drawing.model.program, options));
  if (is_probed) return lanes;
  const std::lock_guard lock(drawing.found->mutex);
  return drawing.found->lanes = std::move(lanes);
}

Json Session::lanes(const Json& request, Evaluation& evaluation) {
  const std::shared_ptr<Drawing> drawing = drawings_.compile(request, evaluation);
  const std::shared_ptr<const Lanes> lanes = find_lanes(*drawing, request);
  const std::uint64_t begin = number_in(request, "begin").value_or(lanes->begin());
  const std::uint64_t end = number_in(request, "end").value_or(lanes->end());
  return {{"first", lanes->begin()},
          {"last", lanes->end()},
          {"begin", begin},
          {"end", end},
          {"lanes", lanes->between(begin, end)}};
}

Json Session::wave(const Json& request, Evaluation& evaluation) {
  const std::shared_ptr<Drawing> drawing = drawings_.compile(request, evaluation);
  return {{"wave", record(drawing->model.program, probing_options(request))}};
}

Json Session::advice(const Json& request, Evaluation& evaluation) {
  const std::shared_ptr<Drawing> drawing = drawings_.draw(request, evaluation);
  const engine::RunResult& result = drawing->found->drawn->result;
  const session::Advice advice{
      .machine = drawing->options.machine, .is_asked = true, .ask = {}, .settings = [&](const engine::RunResult& of) {
        return session::measure_setting_knobs(drawing->model, drawing->options, drawing->machine, of);
      }};
  const std::vector<observe::Knob> turned =
      session::measure_parameter_knobs(advice, drawing->model.program, drawing->machine, result);
  return {{"knobs", stats_of(drawing->model, drawing->machine, *drawing->found->drawn, turned).at("knobs")}};
}

Json Session::verdict(const Json& request, Evaluation& evaluation) {
  const std::shared_ptr<Drawing> drawing = drawings_.draw(request, evaluation);
  Json accuracy;
  std::string text = session::verdict(drawing->model, drawing->found->drawn->frame, accuracy);
  return {{"accuracy", std::move(accuracy)}, {"text", std::move(text)}};
}

Json Session::two(const Json& request, Evaluation& evaluation) {
  const std::shared_ptr<Drawing> a = drawings_.draw(object_in(request, "a"), evaluation);
  const std::shared_ptr<Drawing> b = drawings_.draw(object_in(request, "b"), evaluation);
  return compare_drawings({a->model.program, a->found->drawn->frame}, {b->model.program, b->found->drawn->frame});
}

std::string Session::report() const {
  const std::shared_ptr<const Drawing> drawing = drawings_.latest();
  if (drawing == nullptr || !is_drawn(*drawing)) throw RequestError("nothing has been drawn yet");
  const story::HalfspaceFinder finder = session::halfspaces_of(drawing->model);
  return report::to_html(
      report::run_page(stats_of(drawing->model, drawing->machine, *drawing->found->drawn), drawing->found->drawn->frame,
                       drawing->model.program, drawing->machine,
                       {.command = drawing->command("render"), .explain = drawing->command("explain")}, &finder));
}

Json Session::about() const {
  const StartCommand& beginning = drawings_.beginning();
  Json machines = kinds::built_in_names();
  const session::ModelRequest usual;
  const Json begun_with = beginning.knobs.value("machine", Json());
  if (begun_with.is_string() && std::ranges::find(machines, begun_with) == machines.end())
    machines.insert(machines.begin(), begun_with);
  return {{"model", beginning.model},
          {"source", model_text(beginning.model)},
          {"knobs", beginning.knobs},
          {"names", knobs},
          {"machines", std::move(machines)},
          {"strategies", session::strategy_names()},
          {"effects", effects_form()},
          {"evaluation_time", std::chrono::duration<double>(evaluations_.time_limit()).count()},
          {"usual", {{"machine", usual.machine}, {"strategy", usual.strategy}, {"z-bits", usual.z_bits}}}};
}

/// A question that the page sends by POST.
struct Session::Question {
  std::string_view name;
  Json (Session::*answer)(const Json& request, Evaluation& evaluation);
};

const Session::Question Session::questions[] = {
    {"draw", &Session::draw},     {"explain", &Session::explain}, {"instant", &Session::instant},
    {"tree", &Session::tree},     {"lanes", &Session::lanes},     {"wave", &Session::wave},
    {"advice", &Session::advice}, {"verdict", &Session::verdict}, {"two", &Session::two},
};

Reply Session::answer_post(const Request& http, std::string_view path) {
  constexpr session::JsonLimits limits{.depth = 16, .values = 10'000};
  const Json request = session::parse_json(http.body, limits);
  if (!request.is_object()) throw RequestError("a request must be a JSON object");
  const std::string evaluation_name = text_in(request, "evaluation");
  if (path == "progress") return json_reply(evaluations_.progress(evaluation_name));
  if (path == "cancel") {
    evaluations_.cancel(evaluation_name);
    return json_reply(Json::object());
  }
  const auto question = std::ranges::find(questions, path, &Question::name);
  if (question == std::end(questions)) return not_found_reply();
  Evaluation evaluation(evaluations_, evaluation_name);
  try {
    return json_reply((this->*question->answer)(request, evaluation));
  } catch (const Interrupted&) {
    return ended_reply(evaluation.end_reason(), session::shown_name(drawings_.beginning().model),
                       evaluations_.time_limit());
  }
}

Reply Session::answer_request(const Request& request, std::string_view path) {
  if (request.method == "POST") return answer_post(request, path);
  if (request.method == "GET" && path == "about") return json_reply(about());
  if (request.method == "GET" && path == "report")
    return {.type = "text/html; charset=utf-8", .body = report(), .has_scripts = true};
  return not_found_reply();
}

Reply Session::answer(const Request& request, std::string_view path) {
  try {
    return answer_request(request, path);
  } catch (const Json::exception& error) {
    return json_reply({{"error", error.what()}}, 400);
  } catch (const session::JsonLimitError& error) {
    return json_reply({{"error", error.what()}}, 400);
  } catch (const RequestError& error) {
    return json_reply({{"error", error.what()}}, 400);
  } catch (const session::UsageError& error) {
    return json_reply({{"error", error.what()}}, 422);
  } catch (const InputError& error) {
    return json_reply(error_json(error.what(), session::shown_name(drawings_.beginning().model)), 422);
  } catch (const std::bad_alloc&) {
    return json_reply({{"error", "there is not enough memory; use a smaller picture or model"}}, 422);
  }
}

}  // namespace csgsim::viewer
