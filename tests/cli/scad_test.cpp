#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

/// Draws source with a stand-in for `openscad` on the PATH that runs the shell commands.
Outcome draw_source(const std::string& commands, const std::vector<std::string>& words = {"render", "part.scad"}) {
  const Folder folder;
  write_stand_in(folder, "openscad", commands);
  write(folder / "part.scad", "// whatever\n");
  std::vector<std::string> all = words;
  all.insert(all.end(), {"--size", "16x16"});
  return run_with_stand_ins(folder, all);
}

}  // namespace

TEST_CASE("OpenSCAD source is drawn as OpenSCAD evaluates it with its warnings") {
  const Outcome outcome =
      draw_source("echo 'WARNING: Ignoring unknown variable' >&2; echo 'ECHO: 1' >&2; echo 'cube(size = [8, 6, 4]);'");
  CHECK(outcome.code == 0);
  CHECK(outcome.out.find(", 6 half-spaces") != outcome.out.npos);
  CHECK(outcome.err == "openscad: WARNING: Ignoring unknown variable\nopenscad: ECHO: 1\n");
}

TEST_CASE("lines of echo() are printed in OpenSCAD's order") {
  const Outcome outcome = draw_source(
      "printf 'Could not initialize localization.\nECHO: 1\nWARNING: x\nECHO: \"a\nb\"\nTRACE: y\nnoise\n' >&2; "
      "echo 'cube(size = [8, 6, 4]);'");
  CHECK(outcome.code == 0);
  CHECK(outcome.err ==
        "openscad: ECHO: 1\nopenscad: WARNING: x\nopenscad: ECHO: \"a\nopenscad: b\"\nopenscad: TRACE: y\n");
}

TEST_CASE("a failed assert() of OpenSCAD is an error at its line, after the trace") {
  const std::string said =
      "printf 'ECHO: 7\nERROR: Assertion (x < 3) failed: \"too big\" in file %s, line 3\nTRACE: called by m in file "
      "part.scad, line 4\n' ";
  const Outcome outcome = draw_source(said + "part.scad >&2; echo");
  CHECK(outcome.code == 1);
  CHECK(outcome.err ==
        "openscad: ECHO: 7\nopenscad: TRACE: called by m in file part.scad, line 4\n"
        "part.scad:3: Assertion (x < 3) failed: \"too big\"\n");
  CHECK(outcome.out == "");
  // OpenSCAD names an included file relative to the source.
  const Outcome included = draw_source(said + "lib/parts.scad >&2; echo");
  CHECK(included.err.ends_with("\nlib/parts.scad:3: Assertion (x < 3) failed: \"too big\"\n"));
}

TEST_CASE("the first of several OpenSCAD errors is reported last and with its place") {
  const std::string two = "printf 'ERROR: one%s\nERROR: two\n' ";
  CHECK(draw_source(two + "' in file part.scad, line 12' >&2; exit 1").err ==
        "openscad: ERROR: two\npart.scad:12: one\n");
  CHECK(draw_source(two + "'' >&2; echo 'cube(size = [8, 6, 4]);'").err == "openscad: ERROR: two\npart.scad: one\n");
  CHECK(draw_source("echo 'ERROR: one in file \"\", line 2: why' >&2; exit 1").err == "part.scad:2: one: why\n");
  CHECK(draw_source("echo 'ERROR: one in file part.scad, line x' >&2; exit 1").err ==
        "part.scad: one in file part.scad, line x\n");
  CHECK(draw_source("printf 'ERROR: \"a\nb\" in file part.scad, line 2\n' >&2; exit 1").err ==
        "part.scad:2: \"a\\nb\"\n");
  const std::string unread = "echo 'ERROR: Parser error: syntax error in file part.scad, line 2' >&2; exit 1";
  CHECK(draw_source(unread, {"render", "part.scad", "-D", "x=("}).err ==
        "part.scad:2: Parser error: syntax error; check the values of -D\n");
}

TEST_CASE("every command that reads a model passes variables on to OpenSCAD") {
  const Folder folder;
  write_stand_in(folder, "openscad",
                 "for word; do echo \"WARNING: <$word>\" >&2; done; echo 'cube(size = [8, 6, 4]);'");
  write(folder / "part.scad", "// whatever\n");
  write(folder / "sets.json", R"({"parameterSets": {"small": {"x": "1"}, "-very big": {}}})");
  const std::string end = "openscad: WARNING: <part.scad>\n";
  const std::string begin =
      "openscad: WARNING: <-o>\nopenscad: WARNING: <->\nopenscad: WARNING: <--export-format>\n"
      "openscad: WARNING: <csg>\n";
  const std::string given =
      "openscad: WARNING: <-D>\nopenscad: WARNING: <text=\"a b\">\nopenscad: WARNING: <-D>\n"
      "openscad: WARNING: <$fn=9>\n";
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"render", "--size", "16x16"},
                                             {"convert", "-o", "part.stl"},
                                             {"explain", "--size", "16x16", "--pixel", "8,8"},
                                             {"levels", "--size", "16x16", "--levels", "functional"},
                                             {"compare", "--size", "16x16", "--machines", "pixel-planes-4", "--sides",
                                              "none", "--fragments", "none", "--no-plots"}}) {
    CAPTURE(command[0]);
    std::vector<std::string> words = command;
    words.insert(words.begin() + 1, {"-D", "text=\"a b\"", "-D$fn=9", "part.scad"});
    CHECK(require_success(run_with_stand_ins(folder, words)).err == begin + given + end);
  }
  const Outcome sets = require_success(
      run_with_stand_ins(folder, {"render", "part.scad", "-p", "sets.json", "-P", "-very big", "--size", "16x16"}));
  CHECK(sets.err == begin + "openscad: WARNING: <-p>\nopenscad: WARNING: <" +
                        fs::absolute(folder / "sets.json").string() + ">\nopenscad: WARNING: <-P-very big>\n" + end);
}

