#pragma once

#include <string>
#include <vector>

#include "tests/support/drawing.h"

namespace csgsim::testing {

/// A file of tests/scenes. Its first line names the model and the other options that `csgsim render` needs:
/// `# model: NAME.csg --camera 1,2,3,4,5,6 --memory-bits 128`.
struct SceneFile {
  std::string name;
  std::string text;
  std::string model;  ///< path of the model
  view::Camera camera;
};

/// All scene files, by name. Throws std::runtime_error for one whose first line cannot be read.
std::vector<SceneFile> scene_files();

/// The scene's picture on the whole-picture machine with ample memory, with keys added to those of the file. The scene
/// and effects of the options come from the file.
struct DrawnScene {
  Compiled compiled;
  scene::Scene scene;
};
DrawnScene compile_scene(const SceneFile& file, std::uint32_t width, std::uint32_t height,
                         const std::vector<std::string>& sets = {}, emit::Options options = {});

}  // namespace csgsim::testing
