#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "host/facet/faceting.h"
#include "hw/base/error.h"
#include "hw/base/output_file.h"
#include "hw/base/seconds.h"
#include "hw/base/text.h"
#include "hw/base/work.h"
#include "sim/app/commands/commands.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/model_request.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/progress.h"
#include "sim/session/options/usage.h"
#include "sim/session/run/memory.h"
#include "sim/session/run/run_request.h"
#include "sim/software/convert/blocks.h"
#include "sim/software/convert/boundary.h"
#include "sim/software/convert/flat_rounds.h"
#include "sim/software/convert/formats.h"
#include "sim/software/convert/surface.h"

namespace csgsim::app {

namespace {

namespace convert = software::convert;

struct Options {
  ModelRequest model;
  std::string output;
  std::string format;  ///< empty: by the ending of the output's name
  std::string stats;
  bool ascii = false;
  std::optional<std::uint32_t> resolution;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
};

constexpr std::string_view block_ending = ".bintree";
constexpr std::uint32_t default_resolution = 64;

/// The endings of all formats.
std::vector<std::string> endings() {
  std::vector<std::string> all;
  for (const convert::Format* const one : convert::formats()) all.emplace_back(one->ending);
  all.emplace_back(block_ending);
  return all;
}

/// The endings without their dots.
std::vector<std::string> format_names() {
  std::vector<std::string> names = endings();
  for (std::string& name : names) name.erase(0, 1);
  return names;
}

/// A file name with the ending of the requested format.
std::string format_file(const Options& options) {
  return options.format.empty() ? options.output : "." + options.format;
}

bool writes_blocks(const Options& options) { return has_extension("a" + format_file(options), block_ending); }

const convert::Format& requested_format(const Options& options) {
  const convert::Format* const format = convert::format_of(format_file(options));
  if (format == nullptr && is_unnamed_stream(options.output))
    throw UsageError("--format", fmt::format("{} has no ending that selects a format; name one, as in --format stl",
                                             options.output));
  if (format == nullptr)
    throw UsageError("--output", fmt::format("'{}' has an unknown ending; end the name in one of {}, or name a format "
                                             "with --format",
                                             options.output, fmt::join(endings(), ", ")));
  if (options.resolution) throw UsageError("--resolution", "applies to .bintree files only; leave it out");
  if (options.ascii && !format->has_text)
    throw UsageError("--ascii", fmt::format("a {} file has only one form; leave it out", format->ending));
  return *format;
}

facet::Faceting requested_faceting(const Options& options) {
  if (!options.model.tolerance) return {};
  if (options.model.tolerance->is_in_pixels)
    throw UsageError("--tolerance", "convert has no pixels; give a tolerance in model units, as in 0.1");
  return {.tolerance = options.model.tolerance->value};
}

model::Tree converted_model(const Options& options, bool is_flat) {
  model::Tree tree = read_model(options.model);
  if (tree.root == model::no_index || tree.is_flat == is_flat) return tree;
  const std::string name = printable(shown_name(options.model.model));
  if (is_flat)
    throw InputError(fmt::format("{}: the model is solid; project it, or name a format of solids such as .stl", name));
  std::vector<std::string_view> flat;
  for (const convert::Format* const one : convert::formats())
    if (one->is_flat) flat.push_back(one->ending);
  throw InputError(fmt::format("{}: the model is flat; extrude it, or write {}", name, fmt::join(flat, " or ")));
}

void print_model(const model::Tree& tree) {
  const model::Counts counts = model::count(tree);
  fmt::print("{:<18}{}, {}, {}, {}\n", "model", count_text(counts.primitives, "primitive"),
             count_text(counts.unions, "union"), count_text(counts.differences, "difference"),
             count_text(counts.intersections, "intersection"));
}

nlohmann::ordered_json model_json(const Options& options, const model::Tree& tree) {
  return {{"model", options.model.model},
          {"primitives", model::count(tree).primitives},
          {"pieces", tree.primitives.size()}};
}

[[noreturn]] void refuse_empty(const Options& options) {
  throw InputError(fmt::format("{}: the model is empty; there is nothing to convert", shown_name(options.model.model)));
}

[[noreturn]] void refuse_thin(const Options& options, const convert::Measures& measures) {
  throw InputError(fmt::format(
      "{}: solids are too thin for their size, or too small for their distance from the origin: rounding "
      "coordinates to doubles may change the volume of the mesh, {:.3g}, by {:.3g}; make the solids thicker, or move "
      "them nearer to the origin if they are far from it",
      shown_name(options.model.model), measures.volume, measures.volume_error));
}

/// The output files, committed as a group: all of them or none.
class Outputs {
 public:
  explicit Outputs(const Options& options) : file_(options.output) {
    if (!options.stats.empty()) stats_.emplace(options.stats);
  }

