#include <sys/stat.h>

#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

using Words = std::vector<std::string>;

const std::string small_cube = "cube(size = [8, 6, 4]);\n";

/// Writes a model, m.csg, and its Program, p.csgt, into the folder.
void fill(const Folder& folder) {
  write(folder / "m.csg", small_cube);
  require_success(run_words({"compile", "m.csg", "--size", "16x16", "-o", "p.csgt", "-q"}, folder.path()));
}

/// Runs csgsim and terminates it after some seconds, with code 124.
Outcome run_soon(Words words, const fs::path& where) {
  words.insert(words.begin(), {"--kill-after=1", "20", std::string(CSGSIM_BINARY_DIR) + "/csgsim"});
  return run_program("timeout", words, where);
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

}  // namespace

TEST_CASE("the debugger overwrites none of its input files under any name") {
  const Folder folder;
  fill(folder);
  write(folder / "half.svg", "<svg><rect width=\"10\" height=\"20\"/></svg>");
  write(folder / "imports.csg", "linear_extrude(height = 2) { import(file = \"half.svg\"); }\n");
  write(folder / "scene.toml", "[background]\ncolour = [0, 0, 0]\n");
  fs::copy_file(folder / "p.csgt", folder / "p.png");
  fs::create_symlink("p.csgt", folder / "link");
  fs::create_hard_link(folder / "p.csgt", folder / "hard");
  fs::copy_file(std::string(CSGSIM_SOURCE_DIR) + "/hw/machines/pixel-planes-4.toml", folder / "machine.toml");
  const auto refused = [&](Words words, const std::string& command, const std::string& file) {
    CAPTURE(command);
    write(folder / "commands", "step\n" + command + "\n");
    const std::string before = content(folder / file);
    words.insert(words.begin(), "debug");
    words.insert(words.end(), {"-x", "commands"});
    const Outcome outcome = run_words(words, folder.path());
    CAPTURE(outcome.err);
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "commands:2: "));
    CHECK(contains(outcome.err, "it is the same file as"));
    CHECK(content(folder / file) == before);
  };
  refused({"p.csgt"}, "checkpoint p.csgt", "p.csgt");
  refused({"p.csgt"}, "checkpoint link", "p.csgt");
  refused({"link"}, "checkpoint p.csgt", "p.csgt");
  refused({"p.csgt"}, "checkpoint hard", "p.csgt");
  refused({"p.csgt"}, "checkpoint commands", "commands");
  refused({"p.png"}, "picture E p.png", "p.png");
  refused({"p.csgt", "--machine", "machine.toml"}, "checkpoint machine.toml", "machine.toml");
  refused({"m.csg", "--size", "16x16"}, "checkpoint m.csg", "m.csg");
  refused({"m.csg", "--size", "16x16", "--scene", "scene.toml"}, "checkpoint scene.toml", "scene.toml");
  refused({"imports.csg", "--size", "16x16"}, "checkpoint half.svg", "half.svg");
  write(folder / "settings.toml", "[debug]\nthreads = 1\n");
  refused({"p.csgt", "--config", "settings.toml"}, "checkpoint settings.toml", "settings.toml");
}

TEST_CASE("the debugger may overwrite a checkpoint and a picture that it wrote") {
  const Folder folder;
  fill(folder);
  write(folder / "commands",
        "checkpoint c\nstep\ncheckpoint c\nresume c\ncheckpoint c\npicture E e.png\npicture E e.png\n");
  require_success(run_words({"debug", "p.csgt", "-x", "commands"}, folder.path()));
}

TEST_CASE("no command overwrites a file that the model imports") {
  const Folder folder;
  write(folder / "m.csg", "linear_extrude(height = 2) { import(file = \"half.svg\"); }\n");
  fs::create_symlink("half.svg", folder / "link.json");
  const std::string drawing = "<svg><rect width=\"10\" height=\"20\"/></svg>";
  write(folder / "half.svg", drawing);
  for (const Words& words :
       {Words{"compile", "m.csg", "-o", "half.svg"}, Words{"render", "m.csg", "--stats", "half.svg"},
        Words{"explain", "m.csg", "--pixel", "8,8", "--json", "link.json"}}) {
    CAPTURE(words.back());
    Words all = words;
    all.insert(all.end(), {"--size", "16x16"});
    const Outcome outcome = run_words(all, folder.path());
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "it is the same file as"));
    CHECK(content(folder / "half.svg") == drawing);
  }
}

