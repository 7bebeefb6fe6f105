#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

TEST_CASE("accuracy measures and plots every setting and reuses its points") {
  const Folder folder;
  const std::string command = "accuracy " + model("old_example011") + " --size 48x48 --views 2 -o " + (folder / "a");
  require_success(run(command));
  const std::string table = content(folder / "a/accuracy.csv");
  for (const std::string knob : {"z-bits", "fraction-bits", "edge-on", "size", "fn", "tolerance", "pareto"}) {
    if (knob != "pareto") CHECK(table.find("\n" + knob + ",") != std::string::npos);
    CHECK(fs::file_size(folder / ("a/" + knob + ".png")) > 1000);
    CHECK(fs::file_size(folder / ("a/" + knob + ".svg")) > 1000);
  }
  CHECK(json(folder / "a/accuracy.json")["points"].size() > 60);
  // Simulates an interruption: removes the last line and half of the one before.
  const std::string cut = table.substr(0, table.rfind('\n', table.rfind('\n', table.size() - 2) - 1) - 5);
  write(folder / "a/accuracy.csv", cut);
  require_success(run(command + " --no-plots"));
  CHECK(content(folder / "a/accuracy.csv") == table);
  CHECK(run(command + " --projection perspective").code == 1);
}

TEST_CASE("accuracy compares exact curves with facets of each tolerance where supported") {
  const Folder folder;
  const std::string command =
      "accuracy " + model("thesis_fig_2_3") +
      " --camera 42,-38,41,10,5.5,2 --size 64x64 --views 2 --knobs curves,tolerance --tolerances 0.5,0.0005 -o " +
      (folder / "a");
  const Outcome outcome = require_success(run(command + " --machine pixel-powers --report " + (folder / "a.html")));
  const auto points = json(folder / "a/accuracy.json")["points"];
  REQUIRE(points.size() == 4);
  CHECK(points[0]["value"] == "0.5");
  CHECK(points[1]["value"] == "0.0005");
  CHECK(points[2]["value"] == "facets");
  CHECK(points[3]["value"] == "exact");
  CHECK(points[3]["facet_wrong"] == 0);
  CHECK(points[3]["unexplained"] == 0);
  CHECK(points[2]["facet_wrong"] > 0);
  CHECK(outcome.out.find("\nFacets of equal accuracy: tolerance 0.0005, ") != std::string::npos);
  CHECK(outcome.out.find("Pareto front") == std::string::npos);
  CHECK(fs::file_size(folder / "a/curves.svg") > 1000);
  CHECK(content(folder / "a.html").find(": facets and curved surfaces") != std::string::npos);
  fails(run(command + "x"), 1, {"pixel-powers"});
  CHECK(run(command + "x --machine pixel-powers --tolerances 0").code != 0);
}

TEST_CASE("accuracy compares fast spheres with facets and names the curves it omits") {
  const Folder folder;
  const std::string command =
      "accuracy " + model("molecule") + " --view-all --size 48x48 --views 1 --knobs curves --no-plots -o ";
  const Outcome linear = require_success(run(command + (folder / "a")));
  const auto points = json(folder / "a/accuracy.json")["points"];
  REQUIRE(points.size() == 2);
  CHECK(points[0]["value"] == "facets");
  CHECK(points[1]["value"] == "fast");
  CHECK(points[1]["halfspaces"] == 26);
  CHECK(points[1]["facet_wrong"] > points[0]["facet_wrong"]);
  CHECK(linear.out.find("\nfast curves: ") != std::string::npos);
  CHECK(linear.err.find("--knobs curves, not exact: pixel-planes-4") != std::string::npos);
  const Outcome near =
      require_success(run(command + (folder / "b") + " --projection perspective --machine pixel-powers"));
  CHECK(near.err.find("--knobs curves, not fast: ") != std::string::npos);
  CHECK(json(folder / "b/accuracy.json")["points"][1]["value"] == "exact");
  fails(run(command + (folder / "c") + " --projection perspective"), 1, {"not fast: ", "not exact: "});
}

TEST_CASE("sweep writes a table and plots for every model and measures no point twice") {
  const Folder folder;
  const std::string command = "sweep " + model("old_example011") + " " + model("thesis_fig_2_3") +
                              " --size 48x36 --threads 2 -o " + (folder / "s") + " --stack-bits ";
  const Outcome first = run(command + "3..5");
  CHECK(first.err.empty());
  REQUIRE(first.code == 0);
  CHECK(first.out.find("All pictures of a model with the same size and z bits are identical") != std::string::npos);
  CHECK(first.out.find("number of scan-conversions of primitives in active trees") != std::string::npos);
  CHECK(first.out.find("fewest clocks: ") != std::string::npos);
  for (const std::string name : {"old_example011", "thesis_fig_2_3"}) {
    for (const std::string plot : {"_scan_conversions", "_clocks", "_bits", "_memory"}) {
      for (const std::string ending : {".png", ".svg"})
        CHECK(fs::file_size(folder / ("s/" + name + plot + ending)) > 1000);
    }
  }
  const nlohmann::json points = json(folder / "s/sweep.json")["points"];
  REQUIRE(points.size() == 2 * 8);
  CHECK(points[2]["strategy"] == "bits");
  CHECK(points[2]["stack_bits"] == 3);
  CHECK(points[0]["clocks"] > 0);
  // Simulates an interruption: removes the last line and half of the one before. The marked line must stay unchanged.
  const std::string table = content(folder / "s/sweep.csv");
  const std::string csgsim = points[0]["csgsim"];
  const std::string measured = "," + csgsim + ",stack,rebroadcast,";
  const std::string marked = "," + csgsim + ",marked,rebroadcast,";
  std::string expected = table;
  expected.replace(expected.find(measured), measured.size(), marked);
  const std::size_t last = expected.rfind('\n', expected.size() - 2);
  const std::size_t before = expected.rfind('\n', last - 1);
  write(folder / "s/sweep.csv", expected.substr(0, before + 30));
  require_success(run(command + "3..5 --no-plots"));
  CHECK(content(folder / "s/sweep.csv") == expected);
  // Another range measures only the new values and keeps the known ones.
  require_success(run(command + "6 --no-plots --strategy bits"));
  CHECK(json(folder / "s/sweep.json")["points"].size() == 2);
  require_success(run(command + "3..5 --no-plots"));
  CHECK(content(folder / "s/sweep.csv").starts_with(expected));
  CHECK(run(command + "3..5 --no-plots --projection perspective").code == 1);
}