  void write(std::string_view content, const nlohmann::ordered_json& stats) {
    file_.write(content);
    std::vector<OutputFile*> files{&file_};
    if (stats_) {
      stats_->write(stats.dump(2) + "\n");
      files.push_back(&*stats_);
    }
    commit_all(files);
  }

 private:
  OutputFile file_;
  std::optional<OutputFile> stats_;
};

Work work_of(const Options& options) { return Work(options.model.limit * std::uint64_t{1'000'000}); }

/// Counts and measures of a result, as JSON and as lines for people.
struct Description {
  nlohmann::ordered_json json;
  std::string lines;
};

Description describe_mesh(const convert::Surface& surface, const convert::Measures& measures) {
  return {{{"triangles", surface.triangles.size()},
           {"points", surface.points.size()},
           {"shells", measures.shells},
           {"euler_number", measures.euler},
           {"genus", measures.genus()},
           {"volume", measures.volume},
           {"area", measures.area}},
          fmt::format("{:<18}{}, {}\n{:<18}{}, Euler number {}, genus {}\n"
                      "{:<18}{:.10g} cubic units, surface {:.10g} square units\n",
                      "mesh", count_text(surface.triangles.size(), "triangle"),
                      count_text(surface.points.size(), "point"), "shape", count_text(measures.shells, "shell"),
                      measures.euler, measures.genus(), "volume", measures.volume, measures.area)};
}

Description describe_flat(const convert::Surface& surface) {
  const convert::Rounds rounds = convert::flat_rounds(surface);
  std::size_t points = 0;
  for (const auto& round : rounds) points += round.size();
  const double area = convert::area_of(rounds);
  return {{{"outlines", rounds.size()}, {"points", points}, {"area", area}},
          fmt::format("{:<18}{}, {}\n{:<18}{:.10g} square units\n", "shape", count_text(rounds.size(), "outline"),
                      count_text(points, "point"), "area", area)};
}

void convert_to_surface(const Options& options) {
  const convert::Format& format = requested_format(options);
  const facet::Faceting faceting = requested_faceting(options);
  if (format.is_binary && !options.ascii) refuse_terminal("--output", options.output);
  Outputs outputs(options);
  const auto begin = std::chrono::steady_clock::now();
  const model::Tree tree = converted_model(options, format.is_flat);
  const convert::Surface surface = with_memory_for("the mesh", [&] {
    return convert::make_surface(convert::boundary(tree, faceting, work_of(options), options.threads));
  });
  if (surface.triangles.empty()) refuse_empty(options);
  const convert::Measures measures = convert::measure(surface);
  if (!has_sure_volume(measures)) refuse_thin(options, measures);
  const std::string content = format.write(surface, {.is_text = options.ascii});
  const Description description = format.is_flat ? describe_flat(surface) : describe_mesh(surface, measures);
  nlohmann::ordered_json stats = model_json(options, tree);
  stats.update(description.json);
  stats["wall_seconds"] = seconds_since(begin);
  outputs.write(content, stats);
  print_model(tree);
  fmt::print("{}", description.lines);
}

void convert_to_blocks(const Options& options) {
  if (options.ascii) throw UsageError("--ascii", "a .bintree file has only one form; leave it out");
  const std::uint32_t resolution = options.resolution.value_or(default_resolution);
  if (!std::has_single_bit(resolution))
    throw UsageError("--resolution", fmt::format("{} is not a power of two, and blocks are halved; use {} or {}",
                                                 resolution, std::bit_floor(resolution), std::bit_ceil(resolution)));
  const facet::Faceting faceting = requested_faceting(options);
  Outputs outputs(options);
  const auto begin = std::chrono::steady_clock::now();
  const model::Tree tree = converted_model(options, false);
  const convert::Bintree bintree =
      with_memory_for("the blocks", [&] { return convert::blocks(tree, resolution, faceting, work_of(options)); });
  const convert::BlockCounts counts = convert::count_blocks(bintree);
  if (tree.root == model::no_index) refuse_empty(options);
  const double volume = static_cast<double>(counts.cells) * bintree.cell() * bintree.cell() * bintree.cell();
  nlohmann::ordered_json stats = model_json(options, tree);
  stats["resolution"] = resolution;
  stats["blocks"] = counts.blocks;
  stats["full_blocks"] = counts.full;
  stats["full_cells"] = counts.cells;
  stats["volume"] = volume;
  stats["wall_seconds"] = seconds_since(begin);
  outputs.write(convert::text_of(bintree), stats);
  print_model(tree);
  fmt::print("{:<18}{}, {} of them full; {} of side {:g} inside the model\n", "blocks", grouped(counts.blocks),
             grouped(counts.full), count_text(counts.cells, "cell"), bintree.cell());
  fmt::print("{:<18}{:.10g} cubic units\n", "volume", volume);
}

void run(const Options& options) {
  refuse_clashes(options.model.inputs(), std::to_array<std::filesystem::path>({options.output, options.stats}));
  if (writes_blocks(options)) {
    convert_to_blocks(options);
  } else {
    convert_to_surface(options);
  }
}

void add_convert(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command& command = line.add("convert", everyday_group,
                              "Convert a model into a closed mesh of its boundary, a drawing, or blocks of a bintree",
                              "Example:\n  csgsim convert carburettor.csg -o carburettor.stl\n"
                              "  csgsim convert -D size=3 part.scad -o - --format ply > part.ply\n"
                              "  csgsim convert carburettor.csg -o carburettor.bintree --resolution 128\n"
                              "Curved solids are converted as facets. docs/convert.md describes the formats.");
  options->model.add_to(command);
  for (const char* const of_pictures :
       {"--machine", "--memory-bits", "--z-bits", "--strategy", "--stack-bits", "--colouring", "--pruning", "--size",
        "--camera", "--projection", "--scene", "--colour-scheme", "--set", "--view-all", "--near", "--fraction-bits",
        "--edge-on", "--curves", "--colour-bits"})
    command.remove(of_pictures);
  std::string helps;
  for (const convert::Format* const one : convert::formats()) helps += fmt::format("; {}: {}", one->ending, one->help);
  command
      .option(
          "-o,--output", options->output,
          fmt::format("The file; the name's ending selects the format{}; {}: a bintree, as text", helps, block_ending))
      .required()
      .check(not_empty);
  command.option("--format", options->format, "The format, whatever the name's ending; needed for -o -")
      .one_of(format_names());
  command.flag("--ascii", options->ascii, "Write STL or PLY as text");
  command
      .option("--resolution", options->resolution,
              "Cells along each side of a block model, a power of two; default: 64")
      .between(convert::min_cells, convert::max_cells);
  command.option("--threads", options->threads, "Threads that build a mesh; the mesh does not depend on their number")
      .between(1U, max_threads);
  command.option("--stats", options->stats, "Counts and measures of the result, .json").check(not_empty);
  command.add_quiet_option();
  command.set_action([options] { run(*options); });
}

}  // namespace

extern const CommandRow convert_row{.name = "convert", .add = add_convert};

}  // namespace csgsim::app
