#include <fmt/format.h>

#include <array>

#include "host/facet/geometry.h"
#include "host/read/read.h"
#include "host/view/camera.h"
#include "hw/base/error.h"
#include "hw/base/output_file.h"
#include "tests/performance/povray.h"
#include "tests/performance/process.h"
#include "tests/performance/runs.h"

namespace csgsim::bench {

namespace {

constexpr unsigned side = 512;    // size of the pictures in pixels
constexpr unsigned longest = 20;  // time limit of another program in seconds

/// OpenSCAD draws with OpenGL and needs a display, a real one or Xvfb.
Words openscad_words(const std::filesystem::path& model, const std::filesystem::path& picture, bool exact) {
  Words words{"openscad"};
  if (exact) words.emplace_back("--render");
  words.insert(words.end(), {"-q", "--viewall", "--autocenter", fmt::format("--imgsize={0},{0}", side), "-o",
                             picture.native(), model.native()});
  return words;
}

/// POV-Ray on one thread, like csgsim.
Words povray_words(const Settings& settings, const std::filesystem::path& model) {
  const model::Tree tree = read::read_csg_file(model);
  const facet::Geometry scene = facet::make_geometry(tree);
  const view::Camera camera = view::view_all(view::default_camera(scene.box, side, side), scene.box, side, side);
  const std::filesystem::path file = settings.folder / (model.stem().native() + ".pov");
  write_file(file, povray_scene(tree, scene, camera));
  return {"povray",
          "-D",
          "-GA",
          "+WT1",
          fmt::format("+W{}", side),
          fmt::format("+H{}", side),
          "+I" + file.native(),
          "+O" + (settings.folder / "povray.png").native()};
}

/// Reason why another program cannot be run on this computer.
struct NotMeasured {
  std::string reason;
};

double seconds_of(const Words& words) {
  try {
    if (const std::optional<ProcessCost> cost = run_process_within(longest, words)) return cost->wall;
  } catch (const InputError& error) {
    throw NotMeasured{error.what()};
  }
  throw NotMeasured{"not installed"};
}

/// Measures a rival in turns with csgsim, which draws the same picture into a PNG.
Rival rival_of(const Settings& settings, const std::filesystem::path& model, const Words& words) {
  const Words ours{settings.csgsim.native(),
                   "render",
                   model.native(),
                   "--view-all",
                   "--size",
                   fmt::format("{0}x{0}", side),
                   "-o",
                   (settings.folder / "csgsim.png").native()};
  Rival rival{model.stem().native(), command_text(words), {}, 0, command_text(ours), 0};
  const std::array<Timed, 2> timed{[&] { return seconds_of(words); }, [&] { return process_seconds(ours); }};
  try {
    const std::vector<double> medians = medians_in_turn(timed, settings.rounds);
    rival.rival = medians[0];
    rival.csgsim = medians[1];
  } catch (const NotMeasured& why) {
    rival.reason = why.reason;
  }
  return rival;
}

}  // namespace

std::vector<Rival> measure_rivals(const Settings& settings) {
  std::vector<Rival> rivals;
  for (const std::filesystem::path& model : all_models(settings)) {
    for (const bool exact : {false, true})
      rivals.push_back(rival_of(settings, model, openscad_words(model, settings.folder / "openscad.png", exact)));
    rivals.push_back(rival_of(settings, model, povray_words(settings, model)));
  }
  return rivals;
}

}  // namespace csgsim::bench