TEST_CASE("no command overwrites a file that is its standard input") {
  const Folder folder;
  write(folder / "m.csg", small_cube);
  const std::string program = std::string(CSGSIM_BINARY_DIR) + "/csgsim";
  const Outcome outcome =
      run_program("sh", {"-c", program + " compile - --size 16x16 -o m.csg < m.csg"}, folder.path());
  CHECK(outcome.code == 1);
  CHECK(content(folder / "m.csg") == small_cube);
}

TEST_CASE("a study follows no symbolic link and opens no pipe in its folder") {
  const Folder folder;
  write(folder / "m.csg", small_cube);
  const auto refused = [&](const std::string& name, const auto& make) {
    for (const bool is_pipe : {false, true}) {
      fs::create_directory(folder / "study");
      write(folder / "precious", "precious\n");
      const std::string place = folder / ("study/" + name);
      if (is_pipe) {
        REQUIRE(::mkfifo(place.c_str(), 0600) == 0);
      } else {
        make(folder / "precious", place);
      }
      const Outcome outcome = run_soon({"sweep", "m.csg", "--size", "16x16", "--strategy", "stack", "--no-plots",
                                        "--progress", "none", "-o", "study"},
                                       folder.path());
      CAPTURE(outcome.err);
      CHECK(outcome.code == 1);
      CHECK(is_one_line(outcome.err));
      CHECK(contains(outcome.err, name));
      CHECK(contains(outcome.err, "delete it, or choose another"));
      CHECK(content(folder / "precious") == "precious\n");
      fs::remove_all(folder / "study");
    }
  };
  const auto link = [](const std::string& to, const std::string& at) { fs::create_symlink(to, at); };
  refused(".csgsim-lock", link);
  refused(".csgsim-lock", [](const std::string& to, const std::string& at) { fs::create_hard_link(to, at); });
  refused("sweep.csv", link);
  refused("sweep.json", link);
}

TEST_CASE("rejects a shard that is a pipe or a device at once") {
  const Folder folder;
  const std::string shard = "study/shards/sweep-1-of-2.0000000000000000.csv";
  fs::create_directories(folder / "study/shards");
  const auto refused = [&] {
    const Outcome outcome = run_soon({"gather", "study"}, folder.path());
    CAPTURE(outcome.err);
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "it is a pipe or a device"));
    fs::remove(folder / shard);
  };
  REQUIRE(::mkfifo((folder / shard).c_str(), 0600) == 0);
  refused();
  fs::create_symlink("/dev/zero", folder / shard);
  refused();
}

TEST_CASE("rejects a checkpoint that is a pipe at once") {
  const Folder folder;
  fill(folder);
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  write(folder / "commands", "resume pipe\n");
  for (const Words& words : {Words{"debug", "p.csgt", "-x", "commands"}, Words{"run", "p.csgt", "--resume", "pipe"}}) {
    const Outcome outcome = run_soon(words, folder.path());
    CAPTURE(outcome.err);
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "it is a pipe or a device"));
  }
}

TEST_CASE("rejects an import that is a pipe or a device at once") {
  const Folder folder;
  for (const std::string node :
       {"import(file = \"f.stl\");", "import(file = \"f.svg\");", "surface(file = \"f.dat\");",
        "linear_extrude(file = \"f.dxf\", height = 1);", "rotate_extrude(file = \"f.dxf\");"}) {
    CAPTURE(node);
    write(folder / "m.csg", small_cube + node + "\n");
    const std::size_t begin = node.find("f.");
    const std::string file = folder / node.substr(begin, 5);
    REQUIRE(::mkfifo(file.c_str(), 0600) == 0);
    const Outcome outcome = run_soon({"render", "m.csg", "--size", "16x16"}, folder.path());
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "m.csg:2:1: "));
    CHECK(contains(outcome.err, "it is a pipe or a device"));
    fs::remove(file);
  }
}

