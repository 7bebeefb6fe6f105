#include "sim/viewer/trees.h"

#include <unistd.h>

#include "hw/isa/facts.h"
#include "hw/isa/pieces.h"
#include "places.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/model_request.h"
#include "tests/support/test.h"

using namespace csgsim;
using Json = nlohmann::ordered_json;

namespace {

struct Compiled {
  explicit Compiled(std::vector<std::string> words)
      : options(session::parse_model_request(words)),
        machine(session::machine_of(options)),
        model(session::compile_model(options, machine)) {}

  session::ModelRequest options;
  machines::Machine machine;
  session::CompiledModel model;
};

Compiled compiled(const std::string& model, std::vector<std::string> words) {
  words.insert(words.begin(), CSGSIM_SOURCE_DIR "/tests/models/" + model + ".csg");
  return Compiled(std::move(words));
}

using Primitives = std::set<std::uint32_t>;

/// Primitives in rows of a tree.
Primitives primitives_in(const Json& rows) {
  Primitives primitives;
  for (const Json& row : rows) {
    if (row.contains("primitive")) primitives.insert(row.at("primitive").get<std::uint32_t>());
    for (const Json& other : row.value("others", Json::array())) primitives.insert(other.get<std::uint32_t>());
  }
  return primitives;
}

/// Primitives compared with each drawn piece by the segment's instructions.
std::map<std::uint32_t, Primitives> compared_in(const isa::Segment& segment, const isa::Facts& facts) {
  std::map<std::uint32_t, Primitives> compared;
  for (const isa::Instruction& one : segment.instructions) {
    const isa::Origin& origin = one.origin;
    if (origin.primitive == isa::no_primitive) continue;
    Primitives& with = compared[origin.primitive];
    if (origin.purpose == isa::Purpose::classify && origin.node != isa::no_primitive)
      with.insert(isa::primitive_of(facts, origin.node));
  }
  return compared;
}

/// Whether the tree contains the compared primitives; those of a leaf are compared one after another, under the name of
/// each or of the first.
bool covers(const Json& active, const Primitives& compared) {
  const Primitives known = primitives_in(active);
  if (!std::ranges::includes(known, compared)) return false;
  return std::ranges::all_of(active, [&](const Json& row) {
    return !row.contains("primitive") || compared.contains(row.at("primitive").get<std::uint32_t>());
  });
}

}  // namespace

TEST_CASE("a surface's active tree has the Program's compared primitives on each machine") {
  std::size_t surfaces = 0;
  for (const char* const model : {"thesis_fig_2_3", "basics_csg", "carburettor"}) {
    for (const char* const machine : {"pixel-planes-4", "scan-line", "pixel-square", "pixel-planes-5"}) {
      CAPTURE(model);
      CAPTURE(machine);
      const Compiled one = compiled(model, {"--machine", machine, "--size", "64x48", "--view-all"});
      viewer::ActiveTrees trees(one.model, one.machine);
      const isa::Program& program = one.model.program;
      for (std::uint32_t segment = 0; segment < program.segments.size(); ++segment) {
        for (const auto& known : compared_in(program.segments[segment], *program.facts)) {
          const std::uint32_t piece = known.first;
          CAPTURE(segment);
          CAPTURE(piece);
          const auto active = trees.of(piece, segment);
          REQUIRE(active);
          CHECK_MESSAGE(covers(*active, known.second), active->dump());
          ++surfaces;
        }
      }
    }
  }
  CHECK(surfaces > 300);
}

TEST_CASE("a tree has each primitive once in order and deepens only after operators") {
  const Compiled one = compiled("carburettor", {"--size", "32x32", "--view-all"});
  const Json rows = viewer::tree_json(one.model.tree, *one.model.program.facts);
  std::vector<std::uint32_t> primitives;
  std::size_t deepest = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto depth = rows[i].at("depth").get<std::size_t>();
    CHECK(depth <=
          (i == 0 ? 0 : rows[i - 1].at("depth").get<std::size_t>() + (rows[i - 1].contains("primitive") ? 0U : 1U)));
    deepest = std::max(deepest, depth);
    if (rows[i].contains("primitive")) primitives.push_back(rows[i].at("primitive"));
  }
  CHECK(deepest > 2);
  REQUIRE(primitives.size() == model::count(one.model.tree).primitives);
  for (std::uint32_t i = 0; i < primitives.size(); ++i) CHECK(primitives[i] == i);
}

