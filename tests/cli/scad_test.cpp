#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

/// Draws source with a stand-in for `openscad` on the PATH that runs the shell commands.
Outcome draw_source(const std::string& commands, const std::vector<std::string>& words = {"render", "part.scad"}) {
  const Folder folder;
  stand_in(folder, "openscad", commands);
  write(folder / "part.scad", "// whatever\n");
  std::vector<std::string> all = words;
  all.insert(all.end(), {"--size", "16x16"});
  return run_beside(folder, all);
}

}  // namespace

TEST_CASE("OpenSCAD source is drawn as OpenSCAD evaluates it with its warnings") {
  const Outcome outcome =
      draw_source("echo 'WARNING: Ignoring unknown variable' >&2; echo 'ECHO: 1' >&2; echo 'cube(size = [8, 6, 4]);'");
  CHECK(outcome.code == 0);
  CHECK(outcome.out.find(", 6 half-spaces") != outcome.out.npos);
  CHECK(outcome.err == "openscad: WARNING: Ignoring unknown variable\n");
}

TEST_CASE("the first of many OpenSCAD warnings are printed and the rest counted") {
  const Outcome outcome =
      draw_source("for i in $(seq 25); do echo \"WARNING: $i\" >&2; done; echo 'cube(size = [8, 6, 4]);'");
  CHECK(outcome.code == 0);
  CHECK(outcome.err.find("WARNING: 10\n") != outcome.err.npos);
  CHECK(outcome.err.find("WARNING: 11") == outcome.err.npos);
  CHECK(outcome.err.find("openscad: 15 more warnings") != outcome.err.npos);
}

TEST_CASE("rejects OpenSCAD source that makes no shape") {
  const Outcome outcome = draw_source("echo 'ECHO: 1' >&2; echo");
  CHECK(outcome.code == 1);
  CHECK(outcome.err == "part.scad: it creates no shape, so there is nothing to draw; call a module that creates one\n");
}

TEST_CASE("every command that takes models accepts OpenSCAD source") {
  const std::string cube = "echo 'cube(size = [8, 6, 4]);'";
  CHECK(draw_source(cube, {"explain", "part.scad", "--pixel", "8,8"}).code == 0);
  CHECK(draw_source(cube, {"wave", "part.scad", "--pixel", "8,8", "-o", "part.vcd"}).code == 0);
  CHECK(draw_source(cube, {"diff", "part.scad", "part.scad"}).code == 0);
  CHECK(draw_source(cube, {"debug", "part.scad"}).code == 0);
}

TEST_CASE("a Program is recognized by its first bytes under any file name") {
  const Folder folder;
  write(folder / "model.csg", "cube(size = [8, 6, 4]);\n");
  succeeded(run_words({"compile", "model.csg", "--size", "16x16", "-o", "program.csgt"}, folder.path()));
  fs::copy_file(folder / "program.csgt", folder / "program.csg");
  succeeded(run_words({"run", "program.csg"}, folder.path()));
  fails(run_words({"render", "program.csg"}, folder.path()), 1, {"that is a Program; use csgsim run"});
}