TEST_CASE("a missing import causes a warning with its place and the rest is drawn") {
  const Folder folder;
  fs::create_symlink("nowhere.stl", folder / "dangling.stl");
  for (const std::string node :
       {"import(file = \"none.stl\");", "import(file = \"none.svg\");", "import(file = \"none.3mf\");",
        "import(file = \"dangling.stl\");", "import(file = \"none/none.off\");", "surface(file = \"none.dat\");",
        "surface(file = \"none.png\");", "linear_extrude(file = \"none.dxf\", height = 1);",
        "rotate_extrude(file = \"none.dxf\");"}) {
    CAPTURE(node);
    write(folder / "m.csg", small_cube + node + "\n");
    const Outcome outcome = require_success(run_words({"render", "m.csg", "--size", "16x16"}, folder.path()));
    CHECK(contains(outcome.out, ", 6 half-spaces"));
    CHECK(is_one_line(outcome.err));
    CHECK(outcome.err.starts_with("m.csg:2:1: warning: "));
    CHECK(contains(outcome.err, "does not exist"));
  }
}

TEST_CASE("a link in the model's folder does not import a file outside it") {
  const Folder folder;
  fs::create_directories(folder / "model/below");
  fs::create_directory(folder / "outside");
  const std::string plate = "<svg><rect width=\"10\" height=\"20\"/></svg>";
  write(folder / "outside/plate.svg", plate);
  write(folder / "model/below/plate.svg", plate);
  fs::create_symlink("../outside/plate.svg", folder / "model/out.svg");
  fs::create_symlink(folder / "outside/plate.svg", folder / "model/absolute.svg");
  fs::create_directory_symlink("../outside", folder / "model/folder");
  fs::create_symlink("below/plate.svg", folder / "model/in.svg");
  fs::create_symlink(folder / "model/below/plate.svg", folder / "model/absolute_in.svg");
  fs::create_directory_symlink("model", folder / "alias");
  const auto drawn = [&](const std::string& file, Words more = {}) {
    write(folder / "model/m.csg", "linear_extrude(height = 2) { import(file = \"" + file + "\"); }\n");
    more.insert(more.begin(), {"render", "alias/m.csg", "--size", "16x16"});
    return run_words(more, folder.path());
  };
  for (const std::string file : {"out.svg", "absolute.svg", "folder/plate.svg"}) {
    CAPTURE(file);
    const Outcome outcome = drawn(file);
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "alias/m.csg:1:30: "));
    CHECK(contains(outcome.err, "is not in the model's folder: a link leads out of it"));
    CHECK(drawn(file, {"--imports-from", "outside"}).code == 0);
  }
  for (const std::string file : {"in.svg", "absolute_in.svg", "below/plate.svg"}) CHECK(drawn(file).code == 0);
}

TEST_CASE("imports are found in the model's folder or else in the --imports-from folder") {
  const Folder folder;
  fs::create_directories(folder / "models");
  fs::create_directories(folder / "parts/below");
  write(folder / "parts/below/plate.svg", "<svg><rect width=\"10\" height=\"20\"/></svg>");
  write(folder / "models/m.csg", "linear_extrude(height = 2) { import(file = \"below/plate.svg\"); }\n");
  const auto compiled = [&](Words words) {
    words.insert(words.end(), {"--size", "16x16", "-o", folder / "p.csgt"});
    words.insert(words.begin(), "compile");
    const Outcome outcome = require_success(run_words(words, folder.path()));
    return std::pair(content(folder / "p.csgt"), outcome.err);
  };
  const auto [there, warnings] = compiled({"models/m.csg", "--imports-from", "parts"});
  CHECK(warnings.empty());
  const auto [missing, warned] = compiled({"models/m.csg"});
  CHECK(contains(warned, "below/plate.svg does not exist"));
  CHECK(missing.size() < there.size());
  // A file in the model's own folder takes precedence.
  fs::create_directory(folder / "models/below");
  write(folder / "models/below/plate.svg", "<svg><rect width=\"30\" height=\"5\"/></svg>");
  const auto [own, nothing] = compiled({"models/m.csg"});
  CHECK(compiled({"models/m.csg", "--imports-from", "parts"}).first == own);
  CHECK(own != there);
}
