#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Checks that the command ends with that code and one line of error with this text.
void refused(const Outcome& outcome, int code, const std::string& what) {
  CAPTURE(outcome.err);
  CHECK(outcome.code == code);
  CHECK(is_one_line(outcome.err));
  CHECK(holds(outcome.err, what));
}

std::string lines_with(const std::string& text, const std::string& part) {
  std::istringstream lines(text);
  std::string found;
  for (std::string line; std::getline(lines, line);)
    if (holds(line, part)) found += line + "\n";
  return found;
}

}  // namespace

TEST_CASE("bench-suite lists its 20 cases") {
  const Outcome outcome = run("bench-suite --list");
  CHECK(outcome.code == 0);
  CHECK(holds(outcome.out, "suite 1: 20 cases"));
  CHECK(holds(outcome.out, "carburettor         stand-in  128x128"));
  CHECK(std::ranges::count(outcome.out, '\n') == 22);
  CHECK(std::ranges::count(run("bench-suite grid --list").out, '\n') == 3);
}

TEST_CASE("bench-suite runs a case with a shared Program and with a machine's own") {
  const Folder folder;
  const std::string table = folder / "r.csv";
  const Outcome outcome =
      run("bench-suite coplanar_faces --machines pixel-planes-4,simdram-ddr4,pixel-square "
          "--results " +
          table);
  CAPTURE(outcome.out + outcome.err);
  CHECK(outcome.code == 0);
  CHECK(holds(outcome.out, "suite 1: 3 runs of cases"));
  CHECK(holds(outcome.out, "none differs"));
  CHECK(holds(content(table), "case,machine,simulator,level,seconds,picture,program,memory_bits,clocks"));
  const Outcome compared = run("bench-suite --compare " + table);
  CHECK(compared.code == 0);
  CHECK(holds(compared.out, "suite 1: 3 runs of cases"));
}

TEST_CASE("bench-suite at the cycle level clocks several machines, each in its own process") {
  const Outcome outcome = run("bench-suite edge_on_faces --machines pixel-planes-4,pixel-square --level cycle");
  CAPTURE(outcome.out + outcome.err);
  CHECK(outcome.code == 0);
  CHECK(holds(outcome.out, "suite 1: 2 runs of cases"));
}

TEST_CASE("bench-suite compares a machine of the user with others that run the same Program") {
  const Outcome outcome = run("bench-suite coplanar_faces --machines pixel-planes-4+alu.bits=4");
  CAPTURE(outcome.out + outcome.err);
  CHECK(outcome.code == 0);
  CHECK(holds(lines_with(outcome.out, "alu.bits=4"), "values equal"));
}

TEST_CASE("bench-suite reports each value of another simulator that differs and ends with 1") {
  const Folder folder;
  write(folder / "theirs.csv",
        "case,machine,clocks,memory_bits\ncoplanar_faces,pixel-planes-4,1,\nedge_on_faces,pixel-planes-4,,2\n");
  const Outcome outcome = run("bench-suite --compare " + (folder / "theirs.csv"));
  refused(outcome, 1, "suite 1: 2 runs of cases: differing values: 2 of 2, in 2 runs");
  CHECK(holds(outcome.out, "    clocks: expected "));
  CHECK(holds(outcome.out, ", found 1\n"));
  CHECK(holds(outcome.out, "    memory_bits: expected "));
  const Outcome one = run("bench-suite coplanar_faces --compare " + (folder / "theirs.csv"));
  refused(one, 1, "suite 1: 1 run of cases: differing values: 1 of 1, in 1 run");
}

TEST_CASE("bench-suite writes its files for another simulator, and runs them from there") {
  const Folder folder;
  const std::string out = folder / "suite";
  CHECK(run("bench-suite edge_on_faces -o " + out + " --machines pixel-planes-4,simdram-ddr4,scan-line").code == 0);
  for (const char* const name :
       {"suite.toml", "expected.csv", "programs/edge_on_faces.txt", "programs/edge_on_faces.scan-line.txt",
        "pictures/edge_on_faces.png", "models/edge_on_faces.csg"}) {
    CAPTURE(name);
    CHECK(!content(out + "/" + name).empty());
  }
  CHECK(!fs::exists(out + "/programs/edge_on_faces.simdram-ddr4.txt"));
  CHECK(run("bench-suite edge_on_faces --machines pixel-planes-4,scan-line --suite " + out).code == 0);
  CHECK(run("run " + out + "/programs/edge_on_faces.txt --machine pixel-planes-4 -o " + (folder / "p.png")).code == 0);
}

TEST_CASE("bench-suite rejects unknown names, tables and folders") {
  const Folder folder;
  refused(run("bench-suite carburetor"), 1, "there is no case 'carburetor'; did you mean carburettor?");
  refused(run("bench-suite --machines pixel-plane-4"), 2, "did you mean pixel-planes-4?");
  refused(run("bench-suite --list -o x"), 2, "give only one of --list, --output, --compare and --results");
  refused(run("bench-suite --suite " + folder.path().string()), 1, "suite.toml");
  write(folder / "bad.csv", "case,machine,clocks\ngrid,pixel-planes-4,many\n");
  refused(run("bench-suite --compare " + (folder / "bad.csv")), 1,
          "bad.csv:2:21: clocks: 'many' is not a whole number");
  write(folder / "bad.csv", "case,machine\ngird,pixel-planes-4\n");
  refused(run("bench-suite --compare " + (folder / "bad.csv")), 1, "there is no case 'gird'; did you mean grid?");
}
