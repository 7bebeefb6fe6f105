#include "tests/cli/cli.h"
#include "tests/waves/vcd.h"

namespace {

using namespace csgsim::testing::cli;

struct Stretch {
  std::string shown;
  std::uint64_t begin = 0;
  std::uint64_t clocks = 0;
};

/// The stretches of each lane, `PART.LANE`, in the order of the file. Checks times against clocks of `period_ps`.
std::map<std::string, std::vector<Stretch>> read_lanes(const nlohmann::json& file, double period_ps) {
  std::map<int, std::string> parts;
  std::map<int, std::string> names;
  std::map<std::string, std::vector<Stretch>> lanes;
  for (const nlohmann::json& event : file.at("traceEvents")) {
    if (event.at("ph") == "M") {
      const bool is_part = event.at("name") == "process_name";
      (is_part ? parts : names)[event.at(is_part ? "pid" : "tid")] = event.at("args").at("name");
      continue;
    }
    REQUIRE(event.at("ph") == "X");
    const Stretch one{event.at("name"), event.at("args").at("clock"), event.at("args").at("clocks")};
    CHECK(event.at("ts").get<double>() == doctest::Approx(static_cast<double>(one.begin) * period_ps / 1e6));
    CHECK(event.at("dur").get<double>() == doctest::Approx(static_cast<double>(one.clocks) * period_ps / 1e6));
    lanes[parts.at(event.at("pid")) + "." + names.at(event.at("tid"))].push_back(one);
  }
  return lanes;
}

using Clocks = std::map<std::string, std::uint64_t>;

Clocks clocks_of(const std::vector<Stretch>& lane) {
  Clocks clocks;
  for (const Stretch& one : lane) clocks[one.shown] += one.clocks;
  return clocks;
}

/// A small frame of a machine: its lanes, and the nonzero counts of its parts in a run.
struct Frame {
  explicit Frame(const std::string& machine, const std::string& window = "", double period_ps = 100e3) {
    const Folder folder;
    const std::string options = " " + model("thesis_fig_2_3") + " --size 64x64 --machine " + machine;
    const Outcome wave = run("wave" + options + window + " -o " + (folder / "parts.json"));
    REQUIRE_MESSAGE(wave.code == 0, wave.err);
    CHECK(folder.files() == 1);
    lanes = read_lanes(json(folder / "parts.json"), period_ps);
    const Outcome outcome =
        run("render" + options + " --level cycle -o " + (folder / "p.png") + " --stats " + (folder / "s.json"));
    REQUIRE_MESSAGE(outcome.code == 0, outcome.err);
    const nlohmann::json stats = json(folder / "s.json");
    shown_clocks = stats.at("shown_clocks");
    for (const auto& [part, counts] : stats.at("account").at("parts").items()) {
      for (const auto& [name, clocks] : counts.items()) {
        if (clocks > 0) counted[part][name] = clocks;
      }
    }
  }

  std::map<std::string, std::vector<Stretch>> lanes;
  std::map<std::string, Clocks> counted;
  std::uint64_t shown_clocks = 0;
};

}  // namespace