TEST_CASE("an interrupted sweep resumes when its command is repeated") {
  const Folder folder;
  const std::string output = folder / "s";
  const std::string whole = folder / "whole";
  const std::string words = "sweep " + model("carburettor") + " --size 300x300 --strategy bits --stack-bits 3..14" +
                            " --threads 2 --no-plots -o ";
  require_success(run(words + whole));
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const std::string command = "exec " + std::string(CSGSIM_BINARY_DIR) + "/csgsim " + words + output + " >/dev/null";
    ::execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    std::_Exit(127);
  }
  const auto lines = [&] {
    const std::string text = content(output + "/sweep.csv");
    return std::count(text.begin(), text.end(), '\n');
  };
  for (int wait = 0; wait < 3000 && lines() < 3; ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ::kill(child, SIGINT);
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(WIFSIGNALED(status));
  CHECK(lines() >= 3);
  CHECK(lines() < 13);
  require_success(run(words + output));
  CHECK(content(output + "/sweep.csv") == content(whole + "/sweep.csv"));
  CHECK(content(output + "/sweep.json") == content(whole + "/sweep.json"));
}

TEST_CASE("a point that exceeds the memory gives a reason and sweep fails if all points do") {
  const Folder folder;
  const std::string command = "sweep " + model("old_example011") +
                              " --size 48x36 --no-plots --strategy stack,list --z-bits 20,24 -o " + (folder / "s");
  const Outcome outcome = require_success(run(command + " --memory-bits 70"));
  const nlohmann::json points = json(folder / "s/sweep.json")["points"];
  REQUIRE(points.size() == 4);
  CHECK(points[0]["clocks"] > 0);
  CHECK(!points[2].contains("clocks"));
  CHECK(points[2]["reason"].get<std::string>().find("memory bits") != std::string::npos);
  CHECK(outcome.out.find("2 of 4 points cannot be compiled") != std::string::npos);
  const Outcome none = run(command + " --memory-bits 30");
  CHECK(none.code == 1);
  CHECK(is_one_line(none.err));
}

TEST_CASE("sweep rejects invalid ranges and unknown names before it measures") {
  const Folder folder;
  const std::string sweep = "sweep " + model("old_example011") + " -o " + (folder / "s") + " ";
  check_misuse(sweep + "--stack-bits 8..3", "3..8");
  check_misuse(sweep + "--stack-bits 2", "3 to 64");
  check_misuse(sweep + "--z-bits 16,", "empty element in list");
  check_misuse(sweep + "--strategy stack,lst", "did you mean list?");
  check_misuse(sweep + "--pruning no-spice", "did you mean no-space?");
  check_misuse(sweep + "--colouring red", "rebroadcast");
  check_misuse(sweep + "--threads 0", "--threads");
  check_misuse("sweep -o " + (folder / "s"), "MODEL");
  CHECK(run(sweep + "--machines pixel-plane-4").err.find("pixel-planes-4") != std::string::npos);
  CHECK(folder.files() == 0);
}

TEST_CASE("render --max-wrong-pixels 40 has at most 40 wrong pixels and fewer clocks") {
  const Folder folder;
  const std::string options =
      "render " + model("old_example002") + " --size 100x80 --check --stats " + (folder / "s.json");
  require_success(run(options));
  const nlohmann::json fine = json(folder / "s.json");
  CHECK(fine["accuracy"]["unexplained"] == 0);
  CHECK(fine["accuracy"]["wrong"] <= 1);
  require_success(run(options + " --max-wrong-pixels 40"));
  const nlohmann::json coarse = json(folder / "s.json");
  CHECK(coarse["accuracy"]["wrong"] <= 40);
  CHECK(coarse["clocks"] < fine["clocks"]);
  CHECK(coarse["machine"]["z_bits"] < 20);
}

TEST_CASE("levels runs a model at every level and reports no difference") {
  const Outcome outcome = require_success(run("levels " + model("old_example011") + " --size 40x30"));
  for (const std::string level : {"functional", "cycle", "reference"})
    CHECK(outcome.out.find(level) != std::string::npos);
  CHECK(outcome.out.find("DIFFERENT") == std::string::npos);
}
