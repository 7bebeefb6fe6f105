#include "tests/unit/convert/nef.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <utility>
#include <vector>

#include "host/facet/solid.h"

namespace csgsim::testing {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;

Nef nef_of(const model::Primitive& primitive) {
  std::vector<Kernel::Point_3> points;
  for (const glm::dvec3& vertex : facet::make_solid(primitive).vertices)
    points.emplace_back(vertex.x, vertex.y, vertex.z);
  CGAL::Polyhedron_3<Kernel> hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  return Nef(hull);
}

void apply(model::Operator op, Nef& to, const Nef& other) {
  switch (op) {
    case model::Operator::unite: to += other; break;
    case model::Operator::subtract: to -= other; break;
    case model::Operator::intersect: to *= other; break;
  }
  to = to.regularization();
}

}  // namespace

double nef_volume(const model::Tree& tree) {
  std::vector<Nef> values;
  for (const model::Node& node : tree.nodes) {
    if (node.is_leaf) {
      values.push_back(nef_of(tree.primitives[node.primitive]));
      continue;
    }
    Nef value = values[node.children.front()];
    for (std::size_t i = 1; i < node.children.size(); ++i) apply(node.op, value, values[node.children[i]]);
    values.push_back(std::move(value));
  }
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> triangles;
  CGAL::convert_nef_polyhedron_to_polygon_soup(values[tree.root], points, triangles, true);
  Kernel::FT six_times = 0;
  for (const std::vector<std::size_t>& corners : triangles) {
    six_times += CGAL::determinant(points[corners[0]] - CGAL::ORIGIN, points[corners[1]] - CGAL::ORIGIN,
                                   points[corners[2]] - CGAL::ORIGIN);
  }
  return CGAL::to_double(six_times) / 6;
}

}  // namespace csgsim::testing
