#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

using Words = std::vector<std::string>;

/// Runs csgsim rtl in a folder with a model, m.csg, and a Program that shows no picture, p.txt.
Outcome rtl(const Folder& folder, Words words) {
  write(folder / "m.csg", "cube(size = [8, 6, 4]);\n");
  write(folder / "p.txt",
        "# csgsim program\n.array width=8 height=8 memory_bits=72\n.machine name=\"pixel-planes-4\"\n"
        ".field mask [64] mask\n.segment x=0 y=0 width=8 height=8\n  enable_all\n");
  words.insert(words.begin(), "rtl");
  return run_words(words, folder.path());
}

void refused(const Words& words, int code, const std::string& what, const std::string& fix) {
  const Folder folder;
  const Outcome outcome = rtl(folder, words);
  CAPTURE(outcome.err);
  CHECK(outcome.code == code);
  CHECK(is_one_line(outcome.err));
  CHECK(outcome.err.find(what) != std::string::npos);
  CHECK(outcome.err.find(fix) != std::string::npos);
  CHECK(outcome.out.empty());
  CHECK(folder.files() == 2);
}

std::set<std::string> files_below(const fs::path& folder) {
  std::set<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.insert(fs::relative(entry.path(), folder).native());
  }
  return files;
}

/// Adds the modules of hw/rtl to the files written for a design.
std::set<std::string> with_modules(std::set<std::string> files) {
  for (const fs::directory_entry& entry : fs::directory_iterator(std::string(CSGSIM_SOURCE_DIR) + "/hw/rtl")) {
    if (entry.is_regular_file() && entry.path().extension() != ".md")
      files.insert("rtl/" + entry.path().filename().native());
  }
  return files;
}

void check_filled(const fs::path& folder) {
  for (const std::string& file : files_below(folder)) {
    CAPTURE(file);
    const std::string text = content((folder / file).native());
    CHECK(!text.empty());
    if (!file.starts_with("rtl/")) CHECK(text.find("@MACHINE@") == std::string::npos);
  }
}

}  // namespace

TEST_CASE("rtl writes a complete design with a Program and can overwrite it") {
  const Folder folder;
  for (int i = 0; i < 2; ++i) {
    const Outcome outcome = require_success(rtl(folder, {"pixel-planes-4", "m.csg", "--size", "8x4", "-o", "d"}));
    CHECK(outcome.err.empty());
    CHECK(outcome.out.find("pixel-planes-4, 8 x 4 pixels with a Program; make -C d icarus") != std::string::npos);
  }
  CHECK(files_below(folder.path() / "d") ==
        with_modules({".csgsim-files", "Makefile", "README.md", "begins.hex", "beside.py", "board.v", "hx8k.pcf",
                      "png.py", "program.hex", "system.v", "testbench.v", "up5k.pcf"}));
  check_filled(folder.path() / "d");
  const std::string system = content(folder / "d/system.v");
  CHECK(system.find(".WIDTH(8), ") != std::string::npos);
  CHECK(system.find(".HEIGHT(4), ") != std::string::npos);
}

TEST_CASE("rtl without a model writes a design with a serial line and no testbench") {
  const Folder folder;
  require_success(rtl(folder, {"pixel-planes-4", "--size", "8x4", "--set", "alu.bits=2", "-o", "d"}));
  CHECK(files_below(folder.path() / "d") ==
        with_modules({".csgsim-files", "Makefile", "README.md", "board.v", "hx8k.pcf", "system.v", "up5k.pcf"}));
  check_filled(folder.path() / "d");
  const std::string system = content(folder / "d/system.v");
  CHECK(system.find("uart_host") != std::string::npos);
  CHECK(system.find(".ALU_BITS(2), ") != std::string::npos);
}

TEST_CASE("rtl writes no design over foreign files or into the current folder") {
  refused({"pixel-planes-4", "m.csg", "--size", "8x8", "-o", "."}, 1, ".: it contains the current folder",
          "name an empty folder or a new one");
  const Folder folder;
  fs::create_directory(folder.path() / "d");
  write(folder / "d/board.v", "mine\n");
  const Words words{"pixel-planes-4", "m.csg", "--size", "8x4", "-o", "d"};
  fails(rtl(folder, words), 1, {"d: it contains files that csgsim did not write"});
  CHECK(files_below(folder.path() / "d") == std::set<std::string>{"board.v"});
  CHECK(content(folder / "d/board.v") == "mine\n");
}

TEST_CASE("rtl rejects a machine that the Verilog does not support and suggests a fix") {
  const Words model{"m.csg", "--size", "8x8", "-o", "d"};
  const auto with = [&](Words words, const Words& more) {
    words.insert(words.end(), model.begin(), model.end());
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  refused(with({"scan-line"}, {}), 1, "scan-line, which has no Verilog", "use a machine of the kind frame-buffer");
  refused(with({"pixel-planes-4"}, {"--set", "alu.bits=2", "--set", "evaluator.bits=2"}), 1, "evaluator.bits is 2",
          "add --set evaluator.bits=1");
  refused(with({"pixel-planes-4"}, {"--set", "evaluator.register_levels=2"}), 1, "evaluator.register_levels is 2",
          "add --set evaluator.register_levels=1");
  refused({"pixel-planes-4", "p.txt", "-o", "d"}, 1, "the Program has no colours",
          "compile a model that draws a picture");
  refused({"pixel-planes-4", "m.csg", "--size", "8x8", "-o", "-"}, 2, "a design is several files", "name a folder");
}

TEST_CASE("rtl rejects compile options if it compiles no model") {
  const std::string name_one = "is for models; name one after the machine";
  refused({"pixel-planes-4", "--size", "8x8", "--colour-bits", "12", "-o", "d"}, 2, "--colour-bits", name_one);
  refused({"pixel-planes-4", "--set", "background.colour=0,0,0", "-o", "d"}, 2, "'background.colour=0,0,0'", name_one);
  refused({"pixel-planes-4", "p.txt", "--colour-bits", "12", "-o", "d"}, 2, "--colour-bits",
          "a Program has been compiled already");
}
