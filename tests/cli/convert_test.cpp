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
  for (const char* const ending : {"stl", "off", "obj", "ply", "3mf", "amf"}) {
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
  const Outcome outcome = require_success(run("convert " + model("thesis_fig_2_3") + " -o " + (folder / "a.stl")));
  CHECK(outcome.out.find("3 primitives, 0 unions, 1 difference, 1 intersection") != std::string::npos);
  CHECK(outcome.out.find("1 shell, Euler number 2, genus 0") != std::string::npos);
  CHECK(content(folder / "a.stl").find("binary STL") == 0);
  require_success(run("convert " + model("thesis_fig_2_3") + " -o " + (folder / "b.stl") + " --ascii"));
  CHECK(content(folder / "b.stl").find("solid csgsim\nfacet normal ") == 0);
}

TEST_CASE("convert writes each format to standard output and reads standard input") {
  const Folder folder;
  for (const char* const format : {"stl", "off", "obj", "ply", "3mf", "amf", "bintree"}) {
    CAPTURE(format);
    const std::string file = folder / (std::string("a.") + format);
    require_success(run("convert " + model("thesis_fig_2_3") + " -o " + file));
    const std::string piped = folder / "piped";
    const Outcome outcome =
        run_program("sh", {"-c", std::string(CSGSIM_BINARY_DIR) + "/csgsim convert - -o - --format " + format + " < " +
                                     model("thesis_fig_2_3") + " > " + piped});
    CHECK(outcome.code == 0);
    CHECK(outcome.err.find("volume ") != std::string::npos);
    CHECK(content(piped) == content(file));
  }
}

TEST_CASE("--format selects the format whatever the name's ending") {
  const Folder folder;
  require_success(run("convert " + model("thesis_fig_2_3") + " --format off -o " + (folder / "a.stl")));
  CHECK(content(folder / "a.stl").starts_with("OFF\n"));
}

TEST_CASE("convert writes a flat model with its area, which reads back") {
  const Folder folder;
  write(folder / "flat.csg",
        "difference() { square(size = [10, 8], center = false); circle($fn = 12, $fa = 12, $fs = 2, r = 2); }");
  for (const char* const file : {"flat.svg", "flat.dxf"}) {
    CAPTURE(file);
    const nlohmann::json stats = converted(folder, folder / "flat.csg", file);
    CHECK(stats["outlines"] == 1);
    CHECK(stats["area"].get<double>() == doctest::Approx(80 - 3));  // a dodecagon of radius 2 has 12
    write(folder / "again.csg", import_of(file));
    const nlohmann::json again = converted(folder, folder / "again.csg", "again.svg");
    CHECK(again["area"].get<double>() == doctest::Approx(77).epsilon(1e-5));
    CHECK(again["points"] == stats["points"]);
  }
}

TEST_CASE("every command that takes a model takes a mesh in each format") {
  const Folder folder;
  const std::string corner = std::string(CSGSIM_SOURCE_DIR) + "/tests/models/solids/corner.";
  for (const char* const ending : {"stl", "off", "obj", "ply", "3mf", "amf"}) {
    CAPTURE(ending);
    // A block of 4 by 3 by 2 minus a corner of 2.5 by 1.75.
    CHECK(converted(folder, corner + ending, "a.off")["volume"].get<double>() ==
          doctest::Approx(2 * (4 * 3 - 2.5 * 1.75)));
    const Outcome drawn = require_success(run("render " + corner + ending + " --size 32x32"));
    CHECK(drawn.out.find("1 primitive, ") != std::string::npos);
  }
  const std::string small = " --size 16x16";
  require_success(run("explain " + corner + "ply --pixel 8,8" + small));
  require_success(run("levels " + corner + "stl" + small));
  require_success(run("diff " + corner + "obj " + corner + "ply" + small));
  require_success(run("subdivide " + corner + "amf" + small + " --no-plots -o " + (folder / "s")));
  fails(run("run " + corner + "stl"), 1, {"that is a model; csgsim render draws it"});
}

