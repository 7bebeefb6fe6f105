#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "hw/base/output_file.h"
#include "hw/base/text.h"
#include "hw/isa/facts.h"
#include "sim/app/commands/commands.h"
#include "sim/observe/pictures.h"
#include "sim/observe/stats.h"
#include "sim/observe/stats_json.h"
#include "sim/report/pictures.h"
#include "sim/report/study_pages.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/model_request.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/progress.h"
#include "sim/session/run/report_option.h"
#include "sim/session/run/run_request.h"
#include "sim/studies/folder.h"

namespace csgsim::app {

namespace {

namespace fs = std::filesystem;

struct Options {
  ModelRequest model;
  std::string folder;
  ReportOption report;
};

/// A picture drawn with a subset of the effects.
struct Variant {
  isa::Program program;
  DrawnRun drawn;
  double seconds = 0;  ///< wall time of compilation and simulation
};

/// Compiles and draws with the effects `without` switched off, even if the scene or the model enables them.
Variant draw_without(const ModelRequest& all, const std::vector<std::string>& without,
                     const machines::Machine& machine) {
  const auto begin = std::chrono::steady_clock::now();
  isa::Program program = compile_model(all.without_effects(without), machine).program;
  const std::chrono::duration<double> compiled = std::chrono::steady_clock::now() - begin;
  DrawnRun drawn = draw(program, machine);
  const double seconds = compiled.count() + drawn.seconds;
  return {std::move(program), std::move(drawn), seconds};
}

/// Cost of an effect: the clocks that the frame charges to it, and the frame's clocks with and without it, once with
/// all other effects off and once with all others on.
struct Row {
  std::string name;
  observe::Cost billed;
  std::int64_t alone = 0;     ///< clocks it adds to a frame without effects
  std::int64_t together = 0;  ///< clocks that the full frame saves without it
  std::int64_t bits = 0;      ///< memory bits per pixel that the full frame saves without it
  double seconds = 0;         ///< wall time of the full frame, compiled and simulated, less that without it
};

struct Bill {
  Variant all;
  Variant none;
  std::vector<Row> rows;         ///< flat shading first
  std::vector<Variant> without;  ///< one per row except the first
};

std::vector<std::string> others(const std::vector<std::string>& names, const std::string& one) {
  std::vector<std::string> rest = names;
  std::erase(rest, one);
  return rest;
}

std::int64_t difference(std::uint64_t with, std::uint64_t without) {
  return static_cast<std::int64_t>(with) - static_cast<std::int64_t>(without);
}

/// `all_on`: drawn with all effects.
Bill make_bill(const ModelRequest& options, const machines::Machine& machine, Variant all_on) {
  Bill bill;
  bill.all = std::move(all_on);
  const std::vector<std::string>& all = bill.all.program.facts->compile.effects;
  const std::vector<std::string> called(all.begin() + 1, all.end());
  bill.none = draw_without(options, called, machine);
  bill.rows.push_back({all.front(), bill.all.drawn.stats.by_effect.front()});
  for (std::size_t i = 0; i < called.size(); ++i) {
    const Variant alone = draw_without(options, others(called, called[i]), machine);
    Variant without = draw_without(options, {called[i]}, machine);
    bill.rows.push_back(
        {called[i], bill.all.drawn.stats.by_effect[i + 1],
         difference(alone.drawn.result.clocks, bill.none.drawn.result.clocks),
         difference(bill.all.drawn.result.clocks, without.drawn.result.clocks),
         difference(observe::used_memory_bits(bill.all.program), observe::used_memory_bits(without.program)),
         bill.all.seconds - without.seconds});
    bill.without.push_back(std::move(without));
  }
  return bill;
}

std::string signed_text(std::int64_t number) {
  return (number < 0 ? "-" : "") + grouped(static_cast<std::uint64_t>(number < 0 ? -number : number));
}

void print_line(const std::string& name, const observe::Cost& cost, const std::string& rest = "") {
  fmt::print("  {:<16}{:>14}{:>14}{:>20}{}\n", name, grouped(cost.clocks), grouped(cost.instructions),
             grouped(cost.pixel_operations), rest);
}

void print_bill(const Bill& bill) {
  fmt::print("  {:<16}{:>14}{:>14}{:>20}{:>14}{:>14}{:>7}{:>10}\n", "", "clocks", "instructions", "pixel operations",
             "alone", "together", "bits", "wall s");
  print_line("solids", bill.all.drawn.stats.by_effect.back());
  for (const Row& row : bill.rows) {
    const bool is_flat = &row == &bill.rows.front();
    print_line(row.name, row.billed,
               is_flat ? ""
                       : fmt::format("{:>14}{:>14}{:>7}{:>10.3f}", signed_text(row.alone), signed_text(row.together),
                                     row.bits, row.seconds));
  }
  print_line("all instructions", bill.all.drawn.stats.total);
  fmt::print("  {:<16}{:>14}  including the link, the controller and the machine's other work\n", "frame",
             grouped(bill.all.drawn.result.clocks));
  fmt::print("  {:<16}{:>14}  {} of {} bits per pixel\n", "no effects", grouped(bill.none.drawn.result.clocks),
             observe::used_memory_bits(bill.none.program), observe::used_memory_bits(bill.all.program));
  fmt::print(
      "clocks, instructions and pixel operations: charged to the effect in the frame; alone: clocks that the effect\n"
      "adds to a frame without effects; together, bits, wall s: clocks, memory bits per pixel and seconds of "
      "compiling\n"
      "and simulating that the frame with all effects saves without the effect\n");
}

nlohmann::ordered_json cost_json(const observe::Cost& cost) {
  return {{"clocks", cost.clocks}, {"instructions", cost.instructions}, {"pixel_operations", cost.pixel_operations}};
}

nlohmann::ordered_json to_json(const Bill& bill) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Row& row : bill.rows) {
    nlohmann::ordered_json one{{"effect", row.name}};
    one.update(cost_json(row.billed));
    if (&row != &bill.rows.front()) {
      one["alone_clocks"] = row.alone;
      one["together_clocks"] = row.together;
      one["bits"] = row.bits;
      one["wall_seconds"] = row.seconds;
    }
    rows.push_back(std::move(one));
  }
  return {{"solids", cost_json(bill.all.drawn.stats.by_effect.back())},
          {"effects", rows},
          {"total", cost_json(bill.all.drawn.stats.total)},
          {"clocks", bill.all.drawn.result.clocks},
          {"clocks_without_effects", bill.none.drawn.result.clocks},
          {"bits", observe::used_memory_bits(bill.all.program)},
          {"bits_without_effects", observe::used_memory_bits(bill.none.program)},
          {"wall_seconds", bill.all.seconds},
          {"wall_seconds_without_effects", bill.none.seconds}};
}

