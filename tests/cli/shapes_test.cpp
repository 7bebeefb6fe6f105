#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

const std::string thirty = "multmatrix([[0.866025, -0.5, 0, 0], [0.5, 0.866025, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])";

/// A cube turned by 120 degrees in one step, minus the same cube turned by 60, 30 and 30.
const std::string nothing =
    "difference() {\n"
    "multmatrix([[-0.5, -0.866025, 0, 0], [0.866025, -0.5, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {\n"
    "cube(10);\n"
    "}\n"
    "multmatrix([[0.5, -0.866025, 0, 0], [0.866025, 0.5, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {\n" +
    thirty + " {\n" + thirty + " {\ncube(10);\n} } }\n}\n";

}  // namespace

TEST_CASE("warns about faces that six-digit rounding moved apart and --snap restores them") {
  const Folder folder;
  write(folder / "nothing.csg", nothing);
  write(folder / "empty.csg", "cube(0);");
  const auto drawn = [&](const std::string& model, const std::string& more) {
    const Outcome outcome = require_success(run(
        "render " + (folder / model) + " --size 64x64 --camera 30,-40,30,0,0,0 -o " + (folder / "picture.png") + more));
    return outcome.err;
  };
  const std::string warned = drawn("nothing.csg", "");
  const std::string skin = content(folder / "picture.png");
  CHECK(warned.find("nothing.csg:3:1: warning: a face of this solid and a face of") != std::string::npos);
  CHECK(warned.find("nothing.csg:8:1 are nearly, but not exactly, coplanar") != std::string::npos);
  CHECK(warned.find("use --snap") != std::string::npos);
  const std::string snapped = drawn("nothing.csg", " --snap");
  const std::string restored = content(folder / "picture.png");
  CHECK(snapped.find("4 of 4 rotated matrices restored") != std::string::npos);
  CHECK(snapped.find("warning") == std::string::npos);
  drawn("empty.csg", "");
  CHECK(restored == content(folder / "picture.png"));
  CHECK(restored != skin);
}

TEST_CASE("warns once about a font that is not installed and names its place and substitute") {
  const Folder folder;
  const auto warnings = [&](const std::string& csg) {
    write(folder / "m.csg", csg);
    const Outcome outcome =
        require_success(run("render " + (folder / "m.csg") + " --size 16x16 --view-all -o " + (folder / "p.png")));
    return outcome.err;
  };
  const std::string warned = warnings(
      "cube(1);\n\tlinear_extrude(height = 1) { text(text = \"a\", font = \"Nowhere:style=Bold\"); }\n"
      "linear_extrude(height = 1) { text(text = \"b\", font = \"Nowhere:style=Bold\"); }\n");
  CHECK(warned.find("m.csg:2:31: warning: the font Nowhere:style=Bold of text() is not installed, and DejaVu Sans is "
                    "drawn instead") != std::string::npos);
  CHECK(is_one_line(warned));
  CHECK(warnings("linear_extrude(height = 1) { text(text = \"a\", font = \"DejaVu Sans\"); text(text = \"b\"); }")
            .empty());
  CHECK(warnings("cube(1); linear_extrude(height = 1) { text(text = \"\", font = \"Nowhere\"); }").empty());
}

TEST_CASE("warns that rotate_extrude() takes a number without a name as a file name") {
  const Folder folder;
  write(folder / "m.csg", "cube(1);\nrotate_extrude(file = \"180\", angle = 360) { square(1); }\n");
  const std::string warned =
      run("render " + (folder / "m.csg") + " --size 16x16 --view-all -o " + (folder / "p.png")).err;
  CHECK(warned.find("m.csg:2:1: warning: rotate_extrude() reads a file named 180; to rotate by an angle, name it: "
                    "rotate_extrude(angle = 180)") != std::string::npos);
}

TEST_CASE("files from the --imports-from folder are inputs of a study") {
  const Folder folder;
  fs::create_directory(folder / "models");
  fs::create_directory(folder / "parts");
  write(folder / "parts/plate.svg", "<svg><rect width=\"10\" height=\"20\"/></svg>");
  write(folder / "models/m.csg", "linear_extrude(height = 2) { import(file = \"../parts/plate.svg\"); }\n");
  check_rejected(folder / "models/m.csg", "name its folder: --imports-from FOLDER");
  const std::string words = "compile " + (folder / "models/m.csg") + " --size 16x16 -o " + (folder / "p.csgt");
  require_success(run(words + " --imports-from " + (folder / "parts")));
  CHECK(run(words + " --imports-from " + (folder / "models")).code == 1);
  fails(run(words + " --imports-from " + (folder / "part")), 1, {"part is not a folder"});
}
