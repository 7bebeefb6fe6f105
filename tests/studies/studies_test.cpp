#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "hw/base/error.h"
#include "places.h"
#include "sim/app/study_commands.h"
#include "sim/session/options/usage.h"
#include "sim/studies/folder.h"
#include "tests/studies/collatz.h"
#include "tests/support/error_of.h"

using namespace csgsim;

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr std::array<const studies::StudyRow*, 1> rows{&testing::collatz_row};

/// A folder with a file of numbers, in which the study runs.
class Place {
 public:
  explicit Place(const std::string& name) : path_(fs::path(CSGSIM_BINARY_DIR) / "scratch_studies" / name) {
    fs::remove_all(path_);
    fs::create_directories(path_);
    write("numbers.txt", "27\n6\n97\n1\n");
  }
  ~Place() { fs::remove_all(path_); }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

  [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(path_ / name) << text; }

  [[nodiscard]] std::string content(const std::string& name) const {
    std::ifstream file(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

  [[nodiscard]] Words files() const {
    Words names;
    for (const auto& entry : fs::directory_iterator(path_)) names.push_back(entry.path().filename());
    std::ranges::sort(names);
    return names;
  }

  [[nodiscard]] nlohmann::json points(const std::string& file) const {
    return nlohmann::json::parse(content(file))["points"];
  }

  /// Runs a command line.
  static void run(const Words& words) {
    shell::CommandLine line("csgsim: a study that lives here alone", "csgsim");
    app::add_study_command(line, testing::collatz_row);
    app::add_gather_command(line, rows);
    line.run(words, {});
  }

  /// Runs the study of the numbers with the given output folder.
  void study(const std::string& folder, const Words& more = {}) const {
    Words words{"collatz", *this / "numbers.txt", "-o", *this / folder};
    words.insert(words.end(), more.begin(), more.end());
    run(words);
  }

 private:
  fs::path path_;
};

}  // namespace

TEST_CASE("a new study writes a table and JSON and plots and a report") {
  const Place place("whole");
  place.study("out", {"--addends", "1,3", "--report", place / "page.html"});
  const std::string table = place.content("out/collatz.csv");
  CHECK(table.starts_with("number,addend,model_hash,machine_hash,csgsim,clocks,highest,reason\n"));
  CHECK(std::ranges::count(table, '\n') == 1 + 4 * 2);
  CHECK(place.content("out/collatz.study") == "csgsim collatz\n");
  const nlohmann::json points = place.points("out/collatz.json");
  REQUIRE(points.size() == 8);
  CHECK(points[0]["clocks"] == 111);  // published number of steps for 27
  CHECK(points[0]["highest"] == 9232);
  CHECK(points[2]["number"] == "6");
  CHECK(points[2]["clocks"] == 8);
  for (const char* const file : {"out/collatz_steps.png", "out/collatz_steps.svg"})
    CHECK(place.content(file).size() > 1000);
  const std::string page = place.content("page.html");
  for (const char* const part : {"Steps to 1: ", ">clocks<", ">111<"}) CHECK(page.find(part) != std::string::npos);
}

TEST_CASE("a study's default folder is named after the model and the study") {
  CHECK(studies::default_output_folder("a/part.scad", "sweep") == "part-sweep");
  CHECK(studies::default_output_folder("-", "sweep") == "model-sweep");
  CHECK(studies::default_output_folder("a/models/", "corpus") == "models-corpus");
  CHECK(studies::default_output_folder("a/models", "corpus") == "models-corpus");
  CHECK(studies::default_output_folder("a/models/.", "corpus") == "models-corpus");
  CHECK(studies::default_output_folder(".", "corpus") == std::filesystem::current_path().stem().native() + "-corpus");
}

TEST_CASE("a study without -o writes into its default folder") {
  const Place place("usual");
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(place / ".");
  Place::run({"collatz", "numbers.txt", "--no-plots"});
  std::filesystem::current_path(before);
  CHECK(place.files() == Words{"numbers-collatz", "numbers.txt"});
  CHECK(place.points("numbers-collatz/collatz.json")[0]["clocks"] == 111);
}

TEST_CASE("a study resumes and remeasures points whose inputs changed") {
  const Place place("again");
  place.study("out", {"--no-plots"});
  const std::string table = place.content("out/collatz.csv");
  place.write("out/collatz.csv", table.substr(0, table.size() - 5));
  place.study("out", {"--no-plots"});
  CHECK(place.content("out/collatz.csv") == table);
  // Rows of any build of csgsim are kept as they are: an edited number remains.
  std::string changed = table;
  changed.replace(changed.find(",111,"), 5, ",112,");
  place.write("out/collatz.csv", changed);
  place.study("out", {"--no-plots", "--addends", "1,3"});
  CHECK(place.points("out/collatz.json")[0]["clocks"] == 112);
  place.write("numbers.txt", "27\nzero\n");
  place.study("out", {"--no-plots"});
  CHECK(place.points("out/collatz.json")[0]["clocks"] == 111);
  CHECK(place.points("out/collatz.json")[1]["reason"] == "that is no number from 1 on");
  CHECK_FALSE(place.points("out/collatz.json")[1].contains("clocks"));
}

TEST_CASE("gathered shards of a new study give the files of one process") {
  const Place place("shards");
  place.study("one", {"--addends", "1,3,5", "--no-plots"});
  for (const char* const shard : {"1/3", "3/3"}) place.study("out", {"--addends", "1,3,5", "--shard", shard});
  const auto gather = [&] { Place::run({"gather", place / "out", "--no-plots"}); };
  CHECK(testing::error_of(gather).find("shard 2 of 3 is not complete; complete it by: csgsim collatz --shard 2/3") !=
        std::string::npos);
  place.study("out", {"--addends", "1,3,5", "--shard", "2/3"});
  gather();
  for (const char* const file : {"/collatz.csv", "/collatz.json"})
    CHECK(place.content(std::string("out") + file) == place.content(std::string("one") + file));
}

TEST_CASE("a new study rejects wrong values of the options that all studies have") {
  const Place place("options");
  for (const Words& words : {Words{"--addends", "0"}, Words{"--shard", "3/2"}, Words{"--threads", "0"},
                             Words{"--report", "page.txt"}, Words{"--shard", "1/2", "--report", "page.html"}})
    CHECK_THROWS_AS(place.study("out", words), session::UsageError);
  place.write("numbers.txt", "none\n");
  CHECK_THROWS_AS(place.study("out", {"--no-plots"}), InputError);
}
