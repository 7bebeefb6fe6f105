#include <fmt/format.h>

#include <string_view>

#include "tests/cli/cli.h"

using namespace csgsim;
using namespace csgsim::testing::cli;

namespace {

/// Number of pictures in an animated GIF, and hundredths of a second for each.
struct Animated {
  unsigned pictures = 0;
  unsigned delay = 0;
  bool repeats = false;
};

/// Walks over the blocks of a GIF89a file.
Animated animated_in(const std::string& gif) {
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(gif.at(at)); };
  const auto table = [&](unsigned flags) { return (flags & 0x80U) != 0 ? std::size_t{3} << ((flags & 7U) + 1) : 0; };
  REQUIRE(gif.substr(0, 6) == "GIF89a");
  Animated animated;
  std::size_t at = 13 + table(byte(10));
  const auto skip_blocks = [&] {
    while (byte(at) != 0) at += std::size_t{1} + byte(at);
    ++at;
  };
  while (byte(at) != 0x3b) {
    if (byte(at) == 0x2c) {
      ++animated.pictures;
      at += 11 + table(byte(at + 9));
    } else {
      REQUIRE(byte(at) == 0x21);
      if (byte(at + 1) == 0xf9) animated.delay = byte(at + 4) + 256U * byte(at + 5);
      if (gif.substr(at + 3, 11) == "NETSCAPE2.0") animated.repeats = true;
      at += 2;
    }
    skip_blocks();
  }
  CHECK(at + 1 == gif.size());
  return animated;
}

/// The stats without what depends on the level and the run.
nlohmann::json counts_in(const std::string& file) {
  nlohmann::json stats = json(file);
  for (const char* const key : {"level", "configuration"}) stats.erase(key);
  for (nlohmann::json& frame : stats["frames"]) frame.erase("picture");
  return stats;
}

}  // namespace

TEST_CASE("both levels draw and count the same frames of an orbit on each kind of machine") {
  for (const std::string_view machine : {"pixel-planes-4", "scan-line", "pixel-square", "pixel-planes-5",
                                         "multi-processor", "digital-bit-serial-ddr4"}) {
    CAPTURE(machine);
    const Folder folder;
    const std::string options =
        fmt::format("render {} --machine {} --size 64x64 --memory-bits 256 --view-all --frames 4 --orbit 360 ",
                    model("thesis_fig_2_3"), machine);
    require_success(run(options + "-o " + (folder / "f.png") + " --stats " + (folder / "f.json")));
    require_success(run(options + "--level cycle -o " + (folder / "c.png") + " --stats " + (folder / "c.json")));
    for (const char* const number : {"_000.png", "_001.png", "_002.png", "_003.png"})
      CHECK(content(folder / (std::string("c") + number)) == content(folder / (std::string("f") + number)));
    CHECK(content(folder / "f_000.png") != content(folder / "f_001.png"));
    CHECK(counts_in(folder / "c.json") == counts_in(folder / "f.json"));
  }
}

