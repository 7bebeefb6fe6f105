#include <cctype>

#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

const std::string cube = "cube(size = [8, 6, 4], center = true);\n";

/// The arguments of a study of one or two points with plots.
std::vector<std::string> study(const std::string& command, const std::string& model, const std::string& folder) {
  std::vector<std::string> words{command, model, "--size", "16x16"};
  if (!folder.empty()) words.insert(words.end(), {"-o", folder});
  if (command == "compare")
    words.insert(words.end(), {"--machines", "pixel-planes-4", "--sides", "8", "--fragments", "4"});
  if (command == "sweep") words.insert(words.end(), {"--strategy", "stack,list"});
  if (command == "accuracy") words.insert(words.end(), {"--views", "1"});
  return words;
}

bool is_plain_line(const std::string& text) {
  return is_one_line(text) && std::none_of(text.begin(), text.end() - 1,
                                           [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; });
}

bool is_there(const fs::path& folder, const std::string& name) {
  return std::any_of(fs::recursive_directory_iterator(folder), fs::recursive_directory_iterator(),
                     [&](const fs::directory_entry& entry) { return entry.path().filename() == name; });
}

}  // namespace

TEST_CASE("no name of a model or a folder runs a shell command") {
  for (const std::string name :
       {"|touch PWNED;", "a';system('touch PWNED')#", "a\";system(\"touch PWNED\")\n#", "a\nsystem(\"touch PWNED\")\n",
        "`touch PWNED`", "$(touch PWNED)", "a\\", "@x", "%s%n%99999d", "EOD\nsystem(\"touch PWNED\")"}) {
    CAPTURE(name);
    const Folder folder;
    const std::string model = name + ".csg";
    write(folder / model, cube);
    for (const std::string command : {"compare", "sweep"}) {
      require_success(run_words(study(command, model, name + command), folder.path()));
      CHECK(fs::exists(folder / (name + command + "/" + command + ".csv")));
    }
    require_success(run_words(study("compare", model, ""), folder.path()));
    CHECK_FALSE(is_there(folder.path(), "PWNED"));
  }
}

TEST_CASE("accuracy draws plots for a model whose name has quotes and line breaks") {
  const Folder folder;
  const std::string name = "a'\"\n`touch PWNED`\n%d {}_^ <b>.csg";
  write(folder / name, cube);
  require_success(run_words(study("accuracy", name, "out"), folder.path()));
  CHECK(fs::file_size(folder / "out/pareto.png") > 1000);
  CHECK(content(folder / "out/pareto.svg").find("<b>") == std::string::npos);
  CHECK_FALSE(is_there(folder.path(), "PWNED"));
}

TEST_CASE("file names that are not UTF-8 are read and are stored escaped") {
  const Folder folder;
  for (const std::string& name :
       {std::string("Geh\xe4use.csg"), std::string("\xff\xfe.csg"), std::string(246, 'n') + ".csg"}) {
    CAPTURE(name);
    write(folder / name, cube);
    const Outcome render =
        run_words({"render", name, "--size", "16x16", "-o", "\xe4.png", "--stats", "\xe4.json"}, folder.path());
    CHECK(render.err == "");
    CHECK(render.code == 0);
    CHECK(content(folder / "\xe4.png").substr(1, 3) == "PNG");
    CHECK(json(folder / "\xe4.json")["model"]["primitives"] == 1);
    require_success(run_words({"compile", name, "--size", "16x16", "-o", "p.csgt"}, folder.path()));
    require_success(run_words({"run", "p.csgt", "--stats", "s.json"}, folder.path()));
    CHECK(json(folder / "s.json")["model"] == json(folder / "\xe4.json")["model"]);
    for (const std::string command : {"compare", "sweep"}) {
      const Outcome outcome = run_words(study(command, name, ""), folder.path());
      CHECK(outcome.err == "");
      CHECK(outcome.code == 0);
    }
    const Outcome sweep = run_words(study("sweep", name, "o\xe4"), folder.path());
    CHECK(sweep.err == "");
    CHECK(sweep.code == 0);
    CHECK(json(folder / "o\xe4/sweep.json")["points"].size() == 2);
    const std::string table = content(folder / "o\xe4/sweep.csv");
    require_success(run_words(study("sweep", name, "o\xe4"), folder.path()));
    CHECK(content(folder / "o\xe4/sweep.csv") == table);
    fs::remove_all(folder / "o\xe4");
  }
}

