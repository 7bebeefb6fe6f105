#include "sim/viewer/lanes.h"

#include <rapidcheck.h>

#include "tests/support/test.h"

using namespace csgsim;
using Json = nlohmann::ordered_json;

namespace {

/// A lane by its text in each clock from `first` on; empty while idle.
struct Clocks {
  std::uint64_t first = 0;
  std::vector<std::string> texts;

  [[nodiscard]] std::uint64_t end() const { return first + texts.size(); }
};

std::string trace_of(const Clocks& lane) {
  std::string events = R"({"ph":"M","name":"process_name","pid":1,"tid":0,"args":{"name":"host"}},
{"ph":"M","name":"thread_name","pid":1,"tid":1,"args":{"name":"state"}})";
  for (std::size_t i = 0; i < lane.texts.size();) {
    std::size_t end = i + 1;
    while (end < lane.texts.size() && lane.texts[end] == lane.texts[i]) ++end;
    if (!lane.texts[i].empty()) {
      events +=
          fmt::format(R"(,{{"ph":"X","name":"{}","pid":1,"tid":1,"ts":0,"dur":0,"args":{{"clock":{},"clocks":{}}}}})",
                      lane.texts[i], lane.first + i, end - i);
    }
    i = end;
  }
  return R"({"displayTimeUnit":"ns","traceEvents":[)" + events + "]}";
}

/// Number of clocks from `begin` to `end` with a text.
std::uint64_t busy_clocks(const Clocks& lane, std::uint64_t begin, std::uint64_t end) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < lane.texts.size(); ++i) {
    const std::uint64_t clock = lane.first + i;
    count += clock >= begin && clock < end && !lane.texts[i].empty() ? 1U : 0U;
  }
  return count;
}

std::uint64_t busy_clocks(const Json& stretch) { return stretch.at(stretch.size() == 5 ? 4 : 1).get<std::uint64_t>(); }

}  // namespace

TEST_CASE("a zoomed-in lane keeps its stretches unmerged and clips them to the range") {
  const viewer::Lanes lanes(trace_of({10, {"a", "a", "", "b", "a"}}));
  CHECK(lanes.begin() == 10);
  CHECK(lanes.end() == 15);
  const Json all = lanes.between(0, 100);
  REQUIRE(all.size() == 1);
  CHECK(all[0].at("part") == "host");
  CHECK(all[0].at("name") == "state");
  CHECK(all[0].at("stretches") == Json::parse(R"([[10,2,"a"],[13,1,"b"],[14,1,"a"]])"));
  CHECK(lanes.between(11, 14)[0].at("stretches") == Json::parse(R"([[11,1,"a"],[13,1,"b"]])"));
  CHECK(lanes.between(12, 13)[0].at("stretches").empty());
  CHECK(lanes.between(14, 12)[0].at("stretches").empty());
}

TEST_CASE("zooming out merges short stretches and counts each clock once") {
  const bool holds = rc::check("zoomed lanes count each clock once", [] {
    const auto runs = *rc::gen::container<std::vector<std::pair<int, int>>>(
        400, rc::gen::pair(rc::gen::inRange(0, 4), rc::gen::inRange(1, 12)));
    Clocks lane{*rc::gen::inRange<std::uint64_t>(0, 1000), {}};
    for (const auto& [text, clocks] : runs)
      lane.texts.insert(lane.texts.end(), static_cast<std::size_t>(clocks),
                        std::string(static_cast<std::size_t>(text), 'x'));
    const auto begin = *rc::gen::inRange<std::uint64_t>(lane.first, lane.end());
    const auto end = *rc::gen::inRange<std::uint64_t>(begin + 1, lane.end() + 50);
    const Json stretches = viewer::Lanes(trace_of(lane)).between(begin, end)[0].at("stretches");
    std::uint64_t busy = 0;
    std::uint64_t next = begin;
    for (const Json& one : stretches) {
      RC_ASSERT(one[0].get<std::uint64_t>() >= next);
      next = one[0].get<std::uint64_t>() + one[1].get<std::uint64_t>();
      RC_ASSERT(busy_clocks(one) == busy_clocks(lane, one[0], next));
      busy += busy_clocks(one);
    }
    RC_ASSERT(next <= end);
    RC_ASSERT(busy == busy_clocks(lane, begin, end));
    RC_ASSERT(stretches.size() <= 1700U);
  });
  CHECK(holds);
}