TEST_CASE("frames of a file of cameras equal pictures drawn alone and their counts add up") {
  const Folder folder;
  const std::string options = "render " + model("old_example003") + " --size 40x30 --machine scan-line ";
  write(folder / "path.txt", "# two cameras\n75,-100,65,0,0,0\n\n0,0,5,70,30,210,100 # gimbal\n");
  require_success(run(options + "--cameras " + (folder / "path.txt") + " -o " + (folder / "f%d.png") + " --stats " +
                      (folder / "f.json")));
  const std::vector<std::string> alone{"75,-100,65,0,0,0", "0,0,5,70,30,210,100"};
  const nlohmann::json stats = json(folder / "f.json");
  REQUIRE(stats["frames"].size() == alone.size());
  std::uint64_t clocks = 0;
  std::uint64_t host_clocks = 0;
  for (std::size_t i = 0; i < alone.size(); ++i) {
    const std::string picture = folder / fmt::format("f{}.png", i);
    require_success(
        run(options + "--camera=" + alone[i] + " -o " + (folder / "p.png") + " --stats " + (folder / "p.json")));
    CHECK(content(picture) == content(folder / "p.png"));
    const nlohmann::json& frame = stats["frames"][i];
    const nlohmann::json one = json(folder / "p.json");
    CHECK(frame["picture"] == picture);
    for (const char* const key :
         {"clocks", "shown_clocks", "interval_clocks", "depth_tests", "scan_conversions", "pixel_operations"})
      CHECK(frame[key] == one[key]);
    CHECK(frame["instructions"]["total"] == one["instructions"]["total"]);
    CHECK(frame["host_clocks"] <= one["host_clocks"]);
    clocks += frame["clocks"].get<std::uint64_t>();
    host_clocks += frame["host_clocks"].get<std::uint64_t>();
  }
  CHECK(stats["totals"]["frames"] == 2);
  CHECK(stats["totals"]["clocks"] == clocks);
  CHECK(stats["totals"]["host_clocks"] == host_clocks);
  CHECK(stats["configuration"]["options"]["cameras"] == folder / "path.txt");
}

TEST_CASE("an orbit into one .gif shows each frame and repeats") {
  const Folder folder;
  const Outcome drawn =
      require_success(run("render " + model("thesis_fig_2_3") + " --size 40x30 --view-all --frames 5 --orbit 360 -o " +
                          (folder / "f.gif")));
  const Animated animated = animated_in(content(folder / "f.gif"));
  CHECK(animated.pictures == 5);
  CHECK(animated.delay == 5);
  CHECK(animated.repeats);
  CHECK(drawn.out.find("5 frames in ") == 0);
  CHECK(drawn.out.find("written to " + (folder / "f.gif") + "\n") != std::string::npos);
  CHECK(folder.files() == 1);
}

TEST_CASE("frames that were finished before a fault are complete and later ones are missing") {
  const Folder folder;
  write(folder / "path.txt", "42,-38,41,10,5.5,2\n10,5.5,2.5,10,5.5,2\n");
  fs::create_directory(folder / "f_001.png");
  const Outcome outcome = run("render " + model("thesis_fig_2_3") + " --size 40x30 --cameras " + (folder / "path.txt") +
                              " -o " + (folder / "f.png"));
  CHECK(outcome.code == 1);
  CHECK(is_one_line(outcome.err));
  CHECK(outcome.err.find("f_001.png") != std::string::npos);
  CHECK(content(folder / "f_000.png").size() > 100);
  CHECK(folder.files() == 3);
}

TEST_CASE("rejects options that do not suit several frames") {
  const std::string part = "render " + model("old_example003") + " --size 20x20 ";
  check_misuse(part + "--orbit 90 -o x.png", "--orbit: needs several frames");
  check_misuse(part + "--frames 3 --cameras c.txt -o x.png", "--cameras");
  check_misuse(part + "--camera 1,2,3,0,0,0 --cameras c.txt -o x.png", "--camera");
  check_misuse(part + "--frames 3 --owner o.png", "--owner: is for one frame; leave out --frames");
  check_misuse(part + "--frames 3 -o f%s.png", "out_%03d.png");
  check_misuse(part + "--frames 3 -o f_%d.xyz", "--output");
  const Folder folder;
  write(folder / "c.txt", "1,2,3,0,0,0\n");
  check_misuse(part + "--check --cameras " + (folder / "c.txt"), "--check: is for one frame; leave out --cameras");
  check_misuse(part + "--cameras " + (folder / "c.txt") + " --stats " + (folder / "c.txt"),
               "it is the same file as the input");
  write(folder / "c.txt", "1,2,3,0,0,0\n1,2,three,0,0,0\n");
  const Outcome wrong = run(part + "--cameras " + (folder / "c.txt"));
  CHECK(wrong.code == 1);
  CHECK(wrong.err.find("c.txt:2:5: '1,2,three") != std::string::npos);
}