TEST_CASE("rejects a picture's name that is too long before it simulates") {
  const Folder folder;
  write(folder / "m.csg", cube);
  const Outcome outcome =
      run_words({"render", "m.csg", "--size", "16x16", "-o", std::string(252, 'p') + ".png"}, folder.path());
  CHECK(outcome.code == 1);
  CHECK(is_plain_line(outcome.err));
  CHECK(outcome.out == "");
}

TEST_CASE("a table opened in a spreadsheet contains no formulas") {
  const Folder folder;
  write(folder / "=1+1.csg", cube);
  require_success(run_words(study("sweep", "=1+1.csg", "out"), folder.path()));
  const std::string table = content(folder / "out/sweep.csv");
  CHECK(table.find("\n\\x3d1+1.csg,") != std::string::npos);
  CHECK(table.find("\n=") == std::string::npos);
}

TEST_CASE("messages are one line without control characters for any name or key") {
  const Folder folder;
  const std::string bad = "x\x1b[31m\ny";
  write(folder / (bad + ".csg"), "cube(");
  write(folder / (bad + ".toml"),
        "\"\\u001b[2J\\nkey\" = 1\nname = \"n\"\ndescription = \"d\"\nkind = \"frame-buffer\"\n");
  write(folder / (bad + ".csgt"), "CSGT");
  write(folder / "m.csg", cube);
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"render", bad + ".csg"},
                                             {"render", bad},
                                             {"render", "m.csg", "--machine", bad + ".toml"},
                                             {"render", "m.csg", "--machine", bad},
                                             {"manual", "machines", bad + ".toml"},
                                             {"run", bad + ".csgt"},
                                             {"disasm", bad},
                                             {"render", "m.csg", "-o", bad + "/p.png"},
                                             {"render", "m.csg", "-o", bad + ".xyz"},
                                             {"render", "m.csg", "--size", bad},
                                             {"render", "m.csg", "--" + bad},
                                             {bad}}) {
    const Outcome outcome = run_words(words, folder.path());
    CAPTURE(outcome.err);
    CHECK((outcome.code == 1 || outcome.code == 2));
    CHECK(is_plain_line(outcome.err));
  }
}

TEST_CASE("control characters in the description of a machine file are printed escaped") {
  const Folder folder;
  std::string text = content(std::string(CSGSIM_SOURCE_DIR) + "/hw/machines/pixel-planes-4.toml");
  text.replace(text.find("description = \""), 15, "description = \"\\u001b[2J\\u202e");
  write(folder / "m.toml", text);
  const Outcome outcome = require_success(run_words({"manual", "machines", "m.toml"}, folder.path()));
  CHECK(outcome.out.find('\x1b') == std::string::npos);
  CHECK(outcome.out.find("\\x1b[2J\\xe2\\x80\\xae") != std::string::npos);
}

TEST_CASE("a waveform's name cannot inject lines into the file for GTKWave") {
  const Folder folder;
  write(folder / "m.csg", cube);
  const std::string name = "w\"\n@200\n-x.vcd";
  const Outcome outcome =
      run_words({"wave", "m.csg", "--size", "16x16", "--probe", "1,1", "--window", "0:10", "-o", name}, folder.path());
  CAPTURE(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(is_one_line(outcome.out));
  CHECK(content(folder / name).find("$enddefinitions") != std::string::npos);
  CHECK(content(folder / "w\"\n@200\n-x.gtkw").find("-x.vcd") == std::string::npos);
}
