#pragma once

#include <string>
#include <vector>

#include "tests/support/drawing.h"

namespace csgsim::testing {

/// A file of tests/scenes. Its first line says the model, and what else `csgsim render` needs to draw it:
/// `# model: NAME.csg --camera 1,2,3,4,5,6 --memory-bits 128`.
struct SceneFile {
  std::string name;
  std::string text;
  std::string model;  ///< path
  view::Camera camera;
};

/// All of them, by name. Throws std::runtime_error for one whose first line cannot be read.
std::vector<SceneFile> scene_files();

/// The scene's picture on the whole-picture machine with ample memory, with keys set on top of the file's. The options'
/// scene and effects are the file's.
struct DrawnScene {
  Compiled compiled;
  scene::Scene scene;
};
DrawnScene compile_scene(const SceneFile& file, std::uint32_t width, std::uint32_t height,
                         const std::vector<std::string>& sets = {}, emit::Options options = {});

}  // namespace csgsim::testing
