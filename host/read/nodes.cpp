#include "host/read/nodes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "host/read/node_readers.h"
#include "host/read/source.h"
#include "hw/base/nearest.h"

namespace csgsim::read {

namespace {

using Names = std::span<const std::string_view>;
using namespace std::string_view_literals;

constexpr std::array render_parameters{"convexity"sv};
constexpr std::array matrix_parameters{"m"sv};
constexpr std::array colour_parameters{"c"sv, "alpha"sv};
constexpr std::array polyhedron_parameters{"points"sv, "faces"sv, "convexity"sv, "triangles"sv};

constexpr std::array square_parameters{"size"sv, "center"sv};
constexpr std::array circle_parameters{"r"sv, "d"sv, "$fn"sv, "$fa"sv, "$fs"sv};
constexpr std::array polygon_parameters{"points"sv, "paths"sv};
constexpr std::array text_parameters{"text"sv,   "size"sv,     "font"sv,      "halign"sv, "valign"sv, "spacing"sv,
                                     "script"sv, "language"sv, "direction"sv, "$fn"sv,    "$fa"sv,    "$fs"sv};
constexpr std::array offset_parameters{"r"sv, "delta"sv, "chamfer"sv, "$fn"sv, "$fa"sv, "$fs"sv};
constexpr std::array linear_extrude_parameters{"height"sv, "center"sv, "twist"sv, "slices"sv, "scale"sv, "file"sv,
                                               "layer"sv,  "origin"sv, "$fn"sv,   "$fa"sv,    "$fs"sv};
constexpr std::array resize_parameters{"newsize"sv, "auto"sv};
constexpr std::array projection_parameters{"cut"sv};
constexpr std::array surface_parameters{"file"sv, "center"sv, "invert"sv};
constexpr std::array import_parameters{"file"sv, "layer"sv, "convexity"sv, "origin"sv,   "scale"sv, "center"sv,
                                       "dpi"sv,  "width"sv, "height"sv,    "filename"sv, "id"sv};
constexpr std::array rotate_extrude_parameters{"file"sv,  "layer"sv, "origin"sv, "scale"sv,
                                               "angle"sv, "$fn"sv,   "$fa"sv,    "$fs"sv};

constexpr NodeType operator_node(std::string_view name, NodeKind kind) { return {name, kind, {}, 0, common_extras}; }
constexpr NodeType leaf(std::string_view name, Names parameters, MakerReader reader) {
  return {name, NodeKind::made, parameters, parameters.size(), solid_extras, nullptr, reader, false};
}
constexpr NodeType made(std::string_view name, Names parameters, MakerReader reader, std::uint32_t dimensions) {
  return {name, NodeKind::made, parameters, parameters.size(), solid_extras, nullptr, reader, true, dimensions};
}
constexpr NodeType unsupported(std::string_view name) { return {name, NodeKind::unsupported, {}, 0, {}}; }
constexpr NodeType source(std::string_view name) { return {name, NodeKind::source, {}, 0, {}}; }

constexpr std::array operator_nodes{
    operator_node("group", NodeKind::unite),
    operator_node("union", NodeKind::unite),
    NodeType{"render", NodeKind::unite, render_parameters, 1, common_extras},
    operator_node("difference", NodeKind::subtract),
    operator_node("intersection", NodeKind::intersect),
    NodeType{"multmatrix", NodeKind::transform, matrix_parameters, 1, common_extras},
    NodeType{"color", NodeKind::colour, colour_parameters, 2, common_extras},
};

constexpr std::array other_nodes{
    leaf("polyhedron", polyhedron_parameters, read_polyhedron),
    leaf("import", import_parameters, read_import),
    leaf("square", square_parameters, read_square),
    leaf("circle", circle_parameters, read_circle),
    leaf("polygon", polygon_parameters, read_polygon),
    leaf("text", text_parameters, read_text),
    made("offset", offset_parameters, read_offset, 2),
    made("linear_extrude", linear_extrude_parameters, read_linear_extrude, 2),
    made("rotate_extrude", rotate_extrude_parameters, read_rotate_extrude, 2),
    made("hull", {}, read_hull, 0),
    made("minkowski", {}, read_minkowski, 0),
    made("resize", resize_parameters, read_resize, 0),
    made("projection", projection_parameters, read_projection, 3),
    leaf("surface", surface_parameters, read_surface),
    unsupported("fill"),
    unsupported("glide"),
    unsupported("roof"),
    unsupported("subdiv"),
    unsupported("dxf_linear_extrude"),
    unsupported("dxf_rotate_extrude"),
    unsupported("import_dxf"),
    unsupported("import_off"),
    unsupported("import_stl"),
    source("assert"),
    source("assign"),
    source("child"),
    source("children"),
    source("echo"),
    source("for"),
    source("if"),
    source("intersection_for"),
    source("let"),
    source("mirror"),
    source("rotate"),
    source("scale"),
    source("translate"),
};

std::array<std::span<const NodeType>, 3> node_tables() { return {operator_nodes, solid_node_types(), other_nodes}; }

bool is_usable(const NodeType& node) { return node.kind != NodeKind::unsupported && node.kind != NodeKind::source; }

std::vector<std::string_view> names_of(bool only_usable) {
  std::vector<std::string_view> names;
  for (const std::span<const NodeType> table : node_tables()) {
    for (const NodeType& node : table)
      if (!only_usable || is_usable(node)) names.push_back(node.name);
  }
  return names;
}

/// The candidate with the smallest edit distance; empty if none is close.
std::string_view near_name(std::string_view name, Names candidates) {
  std::string_view best;
  std::size_t best_edits = std::max<std::size_t>(2, name.size() / 2) + 1;
  if (name.size() > 40) return best;
  for (const std::string_view candidate : candidates) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < best_edits && distance < candidate.size()) {
      best = candidate;
      best_edits = distance;
    }
  }
  return best;
}

}  // namespace

const NodeType* find_node_type(std::string_view name) {
  for (const std::span<const NodeType> table : node_tables()) {
    const auto found = std::ranges::find(table, name, &NodeType::name);
    if (found != table.end()) return &*found;
  }
  return nullptr;
}

std::string unknown_node_text(std::string_view name) {
  const std::string_view near = near_name(name, names_of(false));
  if (!near.empty()) return fmt::format("unknown node {}(); did you mean {}()?", shown(name), near);
  return fmt::format("unknown node {}(); use one of {}", shown(name), fmt::join(names_of(true), ", "));
}

std::string unknown_argument_text(const NodeType& node, std::string_view name) {
  const std::string_view near = near_name(name, node.parameters);
  if (!near.empty()) return fmt::format("{}() has no argument {}; did you mean {}?", node.name, shown(name), near);
  if (node.parameters.empty()) return fmt::format("{}() has no argument {}; remove it", node.name, shown(name));
  return fmt::format("{}() has no argument {}; its arguments are {}", node.name, shown(name),
                     fmt::join(node.parameters, ", "));
}

std::string unusable_node_text(const NodeType& node) {
  if (node.kind == NodeKind::source) {
    return fmt::format("{}() is OpenSCAD source, not .csg; export it first: openscad -o model.csg model.scad",
                       node.name);
  }
  return fmt::format(
      "{}() cannot be turned into half-spaces; replace it by cube, sphere, cylinder, polyhedron or a boolean of them",
      node.name);
}

}  // namespace csgsim::read
