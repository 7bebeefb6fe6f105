#include "host/solids/projection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <polyclipping/clipper.hpp>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "host/facet/geometry.h"
#include "host/flat/clip_steps.h"
#include "host/flat/hull.h"
#include "host/solids/limits.h"

namespace csgsim::solids {

namespace {

using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;

/// Up to it Clipper multiplies in 64 bits.
constexpr int coordinate_bits = 29;

/// Model units: OpenSCAD takes corners of solids to be the same within this.
constexpr double grid = 0x1p-20;

/// Corners of a convex solid that are in the x, y plane, and where its edges cross it.
std::vector<glm::dvec2> section_of(const facet::Convex& solid, double near) {
  std::vector<glm::dvec2> points;
  for (const glm::dvec3& vertex : solid.vertices) {
    if (std::abs(vertex.z) <= near) points.emplace_back(vertex);
  }
  for (const auto& edge : solid.edges) {
    const glm::dvec3& here = solid.vertices[edge[0]];
    const glm::dvec3& there = solid.vertices[edge[1]];
    const bool crosses = std::min(here.z, there.z) < -near && std::max(here.z, there.z) > near;
    if (crosses) points.emplace_back(here + (there - here) * (here.z / (here.z - there.z)));
  }
  return points;
}

double largest_of(std::span<const glm::dvec3> points) {
  double largest = 0;
  for (const glm::dvec3& point : points) {
    largest = std::max({largest, std::abs(point.x), std::abs(point.y), std::abs(point.z)});
  }
  return largest;
}

/// Model units in Clipper's.
double scale_for(double largest) { return std::ldexp(1.0, coordinate_bits - 1 - std::ilogb(largest)); }

Path hull_of(const std::vector<glm::dvec2>& points, double scale) {
  flat::Outline rounded;
  for (const glm::dvec2& point : points) rounded.push_back(glm::round(point * scale));
  Path path;
  for (const flat::Outline& outline : flat::hull(std::array{flat::Area{{rounded}}}).outlines) {
    for (const glm::dvec2& corner : outline)
      path.emplace_back(static_cast<ClipperLib::cInt>(corner.x), static_cast<ClipperLib::cInt>(corner.y));
  }
  return path;
}

Paths combine(ClipperLib::ClipType how, const Paths& first, const Paths& others, const Work& work) {
  Paths all = first;
  all.insert(all.end(), others.begin(), others.end());
  flat::charge_clipping(all, work);
  ClipperLib::Clipper clipper;
  clipper.AddPaths(first, ClipperLib::ptSubject, true);
  clipper.AddPaths(others, ClipperLib::ptClip, true);
  Paths made;
  clipper.Execute(how, made, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return made;
}

Paths combine(model::Operator op, const std::vector<Paths>& operands, const Work& work) {
  Paths made = operands.front();
  if (op == model::Operator::intersect) {
    for (std::size_t i = 1; i < operands.size(); ++i)
      made = combine(ClipperLib::ctIntersection, made, operands[i], work);
    return made;
  }
  Paths others;
  for (std::size_t i = 1; i < operands.size(); ++i) others.insert(others.end(), operands[i].begin(), operands[i].end());
  return combine(op == model::Operator::unite ? ClipperLib::ctUnion : ClipperLib::ctDifference, made, others, work);
}

flat::Area area_of(const Paths& paths, double scale) {
  flat::Area area;
  for (const Path& path : paths) {
    if (path.size() < 3) continue;
    flat::Outline& outline = area.outlines.emplace_back();
    for (const IntPoint& point : path) {
      outline.emplace_back(static_cast<double>(point.X) / scale, static_cast<double>(point.Y) / scale);
    }
  }
  return area;
}

}  // namespace

flat::Area shadow(std::span<const model::Polyhedron> pieces, const Work& work) {
  double largest = 0;
  for (const model::Polyhedron& piece : pieces) largest = std::max(largest, largest_of(piece.points));
  if (largest == 0) return {};
  const double scale = scale_for(largest);
  Paths paths;
  for (const model::Polyhedron& piece : pieces) {
    paths.push_back(hull_of({piece.points.begin(), piece.points.end()}, scale));
  }
  Paths united = combine(ClipperLib::ctUnion, paths, {}, work);
  ClipperLib::CleanPolygons(united);
  return area_of(united, scale);
}

flat::Area section(const model::Tree& tree, const Work& work) {
  if (tree.root == model::no_index) return {};
  const facet::Geometry scene = facet::make_geometry(tree);
  double largest = 0;
  for (const facet::Convex& solid : scene.solids) largest = std::max(largest, largest_of(solid.vertices));
  if (largest == 0) return {};
  const double scale = scale_for(largest);
  const double near = std::max(grid, double_precision_tolerance * largest);
  std::vector<Paths> sections;  // of each node; those of children go where they are used
  for (const model::Node& node : tree.nodes) {
    if (node.is_leaf) {
      sections.push_back({hull_of(section_of(scene.solids[node.primitive], near), scale)});
      continue;
    }
    std::vector<Paths> operands;
    for (const std::uint32_t child : node.children) operands.push_back(std::move(sections[child]));
    sections.push_back(combine(node.op, operands, work));
  }
  Paths made = combine(ClipperLib::ctUnion, sections[tree.root], {}, work);
  ClipperLib::CleanPolygons(made);
  return area_of(made, scale);
}

}  // namespace csgsim::solids
