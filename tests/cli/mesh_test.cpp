#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

std::string commands(const std::string& name) {
  return std::string(CSGSIM_SOURCE_DIR) + "/tests/models/" + name + ".jan";
}

}  // namespace

TEST_CASE("mesh compares filter and quadtree on one mesh and reuses its measurements") {
  const Folder folder;
  const std::string words = "mesh " + commands("thesis_fig_3_9") + " -o " + (folder / "m");
  const Outcome first = require_success(run(words + " --tolerances 0.1,0.05"));
  CHECK(first.out.find("maximum elements held") != std::string::npos);
  const nlohmann::json points = json(folder / "m/mesh.json")["points"];
  REQUIRE(points.size() == 4);
  const nlohmann::json& filter = points[0];
  const nlohmann::json& quadtree = points[2];
  CHECK(filter["repair"] == "filter");
  CHECK(quadtree["repair"] == "quadtree");
  CHECK(filter["elements"] == quadtree["elements"]);
  CHECK(filter["vertices"] == quadtree["vertices"]);
  CHECK(quadtree["most_elements"] == quadtree["elements"]);
  CHECK(filter["most_elements"] < filter["elements"]);
  CHECK(filter["seconds"]["mc68000"]["repairing"] < quadtree["seconds"]["mc68000"]["repairing"]);
  CHECK(filter["seconds"]["mc68000"]["subdividing"] == quadtree["seconds"]["mc68000"]["subdividing"]);
  CHECK(fs::file_size(folder / "m/mesh_Patch_plane.svg") > 1000);
  const std::string table = content(folder / "m/mesh.csv");
  require_success(run(words + " --tolerances 0.1,0.05,0.02"));
  CHECK(content(folder / "m/mesh.csv").starts_with(table.substr(0, 200)));
  CHECK(json(folder / "m/mesh.json")["points"].size() == 6);
}

TEST_CASE("a tolerance too fine for a surface gives a reason and alone it is an error") {
  const Folder folder;
  const std::string words = "mesh " + commands("jug") + " --repairs filter --flatness sides ";
  const Outcome both = require_success(run(words + "--tolerances 1,1e-12 -o " + (folder / "m")));
  CHECK(both.out.find("use a coarser tolerance") != std::string::npos);
  fails(run(words + "--tolerances 1e-12 -o " + (folder / "n")), 1, {"use a coarser tolerance"});
}

TEST_CASE("mesh rejects unknown names and files without a surface") {
  check_misuse("mesh " + commands("jug") + " --flatness flat", "the flatness tests are");
  check_misuse("mesh " + commands("jug") + " --repairs filtre", "did you mean filter");
  check_misuse("mesh " + commands("jug") + " --tolerances 0", "is not a tolerance");
  check_misuse("mesh " + commands("jug") + " --processors this-computer", "has no prices");
  fails(run("mesh " + commands("thesis_fig_2_3")), 1, {"contains no sweep and no patch"});
  fails(run("mesh " + model("sphere")), 1,
        {"sphere.csg: only sweeps and patches of command files (.jan) can be meshed"});
}

TEST_CASE("a .jan command file draws the picture of its .csg and its errors have a place") {
  const Folder folder;
  const std::string view = " --camera 42,-38,41,10,5.5,2 --size 96x96 -o ";
  require_success(run("render " + commands("thesis_fig_2_3") + view + (folder / "one.png")));
  require_success(run("render " + model("thesis_fig_2_3") + view + (folder / "other.png")));
  CHECK(content(folder / "one.png") == content(folder / "other.png"));
  std::ofstream(folder / "bad.jan") << "A = block 1 2\n";
  fails(run("render " + (folder / "bad.jan") + " -o " + (folder / "bad.png")), 1,
        {"bad.jan:1:14: expected a block's length along z, found the end of the line"});
}

TEST_CASE("an exported mesh has the counted vertices and elements and no edge used 3 times") {
  const Folder folder;
  require_success(run("mesh " + commands("thesis_fig_3_9") + " --tolerances 0.1 --repairs filter --json " +
                      (folder / "m.json") + " -o " + (folder / "m")));
  const nlohmann::json point = json(folder / "m/mesh.json")["points"][0];
  const nlohmann::json mesh = json(folder / "m.json")["meshes"][0];
  CHECK(mesh["tolerance"] == 0.1);
  CHECK(mesh["elements"].size() == point["elements"]);
  std::set<std::uint64_t> used;
  std::map<std::pair<std::uint64_t, std::uint64_t>, int> edges;
  for (const nlohmann::json& element : mesh["elements"]) {
    for (std::size_t i = 0; i < element.size(); ++i) {
      const std::uint64_t from = element[i];
      const std::uint64_t to = element[(i + 1) % element.size()];
      used.insert(from);
      ++edges[{std::min(from, to), std::max(from, to)}];
    }
  }
  CHECK(used.size() == point["vertices"]);
  CHECK(used.size() == mesh["vertices"].size());
  // A patch is a disc: vertices - edges + elements = 1. A vertex on an element's side without being its corner would
  // break this.
  CHECK(used.size() - edges.size() + mesh["elements"].size() == 1);
  for (const auto& [edge, elements] : edges) CHECK(elements <= 2);
}
