#include "sim/studies/advise/options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <utility>

#include "hw/base/text.h"
#include "hw/isa/instruction.h"
#include "hw/kinds/load.h"
#include "hw/machines/hash.h"
#include "hw/machines/regions.h"
#include "sim/report/page.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/see_through.h"
#include "sim/session/options/progress.h"
#include "sim/session/options/usage.h"
#include "sim/session/options/version.h"
#include "sim/studies/dimensions.h"

namespace csgsim::studies {

using namespace session;

namespace {

constexpr std::uint64_t default_wrong_pixels = 10;
constexpr unsigned most_fraction_bits = 30;
constexpr std::string_view alu_figure = "alu.bits";

std::vector<unsigned> fraction_bits_of(const std::string& text) { return parse_numbers(text, 0, most_fraction_bits); }
std::vector<unsigned> colour_bits_of(const std::string& text) {
  return parse_numbers(text, isa::fewest_colour_bits, isa::most_colour_bits);
}
std::vector<unsigned> alu_bits_of(const std::string& text) {
  return text.empty() ? std::vector<unsigned>{} : parse_numbers(text, 1, isa::max_field_width);
}
std::vector<std::string> strategies_of(const std::string& text) {
  return text.empty() ? std::vector<std::string>{} : parse_names(text, "strategy", fixed_names_of(emit::strategies));
}
/// All but polygons, which take the bits of a stack and more clocks (docs/memory-bits.md).
std::vector<std::string> usual_strategies() {
  std::vector<std::string> names = fixed_names_of(emit::strategies);
  std::erase(names, emit::name_of(emit::Strategy::polygons));
  return names;
}
std::vector<std::string> colourings_of(const std::string& text) {
  return parse_names(text, "colouring", fixed_names_of(emit::colourings));
}

std::string not_negative(const std::string& text) {
  const bool is_number = !text.empty() && text.find_first_not_of("0123456789.eE+") == std::string::npos;
  return is_number ? "" : "'" + text + "' is not a number, 0 or more";
}

bool has_alu_figure(const machines::Machine& machine) {
  return std::any_of(machine.figures.begin(), machine.figures.end(),
                     [](const machines::Figure& figure) { return figure.key == alu_figure; });
}

/// The machine's name, with that ALU if it is not its own.
std::string machine_name(const AdviseOptions& options, unsigned alu_bits) {
  const machines::Machine own = kinds::load(options.model.machine);
  if (alu_bits == 0 || own.alu_bits == alu_bits) return options.model.machine;
  return fmt::format("{}+{}={}", options.model.machine, alu_figure, alu_bits);
}

std::vector<unsigned> alu_widths(const AdviseOptions& options, const machines::Machine& machine) {
  const std::vector<unsigned> asked = alu_bits_of(options.alu_bits);
  if (has_alu_figure(machine)) return asked.empty() ? std::vector<unsigned>{machine.alu_bits} : asked;
  if (!asked.empty())
    throw UsageError("--alu-bits", "machine " + machine.name + " has no figure alu.bits; leave it out");
  return {0};
}

AdviceRanges ranges_of(const AdviseOptions& options, const machines::Machine& machine) {
  AdviceRanges ranges;
  ranges.z_bits = z_bits_of(options.z_bits);
  ranges.fraction_bits = fraction_bits_of(options.fraction_bits);
  ranges.colour_bits = colour_bits_of(options.colour_bits);
  ranges.colourings = colourings_of(options.colourings);
  ranges.strategies = strategies_of(options.strategies);
  if (ranges.strategies.empty()) {
    // A machine that divides the model itself knows one alone.
    ranges.strategies = machines::division(machine) ? std::vector{std::string(emit::name_of(emit::Strategy::stack))}
                                                    : usual_strategies();
  }
  ranges.stack_bits = stack_bits_of(options.stack_bits);
  ranges.alu_bits = alu_widths(options, machine);
  return ranges;
}

AdviceJob job_of(const AdviseOptions& options, const machines::Machine& machine,
                 const std::vector<unsigned>& alu_bits) {
  ModelFile file = read_model_file(options.model);
  facet::Geometry scene = facet::make_geometry(file.tree, faceting_of(options.model, machine, file.tree));
  if (scene.box.empty()) throw InputError(options.model.model + ": nothing in it to draw; every solid is empty");
  const auto subject = std::make_shared<Subject>(Subject{std::move(file.tree), std::move(scene), std::move(file.hash)});
  const view::Camera camera = camera_of(options.model, machine, subject->tree, subject->scene);
  refuse_see_through(options.model, subject->tree, camera);
  AdviceJob job{subject,
                camera,
                sampling_of(options.model, machine),
                emit_options_of(options.model),
                {},
                {subject->hash, machines::hash_of(machine), version_and_build()}};
  for (const unsigned bits : alu_bits) {
    ModelRequest one = options.model;
    one.machine = machine_name(options, bits);
    job.machines.push_back(machine_of(one));
  }
  return job;
}

/// An option and its value for a shell, behind a blank.
std::string words_of(const std::string& name, const std::string& value) {
  std::string text;
  for (const std::string& word : option_words(name, value)) text += " " + shell_word(word);
  return text;
}

/// Those that were given, and that render has too.
std::string given_words(const AdviseOptions& options, const session::OptionList& command) {
  const std::vector<std::string> own = own_options();
  std::string words;
  for (const GivenOption& option : command.given()) {
    if (option.is_default || std::find(own.begin(), own.end(), option.name) != own.end()) continue;
    const bool is_flag = option.value == "true";
    words += is_flag ? " --" + option.name : words_of(option.name, option.value);
  }
  for (const std::string& set : options.model.sets) words += words_of("set", set);
  return words;
}

}  // namespace

std::vector<std::string> own_options() {
  return {"max-bits", "max-wrong-pixels", "min-fps",   "min-colour-bits", "z-bits",  "fraction-bits", "colour-bits",
          "strategy", "stack-bits",       "colouring", "alu-bits",        "machine", "output",        "threads",
          "no-plots", "progress",         "set",       "report",          "quiet"};
}

AdviceQuestion question_of(const AdviseOptions& options) {
  const machines::Machine machine = machine_of(options.model);
  const AdviceRanges ranges = ranges_of(options, machine);
  Wishes wishes;
  wishes.max_bits = options.max_bits.value_or(machine.array.memory_bits);
  wishes.max_wrong_pixels = options.max_wrong_pixels.value_or(default_wrong_pixels);
  wishes.min_fps = options.min_fps.value_or(0.0);
  wishes.min_colour_bits =
      options.min_colour_bits.value_or(*std::max_element(ranges.colour_bits.begin(), ranges.colour_bits.end()));
  return {job_of(options, machine, ranges.alu_bits), points_of(ranges), wishes};
}

std::string render_command(const AdviseOptions& options, const session::OptionList& command, const AdviceRow& row,
                           const std::string& picture) {
  const AdvicePoint& point = row.point;
  std::string text = "csgsim render " + shell_word(options.model.model) + given_words(options, command);
  const std::string machine = machine_name(options, point.alu_bits);
  if (machine != ModelRequest().machine) text += words_of("machine", machine);
  text +=
      fmt::format(" --memory-bits {} --z-bits {} --fraction-bits {} --colour-bits {} --colouring {} --strategy {}",
                  row.used_bits, point.z_bits, point.fraction_bits, point.colour_bits, point.colouring, point.strategy);
  if (point.stack_bits > 0) text += fmt::format(" --stack-bits {}", point.stack_bits);
  return text + " --check" + words_of("output", picture);
}

report::Picture picture_of(const AdviseOptions& options, const AdviceRow& row, const std::string& caption) {
  const AdvicePoint& point = row.point;
  ModelRequest model = options.model;
  model.machine = machine_name(options, point.alu_bits);
  model.memory_bits = row.used_bits;
  model.z_bits = point.z_bits;
  model.fraction_bits = point.fraction_bits;
  model.colour_bits = point.colour_bits;
  model.colouring = point.colouring;
  model.strategy = point.strategy;
  if (point.stack_bits > 0) model.stack_bits = point.stack_bits;
  return session::picture_of(model, machine_of(model), caption);
}

void AdviseOptions::add_to(session::OptionList& command) {
  model.add_to(command);
  for (const char* name :
       {"--memory-bits", "--z-bits", "--fraction-bits", "--colour-bits", "--colouring", "--strategy", "--stack-bits"})
    command.remove(name);  // searched
  command
      .option("--max-bits", max_bits,
              "Wish: at most so many memory bits a pixel; as many as the machine has if not given")
      .between(1U, isa::max_memory_bits);
  command.option("--max-wrong-pixels", max_wrong_pixels,
                 fmt::format("Wish: at most so many pixels that differ from the exact picture; {} if not given",
                             default_wrong_pixels));
  command.option("--min-fps", min_fps, "Wish: at least so many frames a second; any number if not given")
      .check(not_negative);
  command
      .option("--min-colour-bits", min_colour_bits,
              "Wish: at least so many bits of colour; the most of --colour-bits if not given")
      .between(isa::fewest_colour_bits, isa::most_colour_bits);
  add_list(command, "--strategy", strategies, strategies_of,
           fmt::format("Searched: list of {}; all that the machine can draw by if not given",
                       fmt::join(fixed_names_of(emit::strategies), ", ")));
  add_list(command, "--stack-bits", stack_bits, stack_bits_of, "Searched: numbers, bits that strategy bits is given");
  add_list(command, "--z-bits", z_bits, z_bits_of, "Searched: numbers, bits of depth");
  add_list(command, "--fraction-bits", fraction_bits, fraction_bits_of,
           "Searched: numbers, fraction bits of the planes' coefficients");
  add_list(command, "--colour-bits", colour_bits, colour_bits_of, "Searched: numbers, bits of a colour");
  add_list(command, "--colouring", colourings, colourings_of, "Searched: list of rebroadcast, field");
  add_list(command, "--alu-bits", alu_bits, alu_bits_of,
           "Searched: numbers, bits that a pixel's ALU works on in a clock; the machine's own if not given");
}

}  // namespace csgsim::studies
