#include "tests/scenes/scene_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "host/effects/rows.h"
#include "host/read/read.h"
#include "host/scene/read.h"
#include "hw/kinds/load.h"
#include "places.h"

namespace csgsim::testing {

namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t ample_bits = 4096;

view::Camera camera_of(const std::string& numbers, const std::string& projection) {
  std::istringstream in(numbers);
  glm::dvec3 eye;
  glm::dvec3 centre;
  char comma = 0;
  in >> eye.x >> comma >> eye.y >> comma >> eye.z >> comma >> centre.x >> comma >> centre.y >> comma >> centre.z;
  if (!in) throw std::runtime_error("no camera in '" + numbers + "'");
  return {eye, centre, projection == "perspective" ? view::Projection::perspective : view::Projection::orthographic};
}

SceneFile read_scene_file(const fs::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  std::istringstream words(text.str().substr(0, text.str().find('\n')));
  SceneFile file{path.stem().string(), text.str(), "", {}};
  std::string word;
  std::string camera;
  std::string projection;
  words >> word >> word >> file.model;
  while (words >> word) {
    if (word == "--camera") words >> camera;
    if (word == "--projection") words >> projection;
  }
  const fs::path beside = path.parent_path() / file.model;
  file.model = (fs::exists(beside) ? beside : path.parent_path().parent_path() / "models" / file.model).string();
  file.camera = camera_of(camera, projection);
  return file;
}

}  // namespace

std::vector<SceneFile> scene_files() {
  std::vector<SceneFile> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(CSGSIM_SOURCE_DIR) / "tests" / "scenes"))
    if (entry.path().extension() == ".toml") files.push_back(read_scene_file(entry.path()));
  std::sort(files.begin(), files.end(), [](const SceneFile& a, const SceneFile& b) { return a.name < b.name; });
  return files;
}

DrawnScene compile_scene(const SceneFile& file, std::uint32_t width, std::uint32_t height,
                         const std::vector<std::string>& sets, emit::Options options) {
  scene::Scene scene = scene::read_scene(file.text, file.name + ".toml", sets, effects::sections());
  machines::Machine machine = kinds::load("pixel-planes-4");
  machines::set_picture_size(machine, {width, height});
  machine.array.memory_bits = ample_bits;
  view::Sampling sampling;
  sampling.width = width;
  sampling.height = height;
  options.scene = scene;
  options.effects = effects::all();
  model::Tree tree = effects::reshape_model(read::read_csg_file(file.model), scene);
  facet::Geometry facets = facet::make_geometry(tree);
  view::View view = view::make_view(facets, tree, file.camera, sampling);
  isa::Program program = emit::compile(tree, facets, view, machine, options);
  isa::validate(program);
  return {{std::move(tree), std::move(facets), std::move(view), std::move(program)}, std::move(scene)};
}

}  // namespace csgsim::testing
