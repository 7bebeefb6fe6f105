#include "hw/base/address_sanitizer.h"
#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

const std::string cube = "cube(size = [8, 6, 4], center = true);\n";

std::string machine_text() { return content(std::string(CSGSIM_SOURCE_DIR) + "/hw/machines/pixel-planes-4.toml"); }

}  // namespace

TEST_CASE("no command overwrites its own input under any name") {
  const Folder folder;
  write(folder / "m.csg", cube);
  write(folder / "mine.toml", machine_text());
  require_success(run_words({"compile", "m.csg", "--size", "16x16", "-o", "p.csgt"}, folder.path()));
  const std::string program = content(folder / "p.csgt");
  fs::create_symlink("m.csg", folder / "link.json");
  fs::create_hard_link(folder / "mine.toml", folder / "hard.json");
  fs::create_hard_link(folder / "p.csgt", folder / "hard.vcd");
  fs::create_directory(folder / "d");
  fs::create_directory(folder / "out");
  fs::create_symlink("../m.csg", folder / "out/sweep.csv");
  const std::vector<std::string> small{"--size", "16x16"};
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"compile", "m.csg", "-o", "m.csg"},
           {"compile", "m.csg", "-o", "d/../m.csg"},
           {"compile", "m.csg", "--machine", "mine.toml", "-o", "mine.toml"},
           {"render", "m.csg", "--stats", "m.csg"},
           {"render", "m.csg", "--stats", "link.json"},
           {"render", "m.csg", "--machine", "mine.toml", "--stats", "hard.json"},
           {"subdivide", "m.csg", "--subdivisions", "0", "-o", "out"},
           {"sweep", "m.csg", "--strategy", "stack", "-o", "out"},
           {"sweep", "m.csg", "--strategy", "stack", "--machines", "mine.toml", "-o", "."},
           {"disasm", "p.csgt", "-o", "p.csgt"},
           {"run", "p.csgt", "--stats", "p.csgt"},
           {"wave", "p.csgt", "--probe", "1,1", "-o", "hard.vcd"}}) {
    std::vector<std::string> all = words;
    if (words[1] == "m.csg") all.insert(all.end(), small.begin(), small.end());
    const Outcome outcome = run_words(all, folder.path());
    CAPTURE(words[0]);
    CAPTURE(words.back());
    fails(outcome, 2, {"the same file as the input"});
  }
  CHECK(content(folder / "m.csg") == cube);
  CHECK(content(folder / "mine.toml") == machine_text());
  CHECK(content(folder / "p.csgt") == program);
}

TEST_CASE("rejects two outputs that are the same file through any link") {
  const Folder folder;
  write(folder / "m.csg", cube);
  fs::create_symlink("one.exr", folder / "other.exr");
  for (const std::string second : {"one.exr", "other.exr", "./one.exr"}) {
    const Outcome outcome =
        run_words({"render", "m.csg", "--size", "16x16", "--depth", "one.exr", "--owner", second}, folder.path());
    fails(outcome, 2, {"two outputs cannot be the same file"});
  }
  CHECK_FALSE(fs::exists(folder / "one.exr"));
}

TEST_CASE("rejects an endless input at its size limit and names that limit") {
  const Folder folder;
  fs::create_symlink("/dev/zero", folder / "mine.toml");
  write(folder / "m.csg", cube);
  const Outcome machine = run_words({"render", "m.csg", "--machine", "mine.toml"}, folder.path());
  CHECK(machine.code == 1);
  CHECK(machine.err == "mine.toml: longer than 1 MiB; a machine file is much shorter\n");
#if !CSGSIM_ADDRESS_SANITIZER  // slow to fill a GiB
  for (const std::string command : {"run", "disasm", "render"}) {
    const Outcome outcome = run_words({command, "/dev/zero"}, folder.path());
    CHECK(outcome.code == 1);
    CHECK(outcome.err.starts_with("/dev/zero: longer than 1 GiB; "));
  }
#endif
}

