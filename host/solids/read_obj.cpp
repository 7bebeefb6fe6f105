#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

#include "host/solids/read_mesh.h"
#include "host/solids/words.h"

namespace csgsim::solids {

namespace {

/// Ignored statements: normals, texture coordinates, names, groups, materials, points and lines.
constexpr std::array looks{"vn", "vt", "vp", "g", "o", "s", "l", "p", "mg", "usemtl", "mtllib", "usemap", "maplib"};

/// The next word of a statement. A backslash at the end of a line continues the statement on the next line.
std::string_view next_word(Words& words) {
  std::string_view word = words.next_on_line();
  while (word == "\\") word = words.next();
  return word;
}

/// The point of a corner `point`, `point/texture` or `point/texture/normal`. Points are counted from 1, or backwards
/// from -1.
std::uint32_t corner(const Words& words, std::string_view word, std::size_t points) {
  const std::string_view digits = word.substr(0, word.find('/'));
  std::int64_t number = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const auto most = static_cast<std::int64_t>(points);
  const bool is_point = result.ec == std::errc{} && result.ptr == digits.data() + digits.size() && number != 0 &&
                        number >= -most && number <= most;
  if (!is_point) {
    words.fail(fmt::format(
        "a corner must be one of the {} points before it, counted from 1, or backwards from -1; correct it", points));
  }
  return static_cast<std::uint32_t>(number > 0 ? number - 1 : most + number);
}

void read_point(Words& words, Mesh& mesh) {
  glm::dvec3& point = mesh.points.emplace_back();
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = next_word(words);
    if (word.empty()) words.fail("a point needs three coordinates; complete it");
    point[axis] = words.number_of(word, "a coordinate");
  }
}

void read_face(Words& words, Mesh& mesh) {
  auto& face = mesh.faces.emplace_back();
  for (std::string_view word = next_word(words); !word.empty(); word = next_word(words)) {
    face.push_back(corner(words, word, mesh.points.size()));
  }
  if (face.size() < 3) words.fail("a face needs at least 3 corners; complete or remove it");
}

}  // namespace

Mesh parse_obj(std::string_view text, std::string_view name) {
  Words words(text, name, '#');
  Mesh mesh;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "v") {
      read_point(words, mesh);
    } else if (word == "f") {
      read_face(words, mesh);
    } else if (std::find(looks.begin(), looks.end(), word) == looks.end()) {
      words.fail(
          "unsupported statement: only points, faces and their appearance are read; export a mesh of flat faces");
    }
    words.skip_line();
    if (mesh.faces.size() > max_mesh_faces)
      words.fail(fmt::format("more than {} faces; make the mesh coarser", max_mesh_faces));
  }
  return mesh;
}

}  // namespace csgsim::solids
