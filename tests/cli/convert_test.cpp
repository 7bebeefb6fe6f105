#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

nlohmann::json converted(const Folder& folder, const std::string& model, const std::string& output) {
  const Outcome outcome =
      run("convert " + model + " -o " + (folder / output) + " --stats " + (folder / "stats.json") + " --quiet");
  CHECK(outcome.code == 0);
  CHECK(outcome.out == "");
  return json(folder / "stats.json");
}

std::string import_of(const std::string& file) {
  return "import(file = \"" + file +
         "\", layer = \"\", origin = [0, 0], scale = 1, convexity = 1, $fn = 0, $fa = 12, $fs = 2, timestamp = 0);";
}

}  // namespace

TEST_CASE("a converted model has the volume and shape of its source when imported again") {
  for (const char* const ending : {"stl", "off", "3mf"}) {
    CAPTURE(ending);
    const Folder folder;
    const std::string file = std::string("mesh.") + ending;
    const nlohmann::json first = converted(folder, model("old_example003"), file);
    CHECK(first["volume"].get<double>() == doctest::Approx(23750).epsilon(1e-12));
    CHECK(first["genus"] == 5);
    write(folder / "again.csg", import_of(file));
    const nlohmann::json again = converted(folder, folder / "again.csg", "again.off");
    CHECK(again["volume"].get<double>() == doctest::Approx(23750).epsilon(1e-9));
    CHECK(again["shells"] == first["shells"]);
    CHECK(again["euler_number"] == first["euler_number"]);
  }
}

TEST_CASE("convert writes binary STL by default and text on request and reports both") {
  const Folder folder;
  const Outcome outcome = succeeded(run("convert " + model("thesis_fig_2_3") + " -o " + (folder / "a.stl")));
  CHECK(outcome.out.find("3 primitives, 0 unions, 1 difference, 1 intersection") != std::string::npos);
  CHECK(outcome.out.find("1 shell, Euler number 2, genus 0") != std::string::npos);
  CHECK(content(folder / "a.stl").find("binary STL") == 0);
  succeeded(run("convert " + model("thesis_fig_2_3") + " -o " + (folder / "b.stl") + " --ascii"));
  CHECK(content(folder / "b.stl").find("solid csgsim\nfacet normal ") == 0);
}

TEST_CASE("convert reports a block model's blocks and its volume is near the mesh's") {
  const Folder folder;
  const double volume = converted(folder, model("thesis_fig_2_3"), "a.off")["volume"];
  succeeded(run("convert " + model("thesis_fig_2_3") + " -o " + (folder / "a.bintree") + " --resolution 64 --stats " +
                (folder / "s.json")));
  CHECK(content(folder / "a.bintree").find("bintree 1\nresolution 64\ncube ") == 0);
  // Half a cell along the surface is 9 % of the volume.
  CHECK(json(folder / "s.json")["volume"].get<double>() == doctest::Approx(volume).epsilon(0.05));
}

TEST_CASE("convert reports what it cannot convert and writes nothing") {
  const Folder folder;
  write(folder / "flat.csg", "square(size = [1, 2], center = false);");
  const std::string output = " -o " + (folder / "a.stl");
  const Outcome flat = run("convert " + (folder / "flat.csg") + output);
  fails(flat, 1, {"the model is flat and only solids can be converted; extrude it"});
  CHECK(folder.files() == 1);
  write(folder / "flat.csg",
        "difference() { cube(size = [1, 1, 1], center = false); cube(size = [1, 1, 1], center = false); }");
  CHECK(run("convert " + (folder / "flat.csg") + output).err.find("the model is empty") != std::string::npos);
  misused("convert " + model("thesis_fig_2_3") + " -o " + (folder / "a.obj"),
          "unknown ending; end the name in one of .stl, .off, .3mf, .bintree");
  misused("convert " + model("thesis_fig_2_3") + " --ascii -o " + (folder / "a.off"), "a .off file has only one form");
  misused("convert " + model("thesis_fig_2_3") + " --resolution 8 -o " + (folder / "a.off"),
          "applies to .bintree files only");
  misused("convert " + model("thesis_fig_2_3") + " --resolution 12 -o " + (folder / "a.bintree"), "a power of two");
  misused("convert " + model("thesis_fig_2_3") + " --tolerance 1px" + output, "a tolerance in model units");
  CHECK(folder.files() == 1);
}

TEST_CASE("convert rejects a model too thin for the coordinates of a mesh") {
  const Folder folder;
  fails(run("convert " + std::string(CSGSIM_SOURCE_DIR) + "/tests/unit/convert/models/sheet.csg -o " +
            (folder / "a.off")),
        1, {"sheet.csg: solids are too thin for their size"});
  CHECK(folder.files() == 0);
}

TEST_CASE("convert stops a conversion that exceeds the work limit") {
  const Folder folder;
  fails(run("convert " + model("molecule") + " --limit 1 -o " + (folder / "a.stl")), 1,
        {"converting the model to a boundary"});
  CHECK(folder.files() == 0);
}
