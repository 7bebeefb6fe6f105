#include "sim/session/run/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <optional>
#include <utility>

#include "sim/session/model/compiled_model.h"
#include "sim/session/model/primitive_name.h"
#include "sim/session/model/program_of.h"
#include "sim/session/model/subject.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/progress.h"
#include "sim/session/options/sets.h"
#include "sim/session/options/usage.h"
#include "sim/session/run/memory.h"
#include "sim/story/halfspaces.h"

namespace csgsim::session {

void ExplainRequest::add_to(OptionList& options) {
  model.add_to(options, "The model (.csg, .scad or .jan) or a Program (.csgt)");
  options.option("--pixel", pixel, "Column and row of the pixel, x,y, counted from 0 at the top left");
  options.option("--point", point, "A point of the model, X,Y,Z, instead of the pixel that shows it")
      .excludes("--pixel");
  options
      .option("--why-not", why_not,
              "Also explain why this primitive is not visible there: its index (p3), name (cylinder@9:9) or line (@9)")
      .check(not_empty);
}

namespace {

/// Position of a point of the model in the picture.
struct Seen {
  Pixel pixel;
  double distance = 0;  ///< from the eye along the view axis, model units
};

/// The subject of an explanation: a Program, and its model if known.
struct Explained {
  machines::Machine machine;
  isa::Program program;
  std::optional<CompiledModel> model;  ///< without its Program
};

bool is_of_program(const ExplainRequest& request, const ContentReplacement& in_place) {
  if (in_place.program != nullptr) return true;
  return !in_place.text && !is_model(request.model.model);
}

ProgramOnMachine program_in_place(const isa::Program& program, const ModelRequest& request, const OptionList& options) {
  refuse_scene_sets(request.sets);
  const std::string chosen_machine = options.is_given("machine") ? request.machine : "";
  return {machine_for(program, request.model, chosen_machine, request.sets), program};
}

Explained explained_by(const ExplainRequest& request, const OptionList& options, const ContentReplacement& in_place) {
  if (is_of_program(request, in_place)) {
    ProgramOnMachine found = in_place.program ? program_in_place(*in_place.program, request.model, options)
                                              : program_of(request.model, options);
    return {std::move(found.machine), std::move(found.program), {}};
  }
  Explained subject{machine_of(request.model), {}, {}};
  ModelFile file = read_model_file(request.model, in_place.text);
  subject.model = compile_model(std::move(file), choices_of(request.model, subject.machine), subject.machine);
  subject.program = std::move(subject.model->program);
  return subject;
}

Seen seen_at(const std::string& text, const view::View& view) {
  const auto at = numbers<double>(text, ',', 3, "--point", "X,Y,Z");
  const view::EyeSpace space = view::eye_space(view.camera, view.sampling);
  const glm::dvec3 in_eye = space.to_eye({at[0], at[1], at[2]});
  if (space.perspective && !(in_eye.z > 0))
    throw UsageError("--point", fmt::format("{} is behind the eye; take another point or camera", text));
  const glm::dvec3 place = space.to_picture(in_eye);
  const double column = std::round(place.x);
  const double row = std::round(place.y);
  const bool is_inside = column >= 0 && row >= 0 && column < view.sampling.width && row < view.sampling.height;
  if (!is_inside) {
    throw UsageError("--point", fmt::format("{} is outside the picture of {} x {}, at column {:.1f} and row {:.1f}; "
                                            "move the camera, or take --view-all",
                                            text, view.sampling.width, view.sampling.height, place.x, place.y));
  }
  return {{static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row)}, in_eye.z};
}

void add_point(const std::string& point, double distance, story::PixelExplanation& answer) {
  answer.text =
      fmt::format("point {} is {:.6g} model units in front of the eye, along the view axis\n", point, distance) +
      answer.text;
  answer.json["point_distance"] = distance;
}

std::optional<std::uint32_t> missed_in(const ExplainRequest& request, const isa::Program& program) {
  if (request.why_not.empty()) return std::nullopt;
  return parse_primitive(program, request.why_not, "--why-not");
}

story::PixelExplanation answer_of(const ExplainRequest& request, const Explained& subject) {
  const isa::Program& program = subject.program;
  std::optional<story::HalfspaceFinder> finder;
  if (subject.model) finder.emplace(halfspaces_of(*subject.model));
  const bool is_point = !request.point.empty();
  const Seen seen =
      is_point ? seen_at(request.point, finder->view()) : Seen{parse_pixel(program, request.pixel, "--pixel"), 0};
  story::PixelExplanation answer = story::explain_pixel({program, finder ? &*finder : nullptr}, subject.machine,
                                                        seen.pixel.x, seen.pixel.y, missed_in(request, program));
  if (is_point) add_point(request.point, seen.distance, answer);
  return answer;
}

}  // namespace

std::string explain_command(const OptionList& options, const std::string& subject, const GivenTexts& replacements) {
  ExplainRequest request;
  OptionList list("explain");
  request.add_to(list);
  list.give_operand(subject);
  const bool takes_all = is_model(subject);
  for (const Option& option : options.all()) {
    const std::string key = option.key();
    const bool is_taken = takes_all || key == "machine" || key == "set";
    const bool is_replaced = option.takes != Takes::texts &&
                             std::ranges::any_of(replacements, [&](const auto& given) { return given.first == key; });
    if (option.is_operand || !is_taken || is_replaced || list.find(key) == nullptr) continue;
    for (const std::string& text : option.given) list.give(key, text);
  }
  for (const auto& [key, text] : replacements) list.give(key, text);
  return shell_command(list.words());
}

void refuse_misuse(const ExplainRequest& request, const OptionList& options, const ContentReplacement& in_place) {
  if (request.pixel.empty() == request.point.empty())
    throw UsageError("explain", "name a pixel with --pixel x,y or --point X,Y,Z");
  if (!is_of_program(request, in_place)) return;
  if (!request.point.empty())
    throw UsageError("--point", "is for models; a Program does not record its camera: take --pixel");
  refuse_model_options(options, {"machine", "set", "pixel", "why-not", "json"});
}

story::PixelExplanation explain(const ExplainRequest& request, const OptionList& options,
                                const ContentReplacement& in_place) {
  const Explained subject = explained_by(request, options, in_place);
  return with_memory_for_picture(subject.machine.array, [&] { return answer_of(request, subject); });
}

}  // namespace csgsim::session