TEST_CASE("a nonexistent piece has no active tree") {
  const Compiled one = compiled("thesis_fig_2_3", {"--size", "64x48", "--view-all"});
  viewer::ActiveTrees trees(one.model, one.machine);
  CHECK_FALSE(trees.of(1000, 0));
}

TEST_CASE("the first 4000 rows of a tree are shown and all rows of a smaller one") {
  for (const std::uint32_t leaves : {3998U, 3999U, 4000U, 5000U}) {
    model::Tree tree;
    model::Node root;
    model::Primitive cube;
    for (std::uint32_t i = 0; i < leaves; ++i) root.children.push_back(model::add_leaf(tree, cube));
    tree.root = static_cast<std::uint32_t>(tree.nodes.size());
    tree.nodes.push_back(std::move(root));
    isa::Facts facts;
    facts.primitives.assign(leaves, "cube");
    const Json rows = viewer::tree_json(tree, facts);
    CHECK(rows.size() == std::min(leaves + 1, 4000U));
    CHECK(rows[0] == Json::parse(R"({"depth":0,"text":"union"})"));
    CHECK(rows[3].at("primitive") == 2);
  }
}

TEST_CASE("a surface's active tree is that of the requested segment in any request order") {
  const Compiled one = compiled("carburettor", {"--machine", "pixel-planes-5", "--size", "384x384", "--view-all"});
  const isa::Program& program = one.model.program;
  REQUIRE(program.segments.size() > 2);
  const auto fresh = [&](std::uint32_t piece, std::uint32_t segment) {
    return viewer::ActiveTrees(one.model, one.machine).of(piece, segment);
  };
  viewer::ActiveTrees trees(one.model, one.machine);
  std::size_t differing = 0;
  for (std::uint32_t piece = 0; piece < 12; ++piece) {
    for (const std::uint32_t segment : {0U, 4U, 4U, 0U}) CHECK(trees.of(piece, segment) == fresh(piece, segment));
    if (fresh(piece, 0) != fresh(piece, 4)) ++differing;
  }
  CHECK(differing > 0);
}

namespace {

/// A small model from text, seen from the front.
Compiled small_compiled(const std::string& text, std::vector<std::string> more = {"--pruning", "none"}) {
  const std::string file =
      std::filesystem::temp_directory_path() / ("csgsim-trees-" + std::to_string(::getpid()) + ".csg");
  std::ofstream(file) << text;
  more.insert(more.begin(), {file, "--size", "33x25", "--camera", "0,-50,0,0,0,0"});
  Compiled made(std::move(more));
  std::filesystem::remove(file);
  return made;
}

const std::string cube_a = "cube(size=[8,6,4],center=true);";
const std::string sphere_b = "sphere(r=3);";
const std::string cylinder_c = "cylinder(h=9,r1=1,r2=1,center=true);";

/// Rows as text: two spaces per depth, the label, and a minus before an operand that must not contain the surface.
std::string rows_text(const Json& rows) {
  std::string text;
  for (const Json& row : rows) {
    text += std::string(2 * row.at("depth").get<std::size_t>(), ' ');
    if (row.value("complemented", false)) text += "-";
    const std::string label = row.at("text");
    text += label.substr(0, label.find(' ')) + "\n";
    if (row.contains("primitive")) CHECK(label.starts_with("p" + row.at("primitive").dump() + " "));
  }
  return text;
}

}  // namespace