TEST_CASE("rejects empty file names and negative counts") {
  const Folder folder;
  write(folder / "m.csg", cube);
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"render", "m.csg", "-o", ""},
                                             {"render", "m.csg", "--stats", ""},
                                             {"compile", "m.csg", "-o", ""},
                                             {"compare", "m.csg", "-o", ""},
                                             {"sweep", "m.csg", "-o", ""},
                                             {"accuracy", "m.csg", "-o", ""},
                                             {"subdivide", "m.csg", "-o", ""},
                                             {"render", "m.csg", "--max-wrong-pixels", "-1"},
                                             {"render", "m.csg", "--z-bits", "-1"},
                                             {"render", "m.csg", "--fraction-bits", "-1"},
                                             {"render", "m.csg", "--memory-bits", "-1"},
                                             {"render", "m.csg", "--threads", "-1"}}) {
    const Outcome outcome = run_words(words, folder.path());
    CAPTURE(words[2]);
    CAPTURE(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(is_one_line(outcome.err));
  }
  CHECK(folder.files() == 1);
}

TEST_CASE("rejects a near plane that leaves no depths and suggests a valid one") {
  const Folder folder;
  write(folder / "m.csg", cube);
  for (const std::string near : {"4.9e-324", "1e-300", "1e-17"}) {
    const Outcome outcome =
        run_words({"render", "m.csg", "--size", "16x16", "--projection", "perspective", "--near", near}, folder.path());
    fails(outcome, 1, {"set --near to "});
    CHECK((outcome.out + outcome.err).find("nan") == std::string::npos);
  }
  require_success(run_words({"render", "m.csg", "--size", "16x16", "--projection", "perspective", "--near", "1e-9"},
                            folder.path()));
}

TEST_CASE("every command that reads a model rejects one that exceeds --limit with its place") {
  const Folder folder;
  write(
      folder / "twisted.csg",
      cube +
          "linear_extrude(height = 24, center = false, convexity = 1, twist = 90, slices = 500, scale = [0.5, 0.4]) {\n"
          "  square(size = [12, 5], center = true);\n}\n");
  for (std::vector<std::string> words : std::vector<std::vector<std::string>>{
           {"compile", "twisted.csg", "-o", "t.csgt", "--size", "16x16"},
           {"render", "twisted.csg", "--size", "16x16"},
           {"explain", "twisted.csg", "--pixel", "8,8", "--size", "16x16"},
           {"subdivide", "twisted.csg", "--subdivisions", "0", "--size", "16x16"},
           {"sweep", "twisted.csg", "--strategy", "stack", "-o", "out", "--size", "16x16"}}) {
    CAPTURE(words[0]);
    words.insert(words.end(), {"--limit", "1"});
    fails(run_words(words, folder.path()), 1,
          {"twisted.csg:2:1: linear_extrude(): ", "more work than the limit of 1 million steps", "--limit"});
  }
  require_success(run_words({"compile", "twisted.csg", "-o", "t.csgt", "--size", "16x16"}, folder.path()));
  CHECK(run_words({"compile", "twisted.csg", "-o", "t.csgt", "--limit", "0"}, folder.path()).code == 2);
}

TEST_CASE("rejects a tree with exponentially many products before it fills memory") {
  const Folder folder;
  std::string text;
  for (int i = 0; i < 8'000; ++i) text += "difference() { cube(size = [9, 9, 9], center = true);\n";
  text += "cube(size = [1, 1, 1], center = true);" + std::string(8'000, '}') + "\n";
  write(folder / "deep.csg", text);
  fails(run_words({"compile", "deep.csg", "-o", "d.csgt", "--size", "16x16"}, folder.path()), 1,
        {"from this primitive on, comparing primitives with others needs more work than", "deep.csg:"});
}

TEST_CASE("--limit limits the work of compiling in every command") {
  const Folder folder;
  std::string text;
  for (int i = 0; i < 100; ++i) {
    text += fmt::format(
        "multmatrix([[1, 0, 0, {}], [0, 1, 0, {}], [0, 0, 1, {}], [0, 0, 0, 1]]) {{ sphere($fn = 20, r = 3); }}\n",
        i % 10 * 7, i / 10 * 7, i % 3);
  }
  write(folder / "balls.csg", text);
  const auto compiled = [&](const std::string& limit, const std::string& shadows) {
    return run_words({"compile", "balls.csg", "-o", "b.csgt", "--view-all", "--size", "64x64", "--memory-bits", "256",
                      "--limit", limit, "--set", "effects.shadows.on=" + shadows},
                     folder.path());
  };
  fails(compiled("1", "false"), 1,
        {"balls.csg:", "broadcasting the model needs more work than the limit of 1 million steps"});
  fails(compiled("100", "true"), 1, {"balls.csg:", "finding where shadows fall needs more work than the limit"});
  CHECK_FALSE(std::filesystem::exists(folder / "b.csgt"));
  CHECK(compiled("100", "false").code == 0);
}