TEST_CASE("a lane of many stretches is sent as few with their most frequent text") {
  Clocks lane{0, std::vector<std::string>(100'000, "a")};
  for (std::size_t i = 0; i < lane.texts.size(); i += 5) lane.texts[i] = "b";
  const Json stretches = viewer::Lanes(trace_of(lane)).between(0, 100'000)[0].at("stretches");
  CHECK(stretches.size() <= 401);
  CHECK(stretches.size() >= 200);
  for (const Json& one : stretches) {
    REQUIRE(one.size() == 5);
    CHECK(one[2] == "a");
    CHECK(one[3].get<std::uint64_t>() > 50);
  }
}

TEST_CASE("adjacent short stretches of a lane are merged and a single one is kept") {
  // Over 800 clocks, a stretch of 2 is shown alone, and one of 1 is too short.
  Clocks lane{0, std::vector<std::string>(800)};
  const auto show = [&](std::size_t clock, const char* text) { lane.texts[clock] = text; };
  show(0, "a");
  show(1, "b");
  show(10, "c");
  show(20, "d");
  show(21, "d");
  show(30, "e");
  show(32, "f");
  show(40, "g");
  show(42, "h");
  show(43, "h");
  show(799, "z");
  CHECK(
      viewer::Lanes(trace_of(lane)).between(0, 800)[0].at("stretches") ==
      Json::parse(R"([[0,2,"a",2,2],[10,1,"c"],[20,2,"d"],[30,1,"e"],[32,1,"f"],[40,1,"g"],[42,2,"h"],[799,1,"z"]])"));
}

TEST_CASE("a merged stretch has the text of most clocks and the number of busy clocks") {
  // Over 2000 clocks, a stretch of 5 is shown alone.
  Clocks lane{0, std::vector<std::string>(2000)};
  lane.texts[0] = "a";
  lane.texts[1] = "b";
  lane.texts[2] = "b";
  lane.texts[4] = "c";
  lane.texts[1999] = "z";
  CHECK(viewer::Lanes(trace_of(lane)).between(0, 2000)[0].at("stretches") ==
        Json::parse(R"([[0,5,"b",3,4],[1999,1,"z"]])"));
}

TEST_CASE("a lane lists each one-clock stretch of 799 clocks and merges pairs of 800") {
  Clocks lane{0, std::vector<std::string>(1000, "a")};
  for (std::size_t i = 0; i < lane.texts.size(); i += 2) lane.texts[i] = "b";
  const viewer::Lanes lanes(trace_of(lane));
  CHECK(lanes.between(0, 799)[0].at("stretches").size() == 799);
  CHECK(lanes.between(201, 1000)[0].at("stretches").size() == 799);
  CHECK(lanes.between(0, 800)[0].at("stretches").size() == 400);
  CHECK(lanes.between(0, 800)[0].at("stretches")[7] == Json::parse(R"([14,2,"b",2,2])"));
}

TEST_CASE("each lane has its part's name and its own stretches in any input order") {
  const auto named = [](const char* what, int part, int lane, const char* name) {
    return fmt::format(R"({{"ph":"M","name":"{}","pid":{},"tid":{},"args":{{"name":"{}"}}}},)", what, part, lane, name);
  };
  const auto stretch = [](int lane, const char* text, int clock, int clocks) {
    return fmt::format(R"({{"ph":"X","name":"{}","pid":1,"tid":{},"args":{{"clock":{},"clocks":{}}}}},)", text, lane,
                       clock, clocks);
  };
  std::string events = named("process_name", 1, 0, "host") + named("process_name", 2, 0, "array") +
                       named("thread_name", 2, 7, "pixels") + named("thread_name", 1, 5, "queue") +
                       named("thread_name", 2, 6, "bus") + stretch(5, "x", 30, 4) + stretch(7, "y", 12, 3) +
                       stretch(6, "x", 20, 5) + stretch(7, "x", 40, 2);
  events.pop_back();
  const viewer::Lanes lanes(R"({"traceEvents":[)" + events + "]}");
  CHECK(lanes.begin() == 12);
  CHECK(lanes.end() == 42);
  CHECK(lanes.between(0, 100) == Json::parse(R"([{"part":"array","name":"pixels","stretches":[[12,3,"y"],[40,2,"x"]]},
    {"part":"host","name":"queue","stretches":[[30,4,"x"]]},{"part":"array","name":"bus","stretches":[[20,5,"x"]]}])"));
  const viewer::Lanes none(R"({"traceEvents":[]})");
  CHECK(none.begin() == 0);
  CHECK(none.end() == 0);
  CHECK(none.between(0, 10) == Json::array());
}

TEST_CASE("a merged stretch starts with its first member and ends before a long one") {
  // Over 4,000 clocks a stretch of 10 is shown alone; ten clocks from the first on are merged.
  Clocks lane{0, std::vector<std::string>(4000)};
  for (const std::size_t clock : {5U, 6U}) lane.texts[clock] = "a";
  for (const std::size_t clock : {8U, 9U}) lane.texts[clock] = "b";
  for (const std::size_t clock : {14U, 15U, 16U}) lane.texts[clock] = "c";
  for (std::size_t clock = 18; clock < 28; ++clock) lane.texts[clock] = "d";
  for (const std::size_t clock : {28U, 30U}) lane.texts[clock] = "e";
  lane.texts[3999] = "z";
  CHECK(viewer::Lanes(trace_of(lane)).between(0, 4000)[0].at("stretches") ==
        Json::parse(R"([[5,12,"c",3,7],[18,10,"d"],[28,3,"e",2,2],[3999,1,"z"]])"));
}

TEST_CASE("stretches of a lane are clipped at both ends of the requested range") {
  Clocks lane{0, std::vector<std::string>(100, "a")};
  const viewer::Lanes lanes(trace_of(lane));
  CHECK(lanes.between(10, 30)[0].at("stretches") == Json::parse(R"([[10,20,"a"]])"));
  CHECK(lanes.between(99, 200)[0].at("stretches") == Json::parse(R"([[99,1,"a"]])"));
  CHECK(lanes.between(100, 200)[0].at("stretches").empty());
  CHECK(lanes.between(0, 0)[0].at("stretches").empty());
}
