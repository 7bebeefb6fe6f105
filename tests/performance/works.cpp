#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "places.h"
#include "tests/performance/process.h"
#include "tests/performance/runs.h"
#include "tests/performance/subjects.h"

namespace csgsim::bench {

namespace {

constexpr unsigned million_fragments = 1416;  ///< fragments of a sphere with 1,001,114 half-spaces
constexpr unsigned holes = 857;
constexpr unsigned hole_facets = 583;
constexpr const char* machine = "pixel-planes-4";

/// The stand-ins for the thesis's models, with the cameras of the pages.
struct StandIn {
  std::string_view name;
  std::string_view camera;
};
constexpr StandIn carburettor{"carburettor", "220,-255,135,2,0,5"};
constexpr StandIn vehicle{"terrain_vehicle", "560,-590,420,-5,0,68"};
constexpr StandIn house{"rietveld_house", "3430,-2900,1950,590,230,220"};
constexpr std::array stand_ins{carburettor, vehicle, house};

/// A path relative to the current folder.
std::string source(std::string_view path) {
  return std::filesystem::proximate(std::filesystem::path(CSGSIM_SOURCE_DIR) / path).native();
}

/// A command of a row.
struct Step {
  Words words;
  std::filesystem::path folder{};  ///< folder of a study, removed before it starts, as it would otherwise resume
};
using Steps = std::vector<Step>;

/// The command `csgsim COMMAND MODEL` on a stand-in.
Words of_stand_in(const Settings& settings, const std::string& command, const StandIn& model) {
  return {settings.csgsim.native(), command, source(fmt::format("tests/models/{}.csg", model.name)), "--camera",
          std::string(model.camera)};
}

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// A study of each stand-in.
Steps studies(const Settings& settings, const std::string& study) {
  Steps all;
  for (const StandIn& model : stand_ins) {
    const std::filesystem::path folder = settings.folder / fmt::format("{}-{}", study, model.name);
    all.push_back(
        {with(of_stand_in(settings, study, model), {"--no-plots", "--progress", "none", "-o", folder.native()}),
         folder});
  }
  return all;
}

Compiled million(const Settings& settings) { return {settings.folder / "million.csgt", machine}; }

Words shadowed(const Settings& settings, const Words& more) {
  return with(
      of_stand_in(settings, "render", vehicle),
      with({"--scene", source("tests/scenes/shadows.toml"), "-o", (settings.folder / "shadows.png").native()}, more));
}

/// A row of the table: the steps of one build, in order.
struct WorkRow {
  std::string_view name;
  std::string_view what;
  Steps (*steps)(const Settings& settings);
  double halfspaces = 0;  ///< half-spaces of the model, if memory is stated per half-space
};

Steps picture(const Settings& settings) {
  return {{{settings.csgsim.native(), "render", source("tests/models/thesis_fig_2_3.csg"), "--size", settings.size,
            "-o", (settings.folder / "picture.png").native()}}};
}

Steps reference(const Settings& settings) {
  const Compiled compiled = compile(settings, source("tests/models/carburettor.csg"), machine, settings.size);
  return {{run_words(settings, compiled, "reference")}};
}

/// Writes the Program used by million_run.
Steps million_compile(const Settings& settings) {
  const auto model = put_model(settings, "million", drilled_sphere(million_fragments));
  return {{compile_words(settings, model, million(settings), settings.size)}};
}

Steps million_run(const Settings& settings) {
  if (!std::filesystem::exists(million(settings).program)) process_seconds(million_compile(settings).front().words);
  return {{run_words(settings, million(settings), "functional")}};
}

Steps plate(const Settings& settings) {
  const auto model = put_model(settings, "plate", drilled_plate(holes, hole_facets, 1));
  return {{compile_words(settings, model, {settings.folder / "plate.csgt", machine}, settings.size)}};
}

Steps shadows(const Settings& settings) { return {{shadowed(settings, {"--memory-bits", "96"})}}; }

Steps shadows_four(const Settings& settings) {
  return {{shadowed(settings, {"--memory-bits", "208", "--set", "effects.antialias.samples=4"})}};
}

Steps sweep(const Settings& settings) { return studies(settings, "sweep"); }
Steps accuracy(const Settings& settings) { return studies(settings, "accuracy"); }
Steps compare(const Settings& settings) { return studies(settings, "compare"); }

const std::array rows{
    WorkRow{"picture", "a small picture, from start to PNG", picture},
    WorkRow{"reference", "the carburettor at the reference level", reference},
    WorkRow{"million-compile", "compiling a sphere of 1,001,114 half-spaces", million_compile,
            static_cast<double>(sphere_halfspaces(million_fragments))},
    WorkRow{"million-run", "running that", million_run},
    WorkRow{"plate", "compiling a plate with 857 holes of 583 facets", plate, static_cast<double>(holes) * hole_facets},
    WorkRow{"shadows", "the vehicle with shadows", shadows},
    WorkRow{"shadows-4", "the same with four samples a pixel", shadows_four},
    WorkRow{"sweep", "sweeps of the carburettor, the vehicle and the house", sweep},
    WorkRow{"accuracy", "accuracy of the three", accuracy},
    WorkRow{"compare", "the three compared on all machines", compare},
};

/// Total seconds of all commands of a row. Sets `memory` to the peak of any of them.
double run_all(const Steps& steps, double& memory) {
  double seconds = 0;
  for (const Step& step : steps) {
    if (!step.folder.empty()) std::filesystem::remove_all(step.folder);
    const ProcessCost cost = run_to_end(step.words);
    seconds += cost.wall;
    memory = std::max(memory, cost.memory);
  }
  return seconds;
}

Whole measure(const Settings& settings, const WorkRow& row) {
  Whole whole{std::string(row.name), std::string(row.what), {}, {}, 0, 0, row.halfspaces};
  std::array<std::vector<Timed>, 2> timed;
  std::array<double*, 2> memories{&whole.memory, &whole.other_memory};
  const std::vector<Settings> sides = build_settings(settings);
  for (std::size_t side = 0; side < sides.size(); ++side) {
    const Steps steps = row.steps(sides[side]);
    if (side == 0)
      for (const Step& step : steps) whole.commands.push_back(command_text(step.words));
    timed.at(side).emplace_back([steps, &memory = *memories.at(side)] { return run_all(steps, memory); });
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

std::vector<Whole> measure_commands(const Settings& settings) {
  std::vector<Whole> all;
  for (const std::string& name : settings.works)
    all.push_back(measure(settings, *std::ranges::find(rows, name, &WorkRow::name)));
  return all;
}

}  // namespace csgsim::bench
