#include "sim/studies/advise/options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>

#include "host/view/projection.h"
#include "hw/base/error.h"
#include "hw/base/text.h"
#include "hw/isa/instruction.h"
#include "hw/kinds/load.h"
#include "hw/machines/hash.h"
#include "hw/machines/regions.h"
#include "sim/report/page.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/transparent_parts.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/read_by.h"
#include "sim/session/options/usage.h"
#include "sim/session/options/version.h"
#include "sim/studies/design/axes.h"
#include "sim/studies/design/grid.h"
#include "sim/studies/dimensions.h"

namespace csgsim::studies {

namespace {

using session::ModelRequest;
using Texts = std::vector<std::string>;

constexpr std::uint64_t default_wrong_pixels = 10;
constexpr std::string_view alu_figure = "alu.bits";

/// Searched axes, slowest first; they replace the options of render with the same names.
struct Searched {
  const char* key;
  std::string AdviseOptions::*list;
};
constexpr Searched searched[] = {
    {"z-bits", &AdviseOptions::z_bits},           {"fraction-bits", &AdviseOptions::fraction_bits},
    {"colour-bits", &AdviseOptions::colour_bits}, {"colouring", &AdviseOptions::colourings},
    {"strategy", &AdviseOptions::strategies},     {"stack-bits", &AdviseOptions::stack_bits}};

Texts texts_of_numbers(const std::string& list, unsigned minimum, unsigned maximum) {
  Texts texts;
  for (const unsigned number : session::parse_numbers(list, minimum, maximum)) texts.push_back(std::to_string(number));
  return texts;
}

/// The values of a list; empty for an empty list of strategies or ALU widths.
Texts parse_values(std::string_view key, const std::string& list) {
  if (key == "alu-bits") return list.empty() ? Texts{} : texts_of_numbers(list, 1, isa::max_field_width);
  if (key == "fraction-bits") return texts_of_numbers(list, 0, view::max_fraction_bits);
  if (key == "strategy" && list.empty()) return {};
  return find_axis(key)->values(list);
}

std::string not_negative(const std::string& text) {
  const bool is_number = !text.empty() && text.find_first_not_of("0123456789.eE+") == std::string::npos;
  return is_number ? "" : "'" + text + "' is not a non-negative number";
}

/// The machine's name, with the ALU width appended if it differs from the machine's.
std::string machine_name(const AdviseOptions& options, unsigned alu_bits) {
  const machines::Machine own = kinds::load(options.model.machine);
  if (alu_bits == 0 || own.alu_bits == alu_bits) return options.model.machine;
  return fmt::format("{}+{}={}", options.model.machine, alu_figure, alu_bits);
}

/// The requested ALU widths; {0} if the machine's kind has no ALU width.
std::vector<unsigned> alu_widths(const AdviseOptions& options, const machines::Machine& machine) {
  std::vector<unsigned> requested;
  for (const std::string& bits : parse_values("alu-bits", options.alu_bits))
    requested.push_back(static_cast<unsigned>(std::stoul(bits)));
  if (std::ranges::find(machine.figures, alu_figure, &machines::Figure::key) != machine.figures.end())
    return requested.empty() ? std::vector<unsigned>{machine.alu_bits} : requested;
  if (!requested.empty())
    throw session::UsageError("--alu-bits", "machine " + machine.name + " has no parameter alu.bits; omit the option");
  return {0};
}

/// The strategies searched by default. Machines that divide the model themselves have one.
Texts default_strategies(const machines::Machine& machine) {
  if (machines::division(machine)) return {std::string(emit::name_of(emit::Strategy::stack))};
  return names_of(emit::default_strategies());
}

std::vector<Dimension> dimensions_of(const AdviseOptions& options, const machines::Machine& machine) {
  std::vector<Dimension> dimensions;
  for (const Searched& one : searched) {
    Texts values = parse_values(one.key, options.*one.list);
    dimensions.push_back({one.key, values.empty() ? default_strategies(machine) : std::move(values)});
  }
  return dimensions;
}

std::map<unsigned, Job> jobs_of(const AdviseOptions& options, const machines::Machine& machine,
                                const std::vector<unsigned>& alu_bits) {
  session::ModelFile file = session::read_model_file(options.model);
  facet::Geometry scene = facet::make_geometry(file.tree, session::faceting_of(options.model, machine, file.tree));
  if (scene.box.empty()) throw InputError(options.model.model + ": nothing to draw; every solid is empty");
  const auto subject = std::make_shared<Subject>(Subject{std::move(file.tree), std::move(scene), std::move(file.hash)});
  const view::Camera camera = session::camera_of(options.model, machine, subject->tree, subject->scene);
  session::refuse_transparent_parts(session::emit_options_of(options.model), subject->tree, camera);
  const Inputs inputs{subject->hash, machines::hash_of(machine), session::version_and_build()};
  std::map<unsigned, Job> jobs;
  for (const unsigned bits : alu_bits) {
    ModelRequest one = options.model;
    one.machine = machine_name(options, bits);
    jobs[bits] = {subject, camera, {}, session::machine_of(one), {}, inputs};
  }
  return jobs;
}

ModelRequest with_searched(const AdviseOptions& options, const DesignPoint& point) {
  ModelRequest one = options.model;
  for (const Searched& axis : searched) {
    if (const std::string value = find_axis(axis.key)->text(point); !value.empty()) put(one, axis.key, value);
  }
  return one;
}

}  // namespace

ModelRequest AdviseOptions::design(const DesignPoint& point) const {
  ModelRequest one = with_searched(*this, point);
  one.machine = machine_name(*this, point.alu_bits);
  return one;
}

Texts advise_only_options() {
  return {"max-bits", "max-wrong-pixels", "min-fps",   "min-colour-bits", "z-bits",  "fraction-bits", "colour-bits",
          "strategy", "stack-bits",       "colouring", "alu-bits",        "machine", "output",        "threads",
          "no-plots", "progress",         "set",       "report",          "quiet"};
}

Job AdviceSearch::make_job(const AdviseOptions& options, const DesignPoint& point) const {
  const ModelRequest design = with_searched(options, point);
  Job job = jobs.at(point.alu_bits);
  job.sampling = session::sampling_of(design, job.machine);
  job.options = session::emit_options_of(design);
  return job;
}

AdviceSearch make_search(const AdviseOptions& options) {
  const machines::Machine machine = session::machine_of(options.model);
  const std::vector<Dimension> dimensions = dimensions_of(options, machine);
  const std::vector<unsigned> widths = alu_widths(options, machine);
  AdviceSearch question;
  question.jobs = jobs_of(options, machine, widths);
  const DesignGrid grid(options.model, dimensions);
  for (const ModelRequest& design : grid.designs()) {
    DesignPoint point = point_of(design, machine.picture);
    for (const unsigned alu_bits : widths) {
      point.alu_bits = alu_bits;
      question.points.push_back(point);
    }
  }
  for (const std::string& bits : parse_values("colour-bits", options.colour_bits))
    question.measured.colour_bits.push_back(static_cast<unsigned>(std::stoul(bits)));
  question.measured.max_bits = std::max(machine.array.memory_bits, max_fitted_bits);
  question.requirements = {options.max_bits.value_or(machine.array.memory_bits),
                           options.max_wrong_pixels.value_or(default_wrong_pixels), options.min_fps.value_or(0.0),
                           options.min_colour_bits.value_or(std::ranges::max(question.measured.colour_bits))};
  return question;
}

std::string render_command(const AdviseOptions& options, const session::OptionList& command, const AdviceRow& row,
                           const std::string& picture) {
  DesignPoint point = row.point;
  point.memory_bits = row.used_bits;
  const std::string machine = machine_name(options, point.alu_bits);
  constexpr std::string_view given[] = {"size", "curves", "pruning"};
  return "csgsim render " + shell_word(options.model.model) +
         join_given_options(command, advise_only_options(), options.model.sets) +
         (machine != ModelRequest().machine ? shell_option("machine", machine) : "") + render_options(point, given) +
         " --check" + shell_option("output", picture);
}

report::Picture picture_of(const AdviseOptions& options, const AdviceRow& row, const std::string& caption) {
  ModelRequest model = options.design(row.point);
  model.memory_bits = row.used_bits;
  return session::picture_of(model, session::machine_of(model), caption);
}

void AdviseOptions::add_to(session::OptionList& command) {
  model.add_to(command);
  command.remove("--memory-bits");
  for (const Searched& one : searched) command.remove(std::string("--") + one.key);
  command
      .option("--max-bits", max_bits,
              "Requirement: maximum memory bits per pixel; default: as in the machine's description")
      .between(1U, isa::max_memory_bits);
  command.option("--max-wrong-pixels", max_wrong_pixels,
                 fmt::format("Requirement: maximum number of pixels that differ from the exact picture; default: {}",
                             default_wrong_pixels));
  command.option("--min-fps", min_fps, "Requirement: minimum frames per second; default: no minimum")
      .check(not_negative);
  command
      .option("--min-colour-bits", min_colour_bits,
              "Requirement: minimum colour bits; default: the maximum of --colour-bits")
      .between(isa::minimum_colour_bits, isa::max_colour_bits);
  const auto add = [&](const char* key, std::string& list, const std::string& help) {
    command.option(std::string("--") + key, list, help).check(session::check_by_parsing([key](const std::string& text) {
      return parse_values(key, text);
    }));
  };
  add("strategy", strategies,
      fmt::format("Searched: list of {}; default: all strategies of the machine",
                  fmt::join(fixed_names_of(emit::strategies), ", ")));
  add("stack-bits", stack_bits, "Searched: numbers of stack bits, for strategy bits");
  add("z-bits", z_bits, "Searched: numbers of depth bits");
  add("fraction-bits", fraction_bits, "Searched: numbers of fraction bits of the planes' coefficients");
  add("colour-bits", colour_bits, "Searched: numbers of colour bits");
  add("colouring", colourings, "Searched: list of rebroadcast, field");
  add("alu-bits", alu_bits,
      "Searched: numbers of bits that a pixel's ALU processes per clock; default: as in the machine's description");
}

}  // namespace csgsim::studies
