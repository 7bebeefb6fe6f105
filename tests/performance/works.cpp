#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

#include "places.h"
#include "tests/performance/process.h"
#include "tests/performance/runs.h"
#include "tests/performance/subjects.h"

namespace csgsim::bench {

namespace {

constexpr unsigned million_fragments = 1416;  ///< of a sphere of 1,001,114 half-spaces
constexpr unsigned holes = 857;
constexpr unsigned hole_facets = 583;
constexpr const char* machine = "pixel-planes-4";

/// The stand-ins for the thesis's models, as the pages look at them.
struct StandIn {
  std::string_view name;
  std::string_view camera;
};
constexpr StandIn carburettor{"carburettor", "220,-255,135,2,0,5"};
constexpr StandIn vehicle{"terrain_vehicle", "560,-590,420,-5,0,68"};
constexpr StandIn house{"rietveld_house", "3430,-2900,1950,590,230,220"};
constexpr std::array stand_ins{carburettor, vehicle, house};

/// As seen from the folder that this runs in.
std::string source(std::string_view path) {
  return std::filesystem::proximate(std::filesystem::path(CSGSIM_SOURCE_DIR) / path).native();
}

/// `csgsim COMMAND MODEL` of a stand-in.
Words of_stand_in(const Settings& settings, const std::string& command, const StandIn& model) {
  return {settings.csgsim.native(), command, source(fmt::format("tests/models/{}.csg", model.name)), "--camera",
          std::string(model.camera)};
}

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// A study of each of the stand-ins, into a new folder.
std::vector<Words> studies(const Settings& settings, const std::string& study) {
  std::vector<Words> all;
  for (const StandIn& model : stand_ins) {
    const std::filesystem::path folder = settings.folder / fmt::format("{}-{}", study, model.name);
    all.push_back(
        with(of_stand_in(settings, study, model), {"--no-plots", "--progress", "none", "-o", folder.native()}));
  }
  return all;
}

Compiled million(const Settings& settings) { return {settings.folder / "million.csgt", machine}; }

Words shadowed(const Settings& settings, const Words& more) {
  return with(
      of_stand_in(settings, "render", vehicle),
      with({"--scene", source("tests/scenes/shadows.toml"), "-o", (settings.folder / "shadows.png").native()}, more));
}

/// A row of the table: the commands, in order, of one build.
struct WorkRow {
  std::string_view name;
  std::string_view what;
  std::vector<Words> (*commands)(const Settings& settings);
  double halfspaces = 0;  ///< of the model, where memory is told for these
};

std::vector<Words> picture(const Settings& settings) {
  return {{settings.csgsim.native(), "render", source("tests/models/thesis_fig_2_3.csg"), "--size", settings.size, "-o",
           (settings.folder / "picture.png").native()}};
}

std::vector<Words> reference(const Settings& settings) {
  const Compiled compiled = compile(settings, source("tests/models/carburettor.csg"), machine, settings.size);
  return {run_words(settings, compiled, "reference")};
}

/// Writes the Program that million_run needs.
std::vector<Words> million_compile(const Settings& settings) {
  const auto model = put_model(settings, "million", drilled_sphere(million_fragments));
  return {compile_words(settings, model, million(settings), settings.size)};
}

std::vector<Words> million_run(const Settings& settings) {
  if (!std::filesystem::exists(million(settings).program)) whole_process(million_compile(settings).front());
  return {run_words(settings, million(settings), "functional")};
}

std::vector<Words> plate(const Settings& settings) {
  const auto model = put_model(settings, "plate", drilled_plate(holes, hole_facets, 1));
  return {compile_words(settings, model, {settings.folder / "plate.csgt", machine}, settings.size)};
}

std::vector<Words> shadows(const Settings& settings) { return {shadowed(settings, {"--memory-bits", "96"})}; }

std::vector<Words> shadows_four(const Settings& settings) {
  return {shadowed(settings, {"--memory-bits", "208", "--set", "effects.antialias.samples=4"})};
}

std::vector<Words> sweep(const Settings& settings) { return studies(settings, "sweep"); }
std::vector<Words> accuracy(const Settings& settings) { return studies(settings, "accuracy"); }
std::vector<Words> compare(const Settings& settings) { return studies(settings, "compare"); }

const std::array rows{
    WorkRow{"picture", "a small picture, from start to PNG", picture},
    WorkRow{"reference", "the carburettor at the reference level", reference},
    WorkRow{"million-compile", "compiling a sphere of 1,001,114 half-spaces", million_compile,
            static_cast<double>(sphere_halfspaces(million_fragments))},
    WorkRow{"million-run", "running that", million_run},
    WorkRow{"plate", "compiling a plate with 857 holes of 583 facets", plate, static_cast<double>(holes) * hole_facets},
    WorkRow{"shadows", "the vehicle with shadows", shadows},
    WorkRow{"shadows-4", "the same with four samples a pixel", shadows_four},
    WorkRow{"sweep", "sweeps of the three stand-ins", sweep},
    WorkRow{"accuracy", "accuracy of the three", accuracy},
    WorkRow{"compare", "the three compared on all machines", compare},
};

/// Of all commands of a row: the sum of their seconds. `memory` becomes the most that one of them took.
double run_all(const std::vector<Words>& commands, double& memory) {
  double seconds = 0;
  for (const Words& words : commands) {
    const Took took = took_by(words);
    seconds += took.wall;
    memory = std::max(memory, took.memory);
  }
  return seconds;
}

Whole measure(const Settings& settings, const WorkRow& row) {
  Whole whole{std::string(row.name), std::string(row.what), {}, {}, 0, 0, row.halfspaces};
  std::array<std::vector<Timed>, 2> timed;
  std::array<double*, 2> memories{&whole.memory, &whole.other_memory};
  const std::vector<Settings> sides = sides_of(settings);
  for (std::size_t side = 0; side < sides.size(); ++side) {
    const std::vector<Words> commands = row.commands(sides[side]);
    if (side == 0) std::ranges::transform(commands, std::back_inserter(whole.commands), command_text);
    timed.at(side).emplace_back([commands, &memory = *memories.at(side)] { return run_all(commands, memory); });
  }
  whole.wall = compare_in_turn(timed[0], timed[1], settings.rounds).front();
  return whole;
}

}  // namespace

std::vector<std::string> work_names() {
  std::vector<std::string> names;
  for (const WorkRow& row : rows) names.emplace_back(row.name);
  return names;
}

std::vector<Whole> measure_works(const Settings& settings) {
  std::vector<Whole> all;
  for (const std::string& name : settings.works)
    all.push_back(measure(settings, *std::ranges::find(rows, name, &WorkRow::name)));
  return all;
}

}  // namespace csgsim::bench
