#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

std::string binary() { return std::string(CSGSIM_BINARY_DIR) + "/csgsim"; }

/// Runs a bash command and returns its output and errors.
Outcome shell(const std::string& command) { return run_program("/bin/bash", {"-c", command}); }

/// The output of csgsim on a pseudo-terminal, and its exit code.
Outcome on_terminal(const std::string& words) {
  int terminal = -1;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
  REQUIRE(child >= 0);
  if (child == 0) {
    ::execl("/bin/sh", "sh", "-c", (binary() + " " + words).c_str(), static_cast<char*>(nullptr));
    std::_Exit(127);
  }
  Outcome outcome;
  std::array<char, 4096> bytes{};
  for (ssize_t count = 0; (count = ::read(terminal, bytes.data(), bytes.size())) > 0;)
    outcome.out.append(bytes.data(), static_cast<std::size_t>(count));
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(terminal);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

const std::string draw = " --size 40x30 ";

}  // namespace

TEST_CASE("an input named - is a model or a Program on standard input") {
  const Folder folder;
  const std::string part = model("old_example003");
  require_success(run("render " + part + draw + "-o " + (folder / "p.png")));
  CHECK(shell(binary() + " render -" + draw + "-o " + (folder / "q.png") + " <" + part).code == 0);
  CHECK(content(folder / "q.png") == content(folder / "p.png"));
  // --max-wrong-pixels reads the model twice, the first time to choose settings.
  CHECK(shell("cat " + part + " | " + binary() + " render -" + draw + "--max-wrong-pixels 900").code == 0);

  require_success(run("compile " + part + draw + "-o " + (folder / "p.csgt")));
  CHECK(shell(binary() + " run - -o " + (folder / "r.png") + " <" + (folder / "p.csgt")).code == 0);
  CHECK(content(folder / "r.png") == content(folder / "p.png"));
  const Outcome text = shell(binary() + " disasm - <" + (folder / "p.csgt"));
  CHECK(text.out == run("disasm " + (folder / "p.csgt")).out);
  CHECK(
      shell(binary() + " disasm " + (folder / "p.csgt") + " | " + binary() + " run - -o " + (folder / "t.png")).code ==
      0);
  CHECK(content(folder / "t.png") == content(folder / "p.png"));

  CHECK(shell(binary() + " explain - --pixel 20,15 <" + (folder / "p.csgt")).out.find("pixel") != std::string::npos);
  CHECK(shell(binary() + " explain -" + draw + "--pixel 20,15 <" + part).out.find("pixel") != std::string::npos);
  CHECK(shell(binary() + " render - <" + (folder / "p.csgt")).err.find("that is a Program") != std::string::npos);
  CHECK(shell(binary() + " debug - <" + part).code == 2);
}

TEST_CASE("a model on standard input imports files from the current folder") {
  const Folder folder;
  write(folder / "t.stl", "solid t\nendsolid t\n");
  const auto in_folder = [&](const std::string& csg, const std::string& below = ".") {
    return shell("cd " + folder.path().string() + " && mkdir -p below && cd " + below + " && echo '" + csg + "' | " +
                 binary() + " render -" + draw);
  };
  CHECK(in_folder("import(file = \"t.stl\");").err.find("cannot be read") == std::string::npos);
  CHECK(in_folder("import(file = \"none.stl\");").err.starts_with("standard input:1:1: warning: "));
  CHECK(in_folder("import(file = \"../none.stl\");").err.starts_with("standard input:1:1: warning: "));
  CHECK(in_folder("import(file = \"../t.stl\");", "below")
            .err.starts_with("standard input:1:1: ../t.stl is not in the model's"));
  CHECK(in_folder("cub(1);").err.starts_with("standard input:1:1: unknown node cub()"));
}

