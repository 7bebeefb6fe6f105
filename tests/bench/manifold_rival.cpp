// Compares csgsim convert with Manifold (https://github.com/elalish/manifold) on the same primitives and tree, as rows
// of a table: bench_manifold MODEL.csg ...

#include <fmt/format.h>
#include <manifold/manifold.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "host/facet/solid.h"
#include "host/read/read.h"
#include "places.h"
#include "sim/software/convert/boundary.h"
#include "sim/software/convert/surface.h"

using namespace csgsim;

namespace {

namespace convert = software::convert;
using manifold::Manifold;

constexpr int runs = 5;

/// Processor time of this process, over all threads.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The median time of several calls, and the last result.
template <class Make>
auto timed(const Make& make) {
  std::vector<double> seconds;
  auto made = make();
  for (int i = 0; i < runs; ++i) {
    const double begin = processor_seconds();
    made = make();
    seconds.push_back(processor_seconds() - begin);
  }
  std::ranges::nth_element(seconds, seconds.begin() + runs / 2);
  return std::pair(std::move(made), seconds[runs / 2]);
}

glm::dvec3 normal_of(const facet::Solid& solid, const facet::Face& face) {
  const auto at = [&](std::size_t i) { return solid.vertices[face.corners[i]]; };
  glm::dvec3 sum(0);
  for (std::size_t i = 1; i + 1 < face.corners.size(); ++i) sum += glm::cross(at(i) - at(0), at(i + 1) - at(0));
  return sum;
}

Manifold manifold_of(const model::Primitive& primitive) {
  const facet::Solid solid = facet::make_solid(primitive);
  manifold::MeshGL64 mesh;
  mesh.numProp = 3;
  for (const glm::dvec3& vertex : solid.vertices)
    mesh.vertProperties.insert(mesh.vertProperties.end(), {vertex.x, vertex.y, vertex.z});
  for (const facet::Face& face : solid.faces) {
    const bool is_forward = glm::dot(normal_of(solid, face), face.plane.normal) > 0;
    for (std::size_t i = 1; i + 1 < face.corners.size(); ++i) {
      std::pair<std::uint64_t, std::uint64_t> others(face.corners[i], face.corners[i + 1]);
      if (!is_forward) std::swap(others.first, others.second);
      mesh.triVerts.insert(mesh.triVerts.end(), {face.corners[0], others.first, others.second});
    }
  }
  return Manifold(mesh);
}

Manifold evaluated(const model::Tree& tree) {
  std::vector<Manifold> values;
  for (const model::Node& node : tree.nodes) {
    if (node.is_leaf) {
      values.push_back(manifold_of(tree.primitives[node.primitive]));
      continue;
    }
    std::vector<Manifold> operands;
    for (const std::uint32_t child : node.children) operands.push_back(values[child]);
    const auto op = node.op == model::Operator::unite      ? manifold::OpType::Add
                    : node.op == model::Operator::subtract ? manifold::OpType::Subtract
                                                           : manifold::OpType::Intersect;
    values.push_back(Manifold::BatchBoolean(operands, op));
  }
  Manifold result = values[tree.root];
  static_cast<void>(result.Status());  // Manifold evaluates on first access
  return result;
}

void compare(const std::filesystem::path& path) {
  const model::Tree tree = read::read_csg_file(path, {.imports_from = CSGSIM_SOURCE_DIR "/tests"});
  const auto [ours, our_time] = timed([&] { return convert::make_surface(convert::boundary(tree)); });
  const auto [theirs, their_time] = timed([&] { return evaluated(tree); });
  const convert::Measures measures = convert::measure(ours);
  std::int64_t genus = 0;
  const std::vector<Manifold> shells = theirs.Decompose();
  for (const Manifold& shell : shells) genus += shell.Genus();
  fmt::print("| `{}` | {:L} | {:L} | {:L} | {:.0e} | {:.0e} | {} / {} | {} / {} | {:.1f} | {:.1f} | {:.2f} |\n",
             path.stem().native(), tree.primitives.size(), ours.triangles.size(), theirs.NumTri(),
             std::abs(theirs.Volume() / measures.volume - 1), std::abs(theirs.SurfaceArea() / measures.area - 1),
             measures.shells, shells.size(), measures.genus(), genus, 1e3 * our_time, 1e3 * their_time,
             their_time / our_time);
}

}  // namespace

int main(int argc, char** argv) {
  fmt::print(
      "| model | pieces | triangles | Manifold's | volume off by | area off by | shells | genus | csgsim, ms | "
      "Manifold, ms | times as fast |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (int i = 1; i < argc; ++i) compare(argv[i]);
}
