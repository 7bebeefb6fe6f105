#include "host/solids/evaluate.h"

#include <algorithm>

#include "host/convex/pieces.h"
#include "host/csg/positive_tree.h"
#include "host/facet/geometry.h"
#include "host/solids/polyhedra.h"

namespace csgsim::solids {

namespace {

bool is_union(const model::Tree& tree) {
  return std::all_of(tree.nodes.begin(), tree.nodes.end(),
                     [](const model::Node& node) { return node.is_leaf || node.op == model::Operator::unite; });
}

}  // namespace

std::vector<model::Polyhedron> evaluate_pieces(const model::Tree& tree, const Work& work) {
  if (tree.root == model::no_index) return {};
  const facet::Geometry scene = facet::make_geometry(tree);
  std::vector<model::Polyhedron> made;
  const auto add = [&](const convex::Polytope& polytope) {
    if (!polytope.empty()) made.push_back(to_polyhedron(polytope, scene.planes));
  };
  if (is_union(tree)) {
    for (const facet::Convex& solid : scene.solids) add(convex::make_polytope(solid, scene.planes, work));
  } else {
    for (const convex::Piece& piece : convex::pieces(scene, csg::make_positive_tree(tree), convex::max_pieces, work))
      add(piece.polytope);
  }
  return made;
}

std::vector<glm::dvec3> evaluate_vertices(const model::Tree& tree, const Work& work) {
  std::vector<glm::dvec3> vertices;
  if (tree.root == model::no_index) return vertices;
  if (is_union(tree)) {
    for (const facet::Convex& solid : facet::make_geometry(tree).solids) {
      vertices.insert(vertices.end(), solid.vertices.begin(), solid.vertices.end());
    }
    return vertices;
  }
  for (const model::Polyhedron& piece : evaluate_pieces(tree, work)) {
    vertices.insert(vertices.end(), piece.points.begin(), piece.points.end());
  }
  return vertices;
}

}  // namespace csgsim::solids