TEST_CASE("an output named - is standard output and the summary goes to standard error") {
  const Folder folder;
  const std::string part = model("old_example003");
  require_success(run("render " + part + draw + "-o " + (folder / "p.png") + " --depth " + (folder / "z.exr") +
                      " --owner " + (folder / "o.png")));
  for (const std::string name : {"-", "/dev/stdout", "/dev/fd/1"}) {
    CAPTURE(name);
    const Outcome picture = require_success(run("render " + part + draw + "-o " + name));
    CHECK(picture.out == content(folder / "p.png"));
    CHECK(picture.err.find("7 primitives") != std::string::npos);
  }
  CHECK(run("render " + part + draw + "-q -o -").err == "");
  CHECK(run("render " + part + draw + "-q -o -").out == content(folder / "p.png"));
  CHECK(run("render " + part + draw + "--depth -").out == content(folder / "z.exr"));
  CHECK(run("render " + part + draw + "--owner -").out == content(folder / "o.png"));
  CHECK(nlohmann::json::parse(run("render " + part + draw + "--stats -").out)["model"]["primitives"] == 7);
  CHECK(run("render " + part + draw + "-o - --tolerance 0.5px").out.substr(1, 3) == "PNG");
  CHECK(shell(binary() + " compile " + part + draw + "-o - | " + binary() + " run - -o -").out ==
        content(folder / "p.png"));
  CHECK(run("disasm " + std::string(CSGSIM_SOURCE_DIR) + "/traces/thesis_fig_2_3.csgt -o -").out ==
        run("disasm " + std::string(CSGSIM_SOURCE_DIR) + "/traces/thesis_fig_2_3.csgt").out);
  CHECK(nlohmann::json::parse(run("explain " + part + draw + "--pixel 20,15 --json -").out).is_object());
  CHECK(run("wave " + part + draw + "--pixel 1,1 --window 0:9 -o -").out.find("$enddefinitions") != std::string::npos);
  CHECK_FALSE(fs::exists("-"));
}

TEST_CASE("rejects standard output for several outputs or for a folder") {
  const std::string part = model("old_example003");
  check_misuse("render " + part + draw + "-o - --stats -", "two outputs cannot both go to standard output");
  check_misuse("render " + part + draw + "-o - --stats /dev/stdout", "two outputs cannot both go to standard output");
  check_misuse("render " + part + draw + "-o - --frames 2", "several pictures");
  check_misuse("sweep " + part + draw + "-o -", "several files; specify a folder");
  check_misuse("run " + std::string(CSGSIM_SOURCE_DIR) + "/traces/thesis_fig_2_3.csgt --checkpoint -", "name a file");
}

TEST_CASE("outputs may be pipes and process substitutions in the format of their name") {
  const Folder folder;
  const std::string render = binary() + " render " + model("old_example003") + draw;
  REQUIRE(shell(render + "-o " + (folder / "p.png") + " -o " + (folder / "p.png") + " 2>&1").code != 0);
  REQUIRE(shell(render + "-o " + (folder / "p.png") + " --stats " + (folder / "s.json")).code == 0);
  CHECK(shell("set -o pipefail; " + render + "-o >(cat >" + (folder / "q.png") + "); sleep 0.3").code == 0);
  CHECK(content(folder / "q.png") == content(folder / "p.png"));
  for (const std::string name : {"fifo", "fifo.ppm"}) {
    const std::string pipe = folder / name;
    CHECK(shell("mkfifo " + pipe + "; cat " + pipe + " >" + (folder / "r") + " & " + render + "-o " + pipe + "; wait")
              .code == 0);
    CHECK(content(folder / "r").substr(0, 2) == (name == "fifo" ? "\x89P" : "P6"));
  }
}

TEST_CASE("text is written to a terminal but binary data is rejected") {
  const std::string part = model("old_example003");
  for (const std::string& words :
       std::vector<std::string>{"render " + part + draw + "-o -", "render " + part + draw + "--depth /dev/tty",
                                "render " + part + draw + "--owner /dev/stdout", "compile " + part + draw + "-o -"}) {
    CAPTURE(words);
    const Outcome outcome = on_terminal(words);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.find("a terminal cannot show binary data; name a file, or pipe the output to a program") !=
          std::string::npos);
    CHECK(outcome.out.find("primitives") == std::string::npos);  // rejected before drawing
    CHECK(outcome.out.find("IHDR") == std::string::npos);
  }
  const Outcome stats = require_success(on_terminal("render " + part + draw + "-q --stats -"));
  CHECK(stats.out.find("\"by_purpose\"") != std::string::npos);
}
