#include "host/read/nodes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "host/read/source.h"
#include "hw/base/nearest.h"

namespace csgsim::read {

namespace {

using Names = std::span<const std::string_view>;
using namespace std::string_view_literals;

constexpr std::array common_extras{"convexity"sv, "timestamp"sv};
constexpr std::array solid_extras{"convexity"sv, "timestamp"sv, "$fn"sv, "$fa"sv, "$fs"sv};

constexpr std::array render_parameters{"convexity"sv};
constexpr std::array matrix_parameters{"m"sv};
constexpr std::array colour_parameters{"c"sv, "alpha"sv};
constexpr std::array cube_parameters{"size"sv, "center"sv};
constexpr std::array sphere_parameters{"r"sv, "d"sv, "$fn"sv, "$fa"sv, "$fs"sv};
constexpr std::array cylinder_parameters{"h"sv,  "r1"sv, "r2"sv,  "center"sv, "r"sv,  "d"sv,
                                         "d1"sv, "d2"sv, "$fn"sv, "$fa"sv,    "$fs"sv};
constexpr std::array polyhedron_parameters{"points"sv, "faces"sv, "convexity"sv, "triangles"sv};

constexpr NodeType operator_node(std::string_view name, NodeKind kind) { return {name, kind, {}, 0, common_extras}; }
constexpr NodeType unsupported(std::string_view name) { return {name, NodeKind::unsupported, {}, 0, {}}; }
constexpr NodeType source(std::string_view name) { return {name, NodeKind::source, {}, 0, {}}; }

constexpr std::array node_types{
    operator_node("group", NodeKind::unite),
    operator_node("union", NodeKind::unite),
    NodeType{"render", NodeKind::unite, render_parameters, 1, common_extras},
    operator_node("difference", NodeKind::subtract),
    operator_node("intersection", NodeKind::intersect),
    NodeType{"multmatrix", NodeKind::transform, matrix_parameters, 1, common_extras},
    NodeType{"color", NodeKind::colour, colour_parameters, 2, common_extras},
    NodeType{"cube", NodeKind::cube, cube_parameters, 2, solid_extras},
    NodeType{"sphere", NodeKind::sphere, sphere_parameters, 1, common_extras},
    NodeType{"cylinder", NodeKind::cylinder, cylinder_parameters, 4, common_extras},
    NodeType{"polyhedron", NodeKind::polyhedron, polyhedron_parameters, 3, solid_extras},
    unsupported("circle"),
    unsupported("fill"),
    unsupported("glide"),
    unsupported("hull"),
    unsupported("import"),
    unsupported("linear_extrude"),
    unsupported("minkowski"),
    unsupported("offset"),
    unsupported("polygon"),
    unsupported("projection"),
    unsupported("resize"),
    unsupported("roof"),
    unsupported("rotate_extrude"),
    unsupported("square"),
    unsupported("subdiv"),
    unsupported("surface"),
    unsupported("text"),
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

constexpr std::array usable_names = [] {
  constexpr auto usable = [](const NodeType& node) {
    return node.kind != NodeKind::unsupported && node.kind != NodeKind::source;
  };
  std::array<std::string_view, std::count_if(node_types.begin(), node_types.end(), usable)> names;
  std::size_t count = 0;
  for (const NodeType& node : node_types) {
    if (usable(node)) names[count++] = node.name;
  }
  return names;
}();

constexpr std::array all_names = [] {
  std::array<std::string_view, node_types.size()> names;
  std::transform(node_types.begin(), node_types.end(), names.begin(), [](const NodeType& node) { return node.name; });
  return names;
}();

}  // namespace

const NodeType* find_node(std::string_view name) {
  const auto* const found = std::ranges::find(node_types, name, &NodeType::name);
  return found == node_types.end() ? nullptr : found;
}

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

std::string unknown_node(std::string_view name) {
  const std::string_view near = near_name(name, all_names);
  if (!near.empty()) return fmt::format("unknown node {}(); did you mean {}()?", shown(name), near);
  return fmt::format("unknown node {}(); use one of {}", shown(name), fmt::join(usable_names, ", "));
}

std::string unknown_argument(const NodeType& node, std::string_view name) {
  const std::string_view near = near_name(name, node.parameters);
  if (!near.empty()) return fmt::format("{}() has no argument {}; did you mean {}?", node.name, shown(name), near);
  if (node.parameters.empty()) return fmt::format("{}() has no argument {}; take it out", node.name, shown(name));
  return fmt::format("{}() has no argument {}; it takes {}", node.name, shown(name), fmt::join(node.parameters, ", "));
}

std::string unusable_node(const NodeType& node) {
  if (node.kind == NodeKind::source) {
    return fmt::format("{}() is OpenSCAD source, not .csg; export it first: openscad -o model.csg model.scad",
                       node.name);
  }
  return fmt::format(
      "{}() cannot be turned into half-spaces; replace it by cube, sphere, cylinder, polyhedron or a boolean of them",
      node.name);
}

}  // namespace csgsim::read
