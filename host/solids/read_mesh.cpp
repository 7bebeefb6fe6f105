#include "host/solids/read_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/text.h"

namespace csgsim::solids {

namespace {

std::string lower(std::string text) {
  for (char& letter : text) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter + ('a' - 'A'));
  }
  return text;
}

}  // namespace

std::vector<Mesh> parse_meshes(std::string_view text, const std::filesystem::path& path) {
  const std::string ending = lower(path.extension().string());
  if (ending == ".stl") return {parse_stl(text, path.native())};
  if (ending == ".off") return {parse_off(text, path.native())};
  if (ending == ".obj") return {parse_obj(text, path.native())};
  if (ending == ".amf") return parse_amf(text, path.native());
  if (ending == ".3mf") return parse_3mf(text, path.native());
  throw InputError(fmt::format("{}: meshes are read from .stl, .off, .obj, .amf and .3mf files; convert it",
                               printable(path.native())));
}

std::vector<Mesh> read_meshes(const std::filesystem::path& path) {
  return parse_meshes(read_file(path, {"a mesh file", most_mesh_bytes, "make the mesh coarser"}), path);
}

}  // namespace csgsim::solids
