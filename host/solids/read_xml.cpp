#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <pugixml.hpp>
#include <string>

#include "host/solids/read_mesh.h"
#include "host/solids/unzip.h"
#include "hw/base/error.h"
#include "hw/base/text.h"

namespace csgsim::solids {

namespace {

/// Reads elements of an XML document. Errors report the position of the element.
class Document {
 public:
  Document(std::string text, std::string_view name) : text_(std::move(text)), name_(name) {
    if (text_.size() > max_unzipped_bytes) {
      throw InputError(
          fmt::format("{}: larger than {}; make the mesh coarser", name_, binary_size(max_unzipped_bytes)));
    }
    const pugi::xml_parse_result result = document_.load_buffer(text_.data(), text_.size(), pugi::parse_minimal);
    if (!result) fail(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)), result.description());
  }

  [[nodiscard]] pugi::xml_node root(const char* name) const {
    const pugi::xml_node node = document_.child(name);
    if (!node) fail(0, fmt::format("no <{}> element", name));
    return node;
  }

  [[nodiscard]] double coordinate(const pugi::xml_node& node, std::string_view text) const {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\n' || text.front() == '+')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\n')) text.remove_suffix(1);
    double value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || result.ptr != text.data() + text.size() || result.ec != std::errc{} || !std::isfinite(value)) {
      fail(place(node), fmt::format("a coordinate must be a finite number, not '{}'", text.substr(0, 40)));
    }
    return value;
  }

  [[nodiscard]] std::uint32_t corner(const pugi::xml_node& node, std::string_view text, std::size_t points) const {
    std::uint64_t value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || result.ptr != text.data() + text.size() || result.ec != std::errc{} || value >= points) {
      fail(place(node),
           fmt::format("a corner must be the index of one of {} points, from 0, not '{}'", points, text.substr(0, 40)));
    }
    return static_cast<std::uint32_t>(value);
  }

  void require_few(const pugi::xml_node& node, std::size_t faces) const {
    if (faces > max_mesh_faces) fail(place(node), fmt::format("more than {} triangles", max_mesh_faces));
  }

 private:
  [[nodiscard]] static std::size_t place(const pugi::xml_node& node) {
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
  }

  [[noreturn]] void fail(std::size_t offset, std::string_view message) const {
    const std::string_view before = std::string_view(text_).substr(0, offset);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t column = offset - std::min(before.rfind('\n') + 1, before.size()) + 1;
    throw InputError(fmt::format("{}:{}:{}: {}; correct it", name_, line, column, message));
  }

  std::string text_;
  std::string_view name_;
  pugi::xml_document document_;
};

/// Adds a point. `text(name)` returns the node's text for `x`, `y` or `z`.
template <class Text>
void add_point(Mesh& mesh, const Document& document, const pugi::xml_node& node, const Text& text) {
  const auto coordinate = [&](const char* name) { return document.coordinate(node, text(name)); };
  mesh.points.push_back({coordinate("x"), coordinate("y"), coordinate("z")});
}

/// Adds a face. `text(name)` returns the node's text for `v1`, `v2` or `v3`: the index of a point.
template <class Text>
void add_triangle(Mesh& mesh, const Document& document, const pugi::xml_node& node, const Text& text) {
  auto& face = mesh.faces.emplace_back();
  for (const char* name : {"v1", "v2", "v3"}) face.push_back(document.corner(node, text(name), mesh.points.size()));
  document.require_few(node, mesh.faces.size());
}

Mesh read_amf_object(const Document& document, const pugi::xml_node& object) {
  Mesh mesh;
  const pugi::xml_node source = object.child("mesh");
  for (const pugi::xml_node vertex : source.child("vertices").children("vertex")) {
    const pugi::xml_node at = vertex.child("coordinates");
    add_point(mesh, document, vertex, [&](const char* name) { return at.child_value(name); });
  }
  for (const pugi::xml_node volume : source.children("volume")) {
    for (const pugi::xml_node triangle : volume.children("triangle")) {
      add_triangle(mesh, document, triangle, [&](const char* name) { return triangle.child_value(name); });
    }
  }
  return mesh;
}

Mesh read_3mf_object(const Document& document, const pugi::xml_node& source) {
  Mesh mesh;
  for (const pugi::xml_node vertex : source.child("vertices").children("vertex")) {
    add_point(mesh, document, vertex, [&](const char* name) { return vertex.attribute(name).value(); });
  }
  for (const pugi::xml_node triangle : source.child("triangles").children("triangle")) {
    add_triangle(mesh, document, triangle, [&](const char* name) { return triangle.attribute(name).value(); });
  }
  return mesh;
}

/// The name of the part that the relationships of the 3MF package declare as the model.
std::string model_part(std::string_view text, std::string_view name) {
  const Document relations(unzip(text, name, "_rels/.rels"), name);
  for (const pugi::xml_node relation : relations.root("Relationships").children("Relationship")) {
    const std::string_view type = relation.attribute("Type").value();
    if (!type.ends_with("/3dmodel")) continue;
    std::string target = relation.attribute("Target").value();
    if (target.starts_with('/')) target.erase(0, 1);
    return target;
  }
  throw InputError(fmt::format("{}: the package's relationships name no model; export it again", name));
}

}  // namespace

std::vector<Mesh> parse_amf(std::string_view text, std::string_view name) {
  const Document document(is_zip(text) ? unzip(text, name, "") : std::string(text), name);
  std::vector<Mesh> meshes;
  for (const pugi::xml_node object : document.root("amf").children("object")) {
    meshes.push_back(read_amf_object(document, object));
  }
  return meshes;
}

std::vector<Mesh> parse_3mf(std::string_view text, std::string_view name) {
  if (!is_zip(text)) throw InputError(fmt::format("{}: not a 3MF package; export it again", name));
  const Document document(unzip(text, name, model_part(text, name)), name);
  std::vector<Mesh> meshes;
  for (const pugi::xml_node object : document.root("model").child("resources").children("object")) {
    if (const pugi::xml_node mesh = object.child("mesh")) meshes.push_back(read_3mf_object(document, mesh));
  }
  return meshes;
}

}  // namespace csgsim::solids
