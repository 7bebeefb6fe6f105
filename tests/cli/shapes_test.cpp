#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

const std::string thirty = "multmatrix([[0.866025, -0.5, 0, 0], [0.5, 0.866025, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])";

/// A cube, turned by 120 degrees at once, without the same cube, turned by 60, 30 and 30.
const std::string nothing =
    "difference() {\n"
    "multmatrix([[-0.5, -0.866025, 0, 0], [0.866025, -0.5, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {\n"
    "cube(10);\n"
    "}\n"
    "multmatrix([[0.5, -0.866025, 0, 0], [0.866025, 0.5, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {\n" +
    thirty + " {\n" + thirty + " {\ncube(10);\n} } }\n}\n";

}  // namespace

TEST_CASE("faces that six digits have moved apart are warned of, and brought together with --snap") {
  const Folder folder;
  write(folder / "nothing.csg", nothing);
  write(folder / "empty.csg", "cube(0);");
  const auto drawn = [&](const std::string& model, const std::string& more) {
    const Outcome outcome = run("render " + (folder / model) + " --size 64x64 --camera 30,-40,30,0,0,0 -o " +
                                (folder / "picture.png") + more);
    CHECK(outcome.code == 0);
    return outcome.err;
  };
  const std::string told = drawn("nothing.csg", "");
  const std::string skin = content(folder / "picture.png");
  CHECK(told.find("nothing.csg:3:1: warning: a face of it and one of") != std::string::npos);
  CHECK(told.find("nothing.csg:8:1 are nearly in one plane") != std::string::npos);
  CHECK(told.find("use --snap") != std::string::npos);
  const std::string snapped = drawn("nothing.csg", " --snap");
  const std::string restored = content(folder / "picture.png");
  CHECK(snapped.find("4 of 4 rotated matrices restored") != std::string::npos);
  CHECK(snapped.find("warning") == std::string::npos);
  drawn("empty.csg", "");
  CHECK(restored == content(folder / "picture.png"));
  CHECK(restored != skin);
}

TEST_CASE("files of another folder are imported from the folder that is named, and are part of the model") {
  const Folder folder;
  fs::create_directory(folder / "models");
  fs::create_directory(folder / "parts");
  write(folder / "parts/plate.svg", "<svg><rect width=\"10\" height=\"20\"/></svg>");
  write(folder / "models/m.csg", "linear_extrude(height = 2) { import(file = \"../parts/plate.svg\"); }\n");
  refuses(folder / "models/m.csg", "name a folder that both are in: --imports-from FOLDER");
  const std::string words = "compile " + (folder / "models/m.csg") + " --size 16x16 -o " + (folder / "p.csgt");
  CHECK(run(words + " --imports-from " + (folder / "parts")).code == 0);
  CHECK(run(words + " --imports-from " + (folder / "models")).code == 1);
}
