#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "host/solids/read_mesh.h"
#include "host/solids/words.h"
#include "hw/base/error.h"

namespace csgsim::solids {

namespace {

constexpr std::size_t head_bytes = 84;  ///< comment of 80 bytes and the number of triangles
constexpr std::size_t triangle_bytes = 50;
constexpr std::size_t normal_bytes = 12;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

bool is_binary(std::string_view bytes) {
  return bytes.size() >= head_bytes &&
         bytes.size() == head_bytes + triangle_bytes * std::size_t{word_at(bytes, head_bytes - 4)};
}

void require_few(std::size_t triangles, std::string_view name) {
  if (triangles <= max_mesh_faces) return;
  throw InputError(fmt::format("{}: more than {} triangles; make the mesh coarser", name, max_mesh_faces));
}

void add_triangle(Mesh& mesh, const std::array<glm::dvec3, 3>& corners) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), corners.begin(), corners.end());
  mesh.faces.push_back({first, first + 1, first + 2});
}

Mesh parse_binary(std::string_view bytes, std::string_view name) {
  const std::size_t count = word_at(bytes, head_bytes - 4);
  require_few(count, name);
  Mesh mesh;
  mesh.points.reserve(3 * count);
  mesh.faces.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t at = head_bytes + i * triangle_bytes + normal_bytes;
    std::array<glm::dvec3, 3> corners;
    for (glm::dvec3& corner : corners) {
      for (int axis = 0; axis < 3; ++axis, at += 4) {
        corner[axis] = static_cast<double>(std::bit_cast<float>(word_at(bytes, at)));
        if (std::isfinite(corner[axis])) continue;
        throw InputError(
            fmt::format("{}: triangle {} of {} has a coordinate that is not finite; correct it", name, i + 1, count));
      }
    }
    add_triangle(mesh, corners);
  }
  return mesh;
}

bool is_word(std::string_view word, std::string_view expected) {
  return std::equal(word.begin(), word.end(), expected.begin(), expected.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? static_cast<char>(a + 32) : a) == b; });
}

void expect(Words& words, std::string_view expected) {
  if (!is_word(words.next(), expected)) words.fail(fmt::format("expected '{}'; export it as STL again", expected));
}

/// STL has single precision: points that are equal may differ in the last place if another program printed them with
/// more digits.
double in_single_precision(Words& words, double number) {
  if (std::abs(number) > static_cast<double>(std::numeric_limits<float>::max()))
    words.fail("a coordinate exceeds the range of single precision; scale the model down");
  return static_cast<double>(static_cast<float>(number));
}

/// Reads a facet after its keyword `facet`, including `endfacet`.
std::array<glm::dvec3, 3> read_facet(Words& words) {
  expect(words, "normal");
  for (int axis = 0; axis < 3; ++axis) words.next();
  expect(words, "outer");
  expect(words, "loop");
  std::array<glm::dvec3, 3> corners;
  for (glm::dvec3& corner : corners) {
    expect(words, "vertex");
    for (int axis = 0; axis < 3; ++axis) corner[axis] = in_single_precision(words, words.number("a coordinate"));
  }
  expect(words, "endloop");
  expect(words, "endfacet");
  return corners;
}

Mesh parse_text(std::string_view text, std::string_view name) {
  Words words(text, name);
  expect(words, "solid");
  words.skip_line();  // name of the solid
  Mesh mesh;
  bool is_open = true;
  for (std::string_view word = words.next(); !word.empty() || is_open; word = words.next()) {
    if (is_open && is_word(word, "facet")) {
      add_triangle(mesh, read_facet(words));
      require_few(mesh.faces.size(), name);
    } else if (is_word(word, is_open ? "endsolid" : "solid")) {
      is_open = !is_open;
      words.skip_line();
    } else {
      words.fail(is_open ? "expected 'facet' or 'endsolid'; export it as STL again"
                         : "expected 'solid' or the end of the file; export it as STL again");
    }
  }
  return mesh;
}

}  // namespace

Mesh parse_stl(std::string_view text, std::string_view name) {
  if (is_binary(text)) return parse_binary(text, name);
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  if (is_word(text.substr(begin, 5), "solid")) return parse_text(text, name);
  if (text.size() < head_bytes) throw InputError(fmt::format("{}: not an STL file; export it again", name));
  const std::uint32_t count = word_at(text, head_bytes - 4);
  throw InputError(
      fmt::format("{}: a binary STL file of {} triangles has {} bytes, and this one has {}; export it again", name,
                  count, head_bytes + triangle_bytes * std::size_t{count}, text.size()));
}

}  // namespace csgsim::solids