TEST_CASE("variables and parameter sets that cannot be passed on are rejected") {
  const Folder folder;
  write_stand_in(folder, "openscad", "echo 'cube(size = [8, 6, 4]);'");
  write(folder / "part.scad", "// whatever\n");
  write(folder / "part.csg", "cube(size = [8, 6, 4]);\n");
  write(folder / "sets.json", R"({"parameterSets": {"small": {"x": "1"}, "big": {}}})");
  write(folder / "empty.json", R"({"parameterSets": {}})");
  write(folder / "other.json", "[1, 2]");
  write(folder / "bad.json", "{");
  const auto drawn = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "render");
    words.insert(words.end(), {"--size", "16x16"});
    return run_with_stand_ins(folder, words);
  };
  fails(drawn({"part.csg", "-D", "n=3"}), 2, {"--define: part.csg has no variables to set, only a .scad source has"});
  fails(drawn({"part.csg", "-p", "sets.json", "-P", "small"}), 2, {"--parameters: part.csg has no variables"});
  for (const char* const word : {"n", "=3", "n=", "a b=3", "cube(3);x=1"})
    fails(drawn({"part.scad", "-D", word}), 2, {"--define: '", "must be NAME=VALUE, as in width=20"});
  fails(drawn({"part.scad", "-p", "sets.json"}), 2, {"--parameters: name one of the file's sets, with -P SET"});
  fails(drawn({"part.scad", "-P", "small"}), 2, {"--parameter-set: name the file that has the set, with -p FILE"});
  fails(drawn({"part.scad", "-p", "sets.json", "-P", "smal"}), 1,
        {"sets.json: there is no parameter set 'smal'; did you mean small? The parameter sets are small, big"});
  fails(drawn({"part.scad", "-p", "empty.json", "-P", "a"}), 1,
        {"empty.json: it has no parameter set; name a file of"});
  fails(drawn({"part.scad", "-p", "other.json", "-P", "a"}), 1, {"other.json: it has no 'parameterSets'"});
  fails(drawn({"part.scad", "-p", "bad.json", "-P", "a"}), 1, {"bad.json: not valid JSON"});
  fails(drawn({"part.scad", "-p", "missing.json", "-P", "a"}), 1, {"missing.json"});
}

TEST_CASE("stats record variables and rerun repeats them") {
  const Folder folder;
  write_stand_in(folder, "openscad",
                 "for word; do case $word in n=*) n=${word#n=};; esac; done; echo \"cube(size = $n);\"");
  write(folder / "part.scad", "// whatever\n");
  require_success(
      run_with_stand_ins(folder, {"render", "-D", "n=7", "part.scad", "--size", "16x16", "--stats", "s.json"}));
  CHECK(json(folder / "s.json")["configuration"]["options"]["define"] == nlohmann::json::array({"n=7"}));
  CHECK(require_success(run_with_stand_ins(folder, {"rerun", "s.json"})).out.find("rerun ") != std::string::npos);
}

TEST_CASE("a missing OpenSCAD is reported with how to install it") {
  const Folder folder;
  write(folder / "part.scad", "cube(1);\n");
  const Outcome outcome = run_program(
      "env", {"PATH=" + folder.path().string(), std::string(CSGSIM_BINARY_DIR) + "/csgsim", "render", "part.scad"},
      folder.path());
  fails(outcome, 1, {"part.scad: a .scad source needs OpenSCAD", "sudo apt install openscad", "openscad.org"});
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
  CHECK(outcome.err ==
        "openscad: ECHO: 1\n"
        "part.scad: it creates no shape, so there is nothing to draw; call a module that creates one\n");
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
  require_success(run_words({"compile", "model.csg", "--size", "16x16", "-o", "program.csgt"}, folder.path()));
  fs::copy_file(folder / "program.csgt", folder / "program.csg");
  require_success(run_words({"run", "program.csg"}, folder.path()));
  fails(run_words({"render", "program.csg"}, folder.path()), 1, {"that is a Program; use csgsim run"});
}
