#include <fmt/format.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/facet/faceting.h"
#include "hw/base/error.h"
#include "hw/base/output_file.h"
#include "hw/base/text.h"
#include "sim/app/commands/commands.h"
#include "sim/shell/memory.h"
#include "sim/shell/model_options.h"
#include "sim/shell/numbers.h"
#include "sim/shell/options.h"
#include "sim/shell/paths.h"
#include "sim/shell/usage.h"
#include "sim/software/convert/boundary.h"
#include "sim/software/convert/formats.h"
#include "sim/software/convert/surface.h"

namespace csgsim::app {

namespace {

namespace convert = software::convert;

struct Options {
  ModelOptions model;
  std::string output;
  std::string stats;
  bool ascii = false;
};

const convert::Format& format_asked(const Options& options) {
  std::string endings;
  for (const convert::Format* const one : convert::formats())
    endings += fmt::format("{}{}", endings.empty() ? "" : ", ", one->ending);
  const convert::Format* const format = convert::format_of(options.output);
  if (format == nullptr) throw UsageError("--output", fmt::format("the name ends in none of {}", endings));
  if (options.ascii && !format->has_text)
    throw UsageError("--ascii", fmt::format("a {} file has one form; leave it out", format->ending));
  return *format;
}

facet::Faceting faceting_asked(const Options& options) {
  if (!options.model.tolerance) return {};
  if (options.model.tolerance->in_pixels)
    throw UsageError("--tolerance", "nothing is drawn, so that a tolerance is in model units: 0.1");
  return {.tolerance = options.model.tolerance->value};
}

model::Tree solid_model(const Options& options) {
  model::Tree tree = read_model(options.model);
  if (tree.is_flat) {
    throw InputError(fmt::format("{}: the model is flat, and only solids have a boundary of faces; extrude it",
                                 printable(shown_name(options.model.model))));
  }
  return tree;
}

void print(const Options& options, const model::Tree& tree, const convert::Surface& surface,
           const convert::Measures& measures) {
  const model::Counts counts = model::count(tree);
  fmt::print("{:<18}{}, {}, {}, {}\n", "model", counted(counts.primitives, "primitive"),
             counted(counts.unions, "union"), counted(counts.differences, "difference"),
             counted(counts.intersections, "intersection"));
  fmt::print("{:<18}{}, {}\n", "mesh", counted(surface.triangles.size(), "triangle"),
             counted(surface.points.size(), "point"));
  fmt::print("{:<18}{}, Euler number {}, genus {}\n", "shape", counted(measures.shells, "shell"), measures.euler,
             measures.genus());
  fmt::print("{:<18}{:.10g} cubic units, surface {:.10g} square units\n", "volume", measures.volume, measures.area);
  fmt::print("{:<18}written\n", printable(options.output));
}

std::string stats_text(const Options& options, const model::Tree& tree, const convert::Surface& surface,
                       const convert::Measures& measures, double seconds) {
  const nlohmann::ordered_json json{{"model", options.model.model},     {"primitives", model::count(tree).primitives},
                                    {"pieces", tree.primitives.size()}, {"triangles", surface.triangles.size()},
                                    {"points", surface.points.size()},  {"shells", measures.shells},
                                    {"euler_number", measures.euler},   {"genus", measures.genus()},
                                    {"volume", measures.volume},        {"area", measures.area},
                                    {"wall_seconds", seconds}};
  return json.dump(2) + "\n";
}

void run(const Options& options) {
  const convert::Format& format = format_asked(options);
  const facet::Faceting faceting = faceting_asked(options);
  refuse_clashes(options.model.inputs(), std::to_array<std::filesystem::path>({options.output, options.stats}));
  if (!options.ascii) refuse_terminal("--output", options.output);
  OutputFile file(options.output);
  std::optional<OutputFile> stats;
  if (!options.stats.empty()) stats.emplace(options.stats);
  const auto begin = std::chrono::steady_clock::now();
  const model::Tree tree = solid_model(options);
  const Work work(options.model.limit * std::uint64_t{1'000'000});
  const convert::Surface surface =
      with_memory_for("the mesh", [&] { return convert::make_surface(convert::boundary(tree, faceting, work)); });
  const convert::Measures measures = convert::measure(surface);
  file.write(format.write(surface, {.is_text = options.ascii}));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  if (stats) stats->write(stats_text(options, tree, surface, measures, seconds.count()));
  std::vector<OutputFile*> files{&file};
  if (stats) files.push_back(&*stats);
  commit_all(files);
  print(options, tree, surface, measures);
}

}  // namespace

void add_convert(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command command = line.add("convert", "Convert a model into a mesh: the boundary of what its tree leaves, closed",
                             "Example:\n  csgsim convert carburettor.csg -o carburettor.stl\n"
                             "Curved solids are converted in facets. What is written how: docs/convert.md.");
  options->model.add_to(command);
  for (const char* const of_pictures :
       {"--machine", "--memory-bits", "--z-bits", "--strategy", "--stack-bits", "--colouring", "--pruning", "--size",
        "--camera", "--projection", "--scene", "--colour-scheme", "--set", "--view-all", "--near", "--fraction-bits",
        "--edge-on", "--curves", "--colour-bits"})
    command.remove(of_pictures);
  std::string endings;
  for (const convert::Format* const one : convert::formats())
    endings += fmt::format("; {}: {}", one->ending, one->help);
  command.option("-o,--output", options->output, "The mesh" + endings).required().check(not_empty);
  command.flag("--ascii", options->ascii, "Write STL as text");
  command.option("--stats", options->stats, "What was converted, .json").check(not_empty);
  command.prints_summary();
  command.runs([options] { run(*options); });
}

}  // namespace csgsim::app