void write(const fs::path& path, const Variant& variant) {
  OutputFile file(path);
  observe::write_picture(file, variant.drawn.frame, variant.program);
  file.commit();
}

void write_all(const Bill& bill, const studies::StudyFolder& folder) {
  write(folder.path() / "all.png", bill.all);
  write(folder.path() / "none.png", bill.none);
  for (std::size_t i = 0; i < bill.without.size(); ++i)
    write(folder.path() / ("without_" + bill.rows[i + 1].name + ".png"), bill.without[i]);
  write_file(folder.path() / "effects.json", to_json(bill).dump(2) + "\n");
}

report::Page page_of(const Options& options, const Bill& bill) {
  const auto picture = [](const Variant& variant, const std::string& what) {
    return report::picture_of(variant.drawn.frame, variant.program, what, "The model " + what);
  };
  std::vector<report::Picture> pictures{picture(bill.all, "with all effects"),
                                        picture(bill.none, "without any effect")};
  for (std::size_t i = 0; i < bill.without.size(); ++i)
    pictures.push_back(picture(bill.without[i], "without " + bill.rows[i + 1].name));
  return report::effects_page(to_json(bill), std::move(pictures),
                              plain_study_context(options.report, options.model.model, {{machine_of(options.model)}}));
}

void run(const Options& options) {
  const machines::Machine machine = machine_of(options.model);
  Variant all = draw_without(options.model, {}, machine);  // an invalid model leaves no folder
  const fs::path to = options.folder.empty() ? studies::default_output_folder(options.model.model, "effects")
                                             : fs::path(options.folder);
  const studies::StudyFolder folder(to, "effects", options.model.inputs());
  ReportFile report(options.report, options.model.inputs());
  const Bill bill = make_bill(options.model, machine, std::move(all));
  fmt::print("{} on {}: cost of its effects\n", printable(shown_name(options.model.model)), machine.name);
  print_bill(bill);
  if (report.is_requested()) report.write(page_of(options, bill));
  write_all(bill, folder);
  fmt::print("{}: all.png, none.png, a picture without each effect, effects.json\n", printable(to.native()));
}

void add_effects(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command& command =
      line.add("effects", study_group,
               "Show the cost of each effect of a scene, alone and together, and the picture without the effect",
               "Example:\n  csgsim effects carburettor.csg --scene shadows.toml --memory-bits 128 -o bill\n"
               "docs/effects.md lists the effects and their settings.");
  options->model.add_to(command);
  command
      .option("-o,--output", options->folder,
              "Folder for the pictures and the costs, effects.json; default: MODEL-effects")
      .folder();
  options->report.add_to(command);
  command.add_quiet_option();
  command.set_action([options] { run(*options); });
}

}  // namespace

extern const CommandRow effects_row{.name = "effects", .add = add_effects};

}  // namespace csgsim::app