TEST_CASE("a tree lists each operator with its operands one level deeper in order") {
  const auto tree = [](const std::string& text) {
    const Compiled one = small_compiled(text);
    return rows_text(viewer::tree_json(one.model.tree, *one.model.program.facts));
  };
  CHECK(tree(cube_a) == "p0\n");
  CHECK(tree("difference(){" + cube_a + sphere_b + cylinder_c + "}") == "difference\n  p0\n  p1\n  p2\n");
  CHECK(tree("intersection(){" + cube_a + "union(){" + sphere_b + cylinder_c + "}}") ==
        "intersection\n  p0\n  union\n    p1\n    p2\n");
  CHECK(tree("union(){difference(){" + cube_a + sphere_b + "}" + cylinder_c + "}") ==
        "union\n  difference\n    p0\n    p1\n  p2\n");
  CHECK(viewer::tree_json({}, {}) == Json::array());
}

TEST_CASE("pieces of one node are one row and an unnamed primitive is named by its number") {
  model::Tree tree;
  const model::Primitive cube;
  model::Node pieces;
  pieces.of_pieces = true;
  pieces.children = {model::add_leaf(tree, cube), model::add_leaf(tree, cube)};
  const std::uint32_t other = model::add_leaf(tree, cube);
  tree.nodes.push_back(pieces);
  model::Node root;
  root.op = model::Operator::subtract;
  root.children = {static_cast<std::uint32_t>(tree.nodes.size() - 1), other};
  tree.nodes.push_back(root);
  tree.root = static_cast<std::uint32_t>(tree.nodes.size() - 1);
  isa::Facts facts;
  facts.primitives = {"one"};
  const Json rows = viewer::tree_json(tree, facts);
  REQUIRE(rows.size() == 3);
  CHECK(rows[0] == Json::parse(R"({"depth":0,"text":"difference"})"));
  CHECK(rows[1] == Json::parse(R"({"depth":1,"text":"p0 one","primitive":0})"));
  CHECK(rows[2].at("depth") == 1);
  CHECK(rows[2].at("primitive") == isa::primitive_of(facts, 2));
  CHECK(rows[2].at("text") == "p" + rows[2].at("primitive").dump());
}

TEST_CASE("an active tree has intersected operands and complements of subtracted ones") {
  const auto active = [](const std::string& text, std::uint32_t piece) {
    const Compiled one = small_compiled(text);
    viewer::ActiveTrees trees(one.model, one.machine);
    const auto rows = trees.of(piece, 0);
    REQUIRE(rows);
    return rows_text(*rows);
  };
  const std::string difference = "difference(){" + cube_a + sphere_b + "}";
  CHECK(active(difference, 0) == "-p1\n");
  CHECK(active(difference, 1) == "p0\n");
  const std::string intersection = "intersection(){" + cube_a + "union(){" + sphere_b + cylinder_c + "}}";
  CHECK(active(intersection, 0) == "union\n  p1\n  p2\n");
  CHECK(active(intersection, 1) == "p0\n");
  CHECK(active("union(){" + cube_a + cylinder_c + "}", 0) == "");
  // A point outside a union is outside each operand.
  const std::string both = "difference(){" + cube_a + "union(){" + sphere_b + cylinder_c + "}}";
  CHECK(active(both, 0) == "-p1\n-p2\n");
  // A point outside an intersection is outside one operand at least.
  const std::string either = "difference(){" + cube_a + "intersection(){" + sphere_b + cylinder_c + "}}";
  CHECK(active(either, 0) == "union\n  -p1\n  -p2\n");
  // A point outside a difference is outside its first operand or in its second.
  const std::string hole = "difference(){" + cube_a + "difference(){" + sphere_b + cylinder_c + "}}";
  CHECK(active(hole, 0) == "union\n  -p1\n  p2\n");
}

TEST_CASE("primitives of one convex solid are one row except with the products strategy") {
  const auto active = [](const char* strategy) {
    const Compiled one = small_compiled("difference(){" + cube_a + "intersection(){" + sphere_b + cylinder_c + "}}",
                                        {"--strategy", strategy});
    viewer::ActiveTrees trees(one.model, one.machine);
    return trees.of(0, 0).value().dump();
  };
  CHECK(active("stack").find(R"("primitive":1,"complemented":true,"others":[2])") != std::string::npos);
  CHECK(active("products").find("others") == std::string::npos);
}
