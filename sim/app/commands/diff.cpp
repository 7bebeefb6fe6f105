#include <fmt/format.h>

#include <array>
#include <bit>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "hw/isa/facts.h"
#include "hw/isa/text.h"
#include "sim/app/commands/commands.h"
#include "sim/lockstep/comparison.h"
#include "sim/observe/stats_json.h"
#include "sim/report/two_page.h"
#include "sim/session/model/model_request.h"
#include "sim/session/model/program_of.h"
#include "sim/session/model/subject.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/prunings.h"
#include "sim/session/options/read_by.h"
#include "sim/session/options/sets.h"
#include "sim/session/options/usage.h"
#include "sim/session/run/explain.h"
#include "sim/session/run/memory.h"
#include "sim/session/run/report_option.h"
#include "sim/session/run/run_request.h"
#include "sim/story/phrases.h"
#include "sim/story/story.h"
#include "sim/story/story_text.h"

namespace csgsim::app {

namespace {

/// Options of A or of B, the two sides of the comparison.
struct SideOptions {
  std::string subject;
  std::string machine;
  std::string level = "functional";
  std::string strategy;
  std::string pruning;
  std::vector<std::string> sets;
};

struct Options {
  ModelRequest both;
  SideOptions a;
  SideOptions b;
  bool no_stories = false;
  ReportOption report;
};

/// A Program and its machine, ready to run as A or B.
struct Subject {
  std::string name;
  std::string level;
  machines::Machine machine;
  isa::Program program;
};

ModelRequest options_of(const ModelRequest& both, const SideOptions& side) {
  ModelRequest options = both;
  options.model = side.subject;
  if (!side.machine.empty()) options.machine = side.machine;
  if (!side.strategy.empty()) options.strategy = side.strategy;
  if (!side.pruning.empty()) options.pruning = side.pruning;
  options.sets.insert(options.sets.end(), side.sets.begin(), side.sets.end());
  return options;
}

/// Loads or compiles one side. `is_machine_given`: --machine was given for both sides.
Subject subject_of(const ModelRequest& both, const SideOptions& side, bool is_machine_given) {
  const ModelRequest options = options_of(both, side);
  ProgramOnMachine found = program_of(options, is_machine_given || !side.machine.empty() ? options.machine : "");
  return {printable(side.subject), side.level, std::move(found.machine), std::move(found.program)};
}

/// Rejects compile options for a side that is a Program.
void refuse_misuse(const Options& options, const OptionList& command) {
  const bool is_model_a = is_model(options.a.subject);
  const bool is_model_b = is_model(options.b.subject);
  for (const auto& [side, is_one, letter] : {std::tuple(&options.a, is_model_a, "a"), {&options.b, is_model_b, "b"}}) {
    if (is_one) continue;
    for (const auto& [name, is_given] :
         {std::pair("strategy", !side->strategy.empty()), {"pruning", !side->pruning.empty()}}) {
      if (is_given)
        throw UsageError(fmt::format("--{}-{}", name, letter),
                         "is for models; a Program has been compiled already; leave it out");
    }
    refuse_scene_sets(side->sets, fmt::format("--set-{}", letter));
  }
  if (!is_model_a && !is_model_b)
    refuse_model_options(command, {"machine", "machine-a", "machine-b", "level-a", "level-b", "no-stories", "report",
                                   "set", "set-a", "set-b"});
  if (options.a.level == "cycle" && options.b.level == "cycle") {
    throw UsageError("--level-b",
                     "SystemC can clock only one machine per process; compare each side with the functional level, "
                     "whose bits and clocks are the same");
  }
}

void print_side(char letter, const Subject& subject, const engine::RunResult& result) {
  fmt::print("{}  {}: {}, {} level, {}, {}\n", letter, subject.name, subject.machine.name, subject.level,
             count_text(engine::Numbers(subject.program).count(), "instruction"), count_text(result.clocks, "clock"));
}

std::string instruction_text(const isa::Program& program, std::uint64_t number) {
  const engine::Numbers numbers(program);
  if (number >= numbers.count()) return "the end of the Program";
  const auto [segment, index] = numbers.place(number);
  const isa::Segment& part = program.segments[segment];
  std::string text = isa::text_of(part.instructions[index], program.facts->fields);
  if (program.segments.size() == 1) return text;
  return fmt::format("{}  (segment {}, {} x {} at {},{})", text, segment, part.region.width, part.region.height,
                     part.region.x, part.region.y);
}

void print_values(const lockstep::TwoValues& values, bool is_field) {
  fmt::print("  {:<16} A {}, B {}", printable(values.name), values.a, values.b);
  const std::uint64_t bits = values.a ^ values.b;
  if (is_field && std::bit_width(values.a | values.b) > 1)
    fmt::print(" ({:#x}, {:#x}: from bit {} on)", values.a, values.b, std::countr_zero(bits));
  fmt::print("\n");
}

void print_divergence(const lockstep::Divergence& found, const isa::Program& program) {
  const std::uint64_t number = engine::Numbers(program).of(found.place);
  fmt::print("after i{}, {}\n", number, instruction_text(program, number));
  if (!found.pixel) return print_values(found.otherwise.value(), false);
  fmt::print("{} differ, first {},{}:\n", count_text(found.pixel->pixels, "pixel"), found.pixel->x, found.pixel->y);
  for (const lockstep::TwoValues& values : found.pixel->fields) print_values(values, true);
}

void print_picture(const lockstep::Comparison& comparison, const Subject& a, const Subject& b) {
  if (!comparison.picture) return fmt::print("the pictures are equal\n");
  const lockstep::PictureDifference& found = *comparison.picture;
  fmt::print("the pictures differ at {}, first {},{}:\n", count_text(found.pixels, "pixel"), found.x, found.y);
  const std::size_t at = std::size_t{found.y} * a.program.shape.width + found.x;
  const auto print_both = [&](const char* what, const std::vector<std::uint32_t> observe::Frame::*values, auto text) {
    fmt::print("  {:<16} A {}, B {}\n", what, text(a.program, (comparison.a.frame.*values)[at]),
               text(b.program, (comparison.b.frame.*values)[at]));
  };
  print_both("owner", &observe::Frame::owner, story::primitive_text);
  print_both("depth", &observe::Frame::depth, story::depth_text);
  print_both("colour", &observe::Frame::colour, story::colour_text);
}

void print_story(char letter, const Subject& subject, std::uint32_t x, std::uint32_t y) {
  const story::Story history = story::StoryBuilder(subject.program, subject.machine).story_of(x, y);
  fmt::print("\n{}  {}", letter, story::text_of({subject.program}, history));
}

/// The first pixel that differs in the pictures, or else in pixel memory.
std::optional<std::pair<std::uint32_t, std::uint32_t>> first_other_pixel(const lockstep::Comparison& comparison) {
  if (comparison.picture) return std::pair{comparison.picture->x, comparison.picture->y};
  if (comparison.divergence && comparison.divergence->pixel)
    return std::pair{comparison.divergence->pixel->x, comparison.divergence->pixel->y};
  return std::nullopt;
}

void print_stories(const lockstep::Comparison& comparison, const Subject& a, const Subject& b) {
  const auto pixel = first_other_pixel(comparison);
  if (!pixel) return;
  print_story('A', a, pixel->first, pixel->second);
  print_story('B', b, pixel->first, pixel->second);
}

/// The comparison with A and B exchanged.
lockstep::Comparison swapped(lockstep::Comparison comparison) {
  std::swap(comparison.a, comparison.b);
  if (!comparison.divergence) return comparison;
  if (comparison.divergence->otherwise)
    std::swap(comparison.divergence->otherwise->a, comparison.divergence->otherwise->b);
  if (comparison.divergence->pixel)
    for (lockstep::TwoValues& values : comparison.divergence->pixel->fields) std::swap(values.a, values.b);
  return comparison;
}

/// Sentences for the report page about the first difference.
std::vector<std::string> difference_sentences(const lockstep::Comparison& comparison, const Subject& a,
                                              const Subject& b) {
  std::vector<std::string> sentences;
  if (const auto number = comparison.other_instruction) {
    sentences.push_back(fmt::format("The first instruction that differs is i{}: {} in A, {} in B.", *number,
                                    instruction_text(a.program, *number), instruction_text(b.program, *number)));
  } else {
    sentences.emplace_back("All instructions are the same.");
  }
  sentences.push_back(fmt::format("Pixel memory is equal after {}.", count_text(comparison.compared, "instruction")));
  if (const auto& found = comparison.picture) {
    sentences.push_back(fmt::format("Colour, primitive or depth differ at {}, first at {},{}.",
                                    count_text(found->pixels, "pixel"), found->x, found->y));
  } else {
    sentences.emplace_back("Pictures and depths are equal.");
  }
  return sentences;
}

/// The command that explains a pixel of one side, without its --pixel.
std::string explain_side(const OptionList& command, const SideOptions& side) {
  GivenTexts own;
  for (const auto& [key, text] :
       {std::pair("machine", &side.machine), {"strategy", &side.strategy}, {"pruning", &side.pruning}})
    if (!text->empty()) own.emplace_back(key, *text);
  for (const std::string& set : side.sets) own.emplace_back("set", set);
  return explain_command(command, side.subject, own);
}

report::ShownRun shown(const Subject& side, const lockstep::SideResult& run, std::string explain) {
  const observe::Report observed{side.program, side.machine, side.level, run.result, run.stats};
  const std::string& strategy = side.program.facts->compile.strategy;
  std::string name = side.name + " on " + side.machine.name;
  if (!strategy.empty()) name += ", strategy " + printable(strategy);
  return {std::move(name), {side.program, run.frame}, side.machine, observe::to_json(observed), std::move(explain)};
}

void write_page(ReportFile& page, const lockstep::Comparison& comparison, const Subject& a, const Subject& b,
                const Options& options, const OptionList& command) {
  if (!page.is_requested()) return;
  const machines::Machine machines[] = {a.machine, b.machine};
  const std::span shown_machines = std::span(machines).first(a.machine.name == b.machine.name ? 1 : 2);
  report::FirstDifference first{difference_sentences(comparison, a, b), std::nullopt};
  if (const auto pixel = first_other_pixel(comparison))
    first.pixel = std::size_t{pixel->second} * a.program.shape.width + pixel->first;
  page.write(report::two_page(shown(a, comparison.a, explain_side(command, options.a)),
                              shown(b, comparison.b, explain_side(command, options.b)), first,
                              options.report.context(shown_machines)));
}

lockstep::Comparison compare(const Subject& a, const Subject& b) {
  const std::unique_ptr<engine::Engine> a_engine = make_engine(a.machine, a.level, 1);
  const std::unique_ptr<engine::Engine> b_engine = make_engine(b.machine, b.level, 1);
  const lockstep::Side a_side{a.program, a.machine, *a_engine};
  const lockstep::Side b_side{b.program, b.machine, *b_engine};
  if (b.level == "cycle")
    return swapped(lockstep::compare(b_side, a_side));  // lockstep::compare stops B after each instruction, and the
                                                        // cycle level cannot stop
  return lockstep::compare(a_side, b_side);
}

void print_comparison(const lockstep::Comparison& comparison, const Subject& a, const Subject& b) {
  print_side('A', a, comparison.a.result);
  print_side('B', b, comparison.b.result);
  if (comparison.other_instruction) {
    const std::uint64_t number = *comparison.other_instruction;
    fmt::print("i{} is the first instruction that differs:\n  A  {}\n  B  {}\n", number,
               instruction_text(a.program, number), instruction_text(b.program, number));
  }
  fmt::print("the states are equal after {}\n", count_text(comparison.compared, "instruction"));
  if (comparison.divergence) print_divergence(*comparison.divergence, a.program);
  print_picture(comparison, a, b);
}

void diff(const Options& options, const OptionList& command) {
  refuse_misuse(options, command);
  ReportFile page(options.report, std::to_array<std::filesystem::path>({options.a.subject, options.b.subject}));
  const bool is_machine_given = command.is_given("machine");
  const Subject a = subject_of(options.both, options.a, is_machine_given);
  const Subject b = subject_of(options.both, options.b, is_machine_given);
  if (a.program.shape.width != b.program.shape.width || a.program.shape.height != b.program.shape.height) {
    throw InputError(
        fmt::format("A draws {} x {} pixels and B {} x {}; give both models the same --size, or compile both "
                    "Programs with one",
                    a.program.shape.width, a.program.shape.height, b.program.shape.width, b.program.shape.height));
  }
  const lockstep::Comparison comparison =
      with_memory_for_run({&a.program, 1}, a.program.shape, [&] { return compare(a, b); });
  refuse_overflow(comparison.a.result);
  refuse_overflow(comparison.b.result);
  print_comparison(comparison, a, b);
  write_page(page, comparison, a, b, options, command);
  const bool same_clocks = comparison.a.result.clocks == comparison.b.result.clocks;
  const bool has_other_clocks =
      !same_clocks && !comparison.other_instruction && machines::is_same_hardware(a.machine, b.machine);
  if (!comparison.divergence && !comparison.picture && !has_other_clocks) return;
  if (!options.no_stories) print_stories(comparison, a, b);
  throw InputError("A and B differ");
}

void add_side(Command& command, SideOptions& side, const std::string& letter) {
  const std::string name = letter == "a" ? "A" : "B";
  command.option("--machine-" + letter, side.machine, "Machine of " + name + ", if different")
      .check(check_by_parsing(check_machine));
  command.option("--level-" + letter, side.level, "Level of " + name).one_of(level_names(), "level");
  command.option("--strategy-" + letter, side.strategy, "Strategy of " + name + ", if different")
      .one_of(strategy_names(), "strategy");
  command.option("--pruning-" + letter, side.pruning, "Prunings applied to " + name + ", if different")
      .words(pruning_words(), check_by_parsing(parse_pruning));
  command.option("--set-" + letter, side.sets,
                 "A parameter of the machine of " + name + ", or a key of its scene; repeat for several");
}

void add_diff(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command& command = line.add(
      "diff", run_group, "Run two Programs, machines, levels or settings side by side and find the first difference",
      "Example:\n  csgsim diff old.csgt new.csgt\n  csgsim diff tests/models/carburettor.csg --size 64x64 --level-b "
      "cycle\n  csgsim diff part.csg --strategy-b list\nThe exit code is 1 if states, pictures or clocks "
      "differ.");
  command.option("A", options->a.subject, "A model (.csg, .scad or .jan) or a Program (.csgt)").required();
  command.option("B", options->b.subject, "The other model or Program; default: A");
  options->both.add_to(command);
  command.remove("MODEL");
  add_side(command, options->a, "a");
  add_side(command, options->b, "b");
  command.flag("--no-stories", options->no_stories, "Omit the histories of the first pixel that differs");
  options->report.add_to(command);
  command.add_quiet_option();
  command.set_action([options, &command] {
    if (options->b.subject.empty()) options->b.subject = options->a.subject;
    diff(*options, command);
  });
}

}  // namespace

extern const CommandRow diff_row{.name = "diff", .add = add_diff};

}  // namespace csgsim::app