TEST_CASE("an error in a mesh as a model names the file and the face") {
  const Folder folder;
  const auto error = [&](const std::string& name, const std::string& text) {
    write(folder / name, text);
    return run("render " + (folder / name));
  };
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const std::string file = folder / "open.obj";
  fails(error("open.obj", points + "f 1 3 2\nf 1 2 4\nf 2 3 4\n"), 1, {file + ": face "});
  CHECK(error("open.obj", points + "f 1 3 2\nf 1 2 4\nf 2 3 4\n").err.find(":1:1:") == std::string::npos);
  fails(error("bad.obj", "v 0 0 zero\n"), 1, {(folder / "bad.obj") + ":1:7: a coordinate must be a finite number"});
  fails(error("bad.ply", "ply\n"), 1, {(folder / "bad.ply") + ": the header of a PLY file must end with 'end_header'"});
  fails(error("none.off", "OFF\n0 0 0\n"), 1, {(folder / "none.off") + ": the mesh has no faces"});
  fails(run("render " + (folder / "missing.stl")), 1, {folder / "missing.stl"});
  // All faces inside out: the solid is turned, as OpenSCAD shows it.
  CHECK(error("turned.obj", points + "f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n").code == 0);
}

TEST_CASE("convert reports a block model's blocks and its volume is near the mesh's") {
  const Folder folder;
  const double volume = converted(folder, model("thesis_fig_2_3"), "a.off")["volume"];
  require_success(run("convert " + model("thesis_fig_2_3") + " -o " + (folder / "a.bintree") +
                      " --resolution 64 --stats " + (folder / "s.json")));
  CHECK(content(folder / "a.bintree").find("bintree 1\nresolution 64\ncube ") == 0);
  // Half a cell along the surface is 9 % of the volume.
  CHECK(json(folder / "s.json")["volume"].get<double>() == doctest::Approx(volume).epsilon(0.05));
}

TEST_CASE("convert reports what it cannot convert and writes nothing") {
  const Folder folder;
  write(folder / "flat.csg", "square(size = [1, 2], center = false);");
  const std::string output = " -o " + (folder / "a.stl");
  const Outcome flat = run("convert " + (folder / "flat.csg") + output);
  fails(flat, 1, {"the model is flat; extrude it, or write .svg or .dxf"});
  fails(run("convert " + model("thesis_fig_2_3") + " -o " + (folder / "a.svg")), 1,
        {"the model is solid; project it, or name a format of solids such as .stl"});
  CHECK(folder.files() == 1);
  write(folder / "flat.csg",
        "difference() { cube(size = [1, 1, 1], center = false); cube(size = [1, 1, 1], center = false); }");
  CHECK(run("convert " + (folder / "flat.csg") + output).err.find("the model is empty") != std::string::npos);
  check_misuse(
      "convert " + model("thesis_fig_2_3") + " -o " + (folder / "a.vrml"),
      "unknown ending; end the name in one of .stl, .off, .obj, .ply, .3mf, .amf, .svg, .dxf, .bintree, or name a "
      "format with --format");
  check_misuse("convert " + model("thesis_fig_2_3") + " -o -",
               "--format: - has no ending that selects a format; name one, as in --format stl");
  check_misuse("convert " + model("thesis_fig_2_3") + " -o - --format vrml", "there is no format 'vrml'");
  check_misuse("convert " + model("thesis_fig_2_3") + " --ascii -o " + (folder / "a.off"),
               "a .off file has only one form");
  check_misuse("convert " + model("thesis_fig_2_3") + " --resolution 8 -o " + (folder / "a.off"),
               "applies to .bintree files only");
  check_misuse("convert " + model("thesis_fig_2_3") + " --resolution 12 -o " + (folder / "a.bintree"),
               "a power of two");
  check_misuse("convert " + model("thesis_fig_2_3") + " --tolerance 1px" + output, "a tolerance in model units");
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
