#include "tests/unit/read/random_model.h"

#include <fmt/format.h>
#include <rapidcheck.h>

#include <algorithm>
#include <optional>

namespace csgsim::read_test {

namespace {

using Kind = RandomNode::Kind;
using model::Operator;

bool is_solid(Kind kind) { return kind >= Kind::cube; }

double random_number() {
  const int sort = *rc::gen::inRange(0, 4);
  if (sort == 0) return *rc::gen::inRange(-2, 4);
  if (sort == 1) return *rc::gen::inRange(1, 1'000'000) / 1024.0;
  return *rc::gen::inRange(1, 1'000'000'000) / 7e6;
}

glm::dvec3 random_vector() {
  const double x = random_number();
  const double y = random_number();
  return {x, y, random_number()};
}

RandomNode random_node(int depth) {
  RandomNode node;
  const int first = depth == 0 ? static_cast<int>(Kind::cube) : 0;
  node.kind = static_cast<Kind>(*rc::gen::inRange(first, static_cast<int>(Kind::octahedron) + 1));
  node.modifier = *rc::gen::weightedElement<char>({{12, ' '}, {1, '#'}, {1, '%'}, {1, '*'}});
  node.sizes = random_vector();
  node.shift = random_vector();
  node.scale = random_vector();
  node.colour = glm::dvec3(*rc::gen::inRange(-1, 9), *rc::gen::inRange(0, 9), *rc::gen::inRange(0, 9)) / 6.0;
  node.center = *rc::gen::arbitrary<bool>();
  node.facets = {random_number(), random_number(), random_number()};
  const int children = is_solid(node.kind) ? 0 : *rc::gen::inRange(0, 4);
  for (int i = 0; i < children; ++i) node.children.push_back(random_node(depth - 1));
  return node;
}

// ---- Expected tree: first a tree of parts, then the flat tree.

struct Part {
  std::optional<model::Primitive> leaf;
  Operator op = Operator::unite;
  std::vector<Part> children;
};

struct Surroundings {
  glm::dmat4 transform{1};
  std::optional<glm::dvec3> colour;
};

model::FacetControl raised(model::FacetControl facets) {
  return {facets.fn, std::max(facets.fa, 0.01), std::max(facets.fs, 0.01)};
}

/// x' = scale.x * y + shift.x, and cyclically for y and z: a rotated, stretched, mirrored or flattened space.
glm::dmat4 matrix_of(const RandomNode& node) {
  glm::dmat4 matrix(0);
  matrix[1][0] = node.scale.x;
  matrix[2][1] = node.scale.y;
  matrix[0][2] = node.scale.z;
  matrix[3] = glm::dvec4(node.shift, 1);
  return matrix;
}

const std::vector<std::vector<std::uint32_t>> octahedron_faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                                  {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};

std::vector<glm::dvec3> octahedron_points(const glm::dvec3& axes) {
  return {{axes.x, 0, 0}, {-axes.x, 0, 0}, {0, axes.y, 0}, {0, -axes.y, 0}, {0, 0, axes.z}, {0, 0, -axes.z}};
}

/// The octahedron unless an axis is zero, with points numbered as a reader may do: in the order of the faces.
model::Polyhedron octahedron(const glm::dvec3& axes) {
  const std::vector<glm::dvec3> points = octahedron_points(axes);
  const bool inside_out = axes.x * axes.y * axes.z < 0;
  std::vector<std::uint32_t> order;
  model::Polyhedron solid;
  for (const auto& face : octahedron_faces) {
    auto& corners = solid.faces.emplace_back();
    for (const std::uint32_t corner : face) {
      const auto known = std::ranges::find(order, corner);
      corners.push_back(static_cast<std::uint32_t>(known - order.begin()));
      if (known == order.end()) {
        order.push_back(corner);
        solid.points.push_back(points[corner]);
      }
    }
    if (inside_out) std::ranges::reverse(corners);
  }
  return solid;
}

std::optional<model::Shape> shape_of(const RandomNode& node) {
  const glm::dvec3& s = node.sizes;
  switch (node.kind) {
    case Kind::cube:
      if (std::min({s.x, s.y, s.z}) <= 0) return std::nullopt;
      return model::Cube{s, node.center};
    case Kind::sphere:
      if (s.x <= 0) return std::nullopt;
      return model::Sphere{s.x, raised(node.facets)};
    case Kind::cylinder:
      if (s.x <= 0 || std::min(s.y, s.z) < 0 || std::max(s.y, s.z) == 0) return std::nullopt;
      return model::Cylinder{s.x, s.y, s.z, node.center, raised(node.facets)};
    case Kind::octahedron:
      if (s.x * s.y * s.z == 0) return std::nullopt;
      return octahedron(s);
    case Kind::unite:
    case Kind::subtract:
    case Kind::intersect:
    case Kind::place:
    case Kind::paint: return std::nullopt;
  }
  return std::nullopt;
}

Operator operator_of(Kind kind) {
  if (kind == Kind::subtract) return Operator::subtract;
  return kind == Kind::intersect ? Operator::intersect : Operator::unite;
}

std::optional<Part> part_of(const RandomNode& node, Surroundings around);

std::optional<Part> combine(Operator op, const RandomModel& operands, const Surroundings& around) {
  Part part;
  part.op = op;
  bool is_first = true;
  for (const RandomNode& operand : operands) {
    if (operand.modifier == '%' || operand.modifier == '*') continue;
    std::optional<Part> child = part_of(operand, around);
    if (!child && (op == Operator::intersect || (op == Operator::subtract && is_first))) return std::nullopt;
    if (child) part.children.push_back(std::move(*child));
    is_first = false;
  }
  if (part.children.empty()) return std::nullopt;
  if (part.children.size() == 1) return Part(part.children.front());
  return part;
}

std::optional<Part> part_of(const RandomNode& node, Surroundings around) {
  if (is_solid(node.kind)) {
    std::optional<model::Shape> shape = shape_of(node);
    const glm::dmat3 linear(around.transform);
    if (!shape || glm::determinant(linear) == 0) return std::nullopt;
    return Part{model::Primitive{std::move(*shape), around.transform, around.colour, {}}, Operator::unite, {}};
  }
  if (node.kind == Kind::place) around.transform = around.transform * matrix_of(node);
  if (node.kind == Kind::paint && !around.colour && node.colour.x >= 0) {
    around.colour = glm::min(node.colour, glm::dvec3(1));
  }
  return combine(operator_of(node.kind), node.children, around);
}

std::uint32_t flatten(const Part& part, model::Tree& tree) {
  model::Node node;
  node.op = part.op;
  if (part.leaf) {
    node.is_leaf = true;
    node.primitive = static_cast<std::uint32_t>(tree.primitives.size());
    tree.primitives.push_back(*part.leaf);
  }
  for (const Part& child : part.children) node.children.push_back(flatten(child, tree));
  tree.nodes.push_back(std::move(node));
  return static_cast<std::uint32_t>(tree.nodes.size() - 1);
}

// ---- Printers.

std::string octahedron_text(const RandomNode& node, const char* format, const char* points_name,
                            const char* faces_name) {
  std::string points;
  for (const glm::dvec3& p : octahedron_points(node.sizes)) {
    points += fmt::format("{}[{}, {}, {}]", points.empty() ? "" : ", ", p.x, p.y, p.z);
  }
  std::string faces;
  for (const auto& face : octahedron_faces) {
    faces += fmt::format("{}[{}, {}, {}]", faces.empty() ? "" : ", ", face[0], face[1], face[2]);
  }
  return fmt::format(fmt::runtime(format), points_name, points, faces_name, faces);
}

std::string named_head(const RandomNode& node) {
  const glm::dvec3& s = node.sizes;
  const glm::dvec3& m = node.scale;
  const glm::dvec3& v = node.shift;
  const std::string facets =
      fmt::format("$fn = {}, $fa = {}, $fs = {}", node.facets.fn, node.facets.fa, node.facets.fs);
  switch (node.kind) {
    case Kind::unite: return "group()";
    case Kind::subtract: return "difference()";
    case Kind::intersect: return "intersection()";
    case Kind::place:
      return fmt::format("multmatrix([[0, {}, 0, {}], [0, 0, {}, {}], [{}, 0, 0, {}], [0, 0, 0, 1]])", m.x, v.x, m.y,
                         v.y, m.z, v.z);
    case Kind::paint: return fmt::format("color([{}, {}, {}, 1])", node.colour.x, node.colour.y, node.colour.z);
    case Kind::cube: return fmt::format("cube(size = [{}, {}, {}], center = {})", s.x, s.y, s.z, node.center);
    case Kind::sphere: return fmt::format("sphere({}, r = {})", facets, s.x);
    case Kind::cylinder:
      return fmt::format("cylinder({}, h = {}, r1 = {}, r2 = {}, center = {})", facets, s.x, s.y, s.z, node.center);
    case Kind::octahedron:
      return octahedron_text(node, "polyhedron({} = [{}], {} = [{}], convexity = 1)", "points", "faces");
  }
  return "";
}

std::string packed_head(const RandomNode& node) {
  const glm::dvec3& s = node.sizes;
  const glm::dvec3& m = node.scale;
  const glm::dvec3& v = node.shift;
  const std::string facets =
      fmt::format("$fs={:.17e},$fn={:.17g},$fa={:+.17g}", node.facets.fs, node.facets.fn, node.facets.fa);
  switch (node.kind) {
    case Kind::unite: return "union()";
    case Kind::subtract: return "difference()";
    case Kind::intersect: return "intersection(convexity=2)";
    case Kind::place:
      return fmt::format("multmatrix(m=[[0,{:.17g},0,{:.17g}],[0,0,{:.17g},{:.17g}],[{:.17g},0,0,{:.17g},],])", m.x,
                         v.x, m.y, v.y, m.z, v.z);
    case Kind::paint:
      return fmt::format("color(alpha=.5,[{:.17g},{:.17g},{:.17g}])", node.colour.x, node.colour.y, node.colour.z);
    case Kind::cube: return fmt::format("cube(center={},[{:.17g},{:.17g},{:.17E}],)", node.center, s.x, s.y, s.z);
    case Kind::sphere: return fmt::format("sphere(d={:.17g}/**/,{})", 2 * s.x, facets);
    case Kind::cylinder:
      return fmt::format("cylinder(center={},{:.17g},{:.17g},d2={:.17g},{})//\n", node.center, s.x, s.y, 2 * s.z,
                         facets);
    case Kind::octahedron: return octahedron_text(node, "polyhedron({2}=[{3}],{0}=[{1}])", "points", "triangles");
  }
  return "";
}

std::string print(const RandomModel& model, std::string (*head)(const RandomNode&), std::string_view line_end) {
  std::string text;
  for (const RandomNode& node : model) {
    if (node.modifier != ' ') text += node.modifier;
    text += head(node);
    text += is_solid(node.kind) ? ";" : fmt::format("{{{}{}}}", line_end, print(node.children, head, line_end));
    text += line_end;
  }
  return text;
}

}  // namespace

RandomModel random_model() {
  RandomModel model;
  const int count = *rc::gen::inRange(1, 4);
  for (int i = 0; i < count; ++i) model.push_back(random_node(4));
  return model;
}

model::Tree expected_tree(const RandomModel& model) {
  model::Tree tree;
  if (const std::optional<Part> part = combine(Operator::unite, model, {})) tree.root = flatten(*part, tree);
  return tree;
}

std::string print_named(const RandomModel& model) { return print(model, named_head, "\n"); }

std::string print_packed(const RandomModel& model) { return print(model, packed_head, ""); }

}  // namespace csgsim::read_test
