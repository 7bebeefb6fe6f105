#include "tests/unit/read/support.h"

#include "host/model/shapes.h"
#include "host/read/read.h"
#include "hw/base/messages.h"
#include "tests/support/test.h"

namespace csgsim::read_test {

namespace {

const char* name_of(model::Operator op) {
  switch (op) {
    case model::Operator::unite: return "union";
    case model::Operator::subtract: return "difference";
    case model::Operator::intersect: return "intersection";
  }
  return "";
}

std::string outline(const model::Tree& tree, std::uint32_t index) {
  const model::Node& node = tree.nodes[index];
  if (node.is_leaf) return std::string(model::name_of(tree.primitives[node.primitive].shape));
  std::string text;
  for (const std::uint32_t child : node.children) text += (text.empty() ? "" : ", ") + outline(tree, child);
  return fmt::format("{}({})", name_of(node.op), text);
}

std::string dump(const model::FacetControl& facets) {
  return fmt::format("fn={} fa={} fs={}", facets.fn, facets.fa, facets.fs);
}

struct ShapeDumper {
  std::string operator()(const model::Cube& cube) const {
    return fmt::format("cube {} {} {} {}", cube.size.x, cube.size.y, cube.size.z, cube.center);
  }
  std::string operator()(const model::Sphere& sphere) const {
    return fmt::format("sphere {} {}", sphere.radius, dump(sphere.facets));
  }
  std::string operator()(const model::Cylinder& c) const {
    return fmt::format("cylinder {} {} {} {} {}", c.height, c.r1, c.r2, c.center, dump(c.facets));
  }
  std::string operator()(const model::Polyhedron& polyhedron) const {
    std::string text = "polyhedron";
    for (const glm::dvec3& p : polyhedron.points) text += fmt::format(" ({} {} {})", p.x, p.y, p.z);
    for (const auto& face : polyhedron.faces) {
      text += " [";
      for (const std::uint32_t corner : face) text += fmt::format(" {}", corner);
      text += " ]";
    }
    return text;
  }
};

}  // namespace

model::Tree read(std::string_view text) { return read::read_csg_text(text, "m.csg"); }

ReadResult read_with_warnings(std::string_view text) {
  const CollectedLines kept;
  model::Tree tree = read(text);
  return {std::move(tree), kept.lines()};
}

std::string error_of(std::string_view text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  FAIL("no error from: " << std::string(text.substr(0, 200)));
  return "";
}

std::string outline(const model::Tree& tree) {
  return tree.root == model::no_index ? "nothing" : outline(tree, tree.root);
}

std::string dump(const model::Tree& tree) {
  std::string text;
  for (const model::Primitive& primitive : tree.primitives) {
    text += std::visit(ShapeDumper{}, primitive.shape);
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) text += fmt::format(" {}", primitive.transform[column][row] + 0.0);
    }
    if (const auto& colour = primitive.colour) text += fmt::format(" colour {} {} {}", colour->x, colour->y, colour->z);
    text += '\n';
  }
  for (const model::Node& node : tree.nodes) {
    text += node.is_leaf ? fmt::format("leaf {}", node.primitive) : name_of(node.op);
    for (const std::uint32_t child : node.children) text += fmt::format(" {}", child);
    text += '\n';
  }
  return text + fmt::format("root {}\n", tree.root);
}

}  // namespace csgsim::read_test
