#include "tests/performance/runs.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "hw/base/error.h"
#include "hw/base/output_file.h"
#include "tests/performance/subjects.h"

namespace csgsim::bench {

namespace {

constexpr unsigned grid_cubes = 64;
constexpr unsigned sphere_fragments = 32;

std::filesystem::path stats_path(const Settings& settings) { return settings.folder / "run.json"; }

}  // namespace

std::vector<Settings> build_settings(const Settings& settings) {
  std::vector<Settings> sides{settings};
  if (settings.beside.empty()) return sides;
  Settings& other = sides.emplace_back(settings);
  other.csgsim = settings.beside;
  other.folder = settings.folder / "beside";
  std::filesystem::create_directories(other.folder);
  return sides;
}

std::filesystem::path put_model(const Settings& settings, const std::string& name, const std::string& text) {
  std::filesystem::path path = settings.folder / (name + ".csg");
  write_file(path, text);
  return path;
}

std::vector<std::filesystem::path> all_models(const Settings& settings) {
  std::vector<std::filesystem::path> models = settings.models;
  models.push_back(put_model(settings, fmt::format("grid_{}", grid_cubes), grid_of_cubes(grid_cubes)));
  models.push_back(put_model(settings, fmt::format("sphere_{}", sphere_halfspaces(sphere_fragments)),
                             drilled_sphere(sphere_fragments)));
  return models;
}

std::filesystem::path program_path(const Settings& settings, const std::filesystem::path& model,
                                   const std::string& machine, const std::string& size) {
  return settings.folder /
         fmt::format("{}-{}-{}.csgt", model.stem().native(), std::filesystem::path(machine).stem().native(), size);
}

Words compile_words(const Settings& settings, const std::filesystem::path& model, const Compiled& compiled,
                    const std::string& size) {
  return {settings.csgsim.native(),
          "compile",
          model.native(),
          "--machine",
          compiled.machine,
          "--size",
          size,
          "--view-all",
          "-o",
          compiled.program.native()};
}

Compiled compile(const Settings& settings, const std::filesystem::path& model, const std::string& machine,
                 const std::string& size) {
  Compiled compiled{program_path(settings, model, machine, size), machine};
  process_seconds(compile_words(settings, model, compiled, size));
  return compiled;
}

Words run_words(const Settings& settings, const Compiled& compiled, const std::string& level, unsigned threads) {
  Words words{
      settings.csgsim.native(), "run", compiled.program.native(), "--machine", compiled.machine, "--level", level};
  if (threads > 1) words.insert(words.end(), {"--threads", std::to_string(threads)});
  words.insert(words.end(), {"--stats", stats_path(settings).native()});
  return words;
}

Ran run(const Settings& settings, const Words& words) {
  process_seconds(words);
  const nlohmann::json stats = nlohmann::json::parse(std::ifstream(stats_path(settings)));
  return {stats.at("clocks"), stats.at("simulated_seconds"), stats.at("wall_seconds")};
}

double process_seconds(const Words& words) { return run_to_end(words).wall; }

ProcessCost run_to_end(const Words& words) {
  const std::optional<ProcessCost> cost = run_process(words);
  if (!cost) throw InputError(words.front() + ": cannot be run; is it there, and executable?");
  return *cost;
}

}  // namespace csgsim::bench
