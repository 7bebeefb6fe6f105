#include "host/solids/read_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "hw/base/error.h"
#include "hw/base/input_file.h"

namespace csgsim::solids {

std::string lower_case_extension(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& letter : ending) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter + ('a' - 'A'));
  }
  return ending;
}

std::vector<Mesh> parse_meshes(std::string_view text, const std::filesystem::path& path) {
  const std::string ending = lower_case_extension(path);
  if (ending == ".stl") return {parse_stl(text, path.native())};
  if (ending == ".off") return {parse_off(text, path.native())};
  if (ending == ".obj") return {parse_obj(text, path.native())};
  if (ending == ".ply") return {parse_ply(text, path.native())};
  if (ending == ".amf") return parse_amf(text, path.native());
  if (ending == ".3mf") return parse_3mf(text, path.native());
  throw InputError(
      fmt::format("{}: meshes are read from .stl, .off, .obj, .ply, .amf and .3mf files; convert it", path.native()));
}

}  // namespace csgsim::solids
