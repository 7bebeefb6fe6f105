#include "tests/corpus/reference.h"

#include <png.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "places.h"

namespace csgsim::testing {

namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(CSGSIM_SOURCE_DIR) / "tests" / "corpus";

struct Values {
  std::uint32_t width = 0;
  std::vector<std::uint16_t> pixels;
};

/// The grey values of a 16-bit PNG file.
Values read_values(const fs::path& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0)
    throw std::runtime_error(path.string() + ": not a PNG file");
  image.format = PNG_FORMAT_LINEAR_Y;
  Values values{image.width, std::vector<std::uint16_t>(std::size_t{image.width} * image.height)};
  if (png_image_finish_read(&image, nullptr, values.pixels.data(), 0, nullptr) == 0) {
    throw std::runtime_error(path.string() + ": damaged PNG file");
  }
  return values;
}

view::Camera read_camera(std::istream& words) {
  std::string projection;
  view::Camera camera;
  words >> projection;
  for (glm::dvec3* point : {&camera.eye, &camera.centre}) words >> point->x >> point->y >> point->z;
  camera.projection = projection == "ortho" ? view::Projection::orthographic : view::Projection::perspective;
  return camera;
}

}  // namespace

std::map<std::string, std::string> corpus_models() {
  std::map<std::string, std::string> models;
  for (const fs::path& where : {folder, folder / "parts"}) {
    for (const auto& entry : fs::directory_iterator(where)) {
      if (entry.path().extension() == ".csg") models.emplace(entry.path().stem().string(), entry.path().string());
    }
  }
  return models;
}

std::vector<Reference> read_references(const fs::path& where, const std::string& name) {
  const Values values = read_values(where / (name + ".png"));
  const auto size = static_cast<std::ptrdiff_t>(values.width) * values.width;
  std::vector<Reference> references;
  std::ifstream views(where / "views.txt");
  for (std::string line; std::getline(views, line);) {
    std::istringstream words(line);
    std::string found;
    words >> found;
    if (found != name) continue;
    Reference reference{.camera = read_camera(words), .size = values.width, .pixels = {}};
    words >> reference.near >> reference.far >> reference.diagonal;
    if (!words) throw std::runtime_error("views.txt: malformed line; write it again with references.py: " + line);
    references.push_back(std::move(reference));
  }
  if (std::ssize(values.pixels) != std::ssize(references) * size)
    throw std::runtime_error(name + ": a picture or a view is missing; write them again with references.py");
  // The first picture belongs to the last line.
  for (auto one = references.begin(); one != references.end(); ++one) {
    const auto first = values.pixels.begin() + (references.end() - one - 1) * size;
    one->pixels.assign(first, first + size);
  }
  return references;
}

std::vector<Reference> read_references(const std::string& model) {
  std::vector<Reference> references = read_references(folder / "references", model);
  if (references.size() != 2)
    throw std::runtime_error(model + ": two views are needed; run tests/corpus/references.py");
  return references;
}

std::map<std::string, std::string> refused_models() {
  std::map<std::string, std::string> refused;
  std::ifstream file(folder / "refused.txt");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.empty() || line.front() == '#') continue;
    if (colon == std::string::npos) throw std::runtime_error("refused.txt: expected NAME: REASON: " + line);
    refused.emplace(line.substr(0, colon), line.substr(colon + 2));
  }
  return refused;
}

}  // namespace csgsim::testing