TEST_CASE("lanes of a scan-line array over a frame add up to the counts of a run") {
  const Frame frame("scan-line");
  for (const char* const part : {"host", "link", "entry"}) {
    CAPTURE(part);
    CHECK(clocks_of(frame.lanes.at(part + std::string(".activity"))) == frame.counted.at(part));
  }
}
TEST_CASE("the link's lane of a frame buffer equals a run's counts until the picture ends") {
  const Frame frame("pixel-planes-4");
  const Clocks link = clocks_of(frame.lanes.at("host.state"));
  const Clocks& counted = frame.counted.at("host link");
  CHECK(link.at("sending") == counted.at("sending"));
  CHECK(link.at("blocked") == counted.at("blocked"));
  CHECK(link.at("waiting") + link.at("latent") == counted.at("waiting"));
  std::uint64_t all = 0;
  for (const auto& [name, clocks] : link) all += clocks;
  CHECK(all == frame.shown_clocks);
}
TEST_CASE("the lanes of a pixel-square machine have the waits that a run counts") {
  const Frame frame("pixel-square");
  const Clocks sender = clocks_of(frame.lanes.at("sender.state"));
  const Clocks& counted = frame.counted.at("sender");
  CHECK(sender.at("sending") == counted.at("working"));
  CHECK(sender.at("waiting_for_divider") == counted.at("waiting_for_divider"));
  CHECK(sender.at("waiting_for_renderer") == counted.at("waiting_for_renderer"));
  CHECK(clocks_of(frame.lanes.at("host.state")).at("sending") == frame.counted.at("host").at("working"));
}
TEST_CASE("the lanes of ring and frame buffer have the working clocks that a run counts") {
  const Frame frame("pixel-planes-5", "", 25e3);
  // The edge that ends the frame takes its last word.
  const auto all_but_the_last = [](std::uint64_t clocks) { return clocks - 1; };
  CHECK(clocks_of(frame.lanes.at("ring.state")).at("working") ==
        all_but_the_last(frame.counted.at("ring").at("working")));
  const Clocks buffer = clocks_of(frame.lanes.at("frame_buffer.state"));
  const Clocks& counted = frame.counted.at("frame buffer");
  CHECK(buffer.at("working") == all_but_the_last(counted.at("working")));
  CHECK(buffer.contains("refreshing") == counted.contains("refreshing"));
  if (counted.contains("refreshing")) CHECK(buffer.at("refreshing") == counted.at("refreshing"));
}
TEST_CASE("a file of lanes has separate lanes for trees and scan-out") {
  const Frame frame("pixel-planes-4");
  const Clocks root = clocks_of(frame.lanes.at("root.state"));
  CHECK(root.at("streaming") > 0);
  CHECK(root.at("streaming") <= clocks_of(frame.lanes.at("controller.state")).at("issuing"));
  const std::vector<Stretch>& shown = frame.lanes.at("scan_out.state");
  CHECK(shown.back().begin + shown.back().clocks == frame.shown_clocks);
}
TEST_CASE("lanes of a pixel and its trees equal their wave clock for clock") {
  const Folder folder;
  const std::string words = "wave " + model("thesis_fig_2_3") +
                            " --size 8x8 --z-bits 8 --fraction-bits 0 --window i8:i10" +
                            " --pixel 5,3 --probe tree.x:3 -o ";
  for (const char* const name : {"w.json", "w.vcd"}) {
    const Outcome outcome = run(words + (folder / name));
    REQUIRE_MESSAGE(outcome.code == 0, outcome.err);
  }
  const auto lanes = read_lanes(json(folder / "w.json"), 100e3);
  const csgsim::test::Vcd vcd(content(folder / "w.vcd"));
  for (const char* const name : {"pixel_5_3.tree_x_3", "pixel_5_3.enable", "root.bit", "controller.bit"}) {
    CAPTURE(name);
    std::size_t compared = 0;
    for (const Stretch& one : lanes.at(name)) {
      for (std::uint64_t clock = one.begin; clock < one.begin + one.clocks; ++clock, ++compared)
        CHECK(vcd.number_at("frame_buffer." + std::string(name), (clock + 1) * 100'000) == std::stoull(one.shown));
    }
    CHECK(compared > 5);
  }
}
TEST_CASE("stretches of a lane are in order and adjacent ones show different values") {
  const Frame frame("pixel-planes-5", " --window 300:900", 25e3);
  CHECK(frame.lanes.size() > 20);
  for (const auto& one : frame.lanes) {
    CAPTURE(one.first);
    const std::vector<Stretch>& lane = one.second;
    CHECK(lane.front().begin >= 300);
    CHECK(lane.back().begin + lane.back().clocks <= 900);
    for (std::size_t i = 0; i < lane.size(); ++i) {
      CHECK(lane[i].clocks > 0);
      if (i == 0) continue;
      const std::uint64_t end = lane[i - 1].begin + lane[i - 1].clocks;
      CHECK(lane[i].begin >= end);
      CHECK((lane[i].begin > end || lane[i].shown != lane[i - 1].shown));
    }
  }
}
TEST_CASE("a file of lanes without a pixel accepts only windows of clocks and needs .json") {
  check_misuse("wave traces/x.csgt --at owner -o parts.json", "name one, as in --pixel 100,20");
  check_misuse("wave traces/x.csgt --window i3 -o parts.json", "FIRST:END");
  check_misuse("wave traces/x.csgt --lanes -o parts.vcd", "a name that ends in .json");
}
