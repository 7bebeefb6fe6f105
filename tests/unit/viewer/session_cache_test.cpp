// Tests of the session's caches: after any single change each answer equals that of a new session.

#include <unistd.h>

#include "places.h"
#include "sim/report/codec.h"
#include "sim/viewer/session.h"
#include "tests/support/test.h"
#include "tests/unit/viewer/asked.h"

using namespace csgsim;
using testing::ask;
using viewer::Json;

namespace {

const std::string file = CSGSIM_SOURCE_DIR "/tests/models/thesis_fig_2_3.csg";

const Json small{{"size", "40x30"}, {"camera", "30,-40,25,0,0,2"}};

/// The knobs with one of them changed.
Json with(const char* name, Json value) {
  Json knobs = small;
  knobs[name] = std::move(value);
  return {{"knobs", std::move(knobs)}};
}

/// Variants of `small` with a single change each.
std::vector<Json> changes() {
  return {with("camera", "30,-40,26,0,0,2"),
          with("size", "41x30"),
          with("machine", "pixel-square"),
          with("memory-bits", "71"),
          with("z-bits", "12"),
          with("fraction-bits", "6"),
          with("projection", "perspective"),
          with("strategy", "bits"),
          with("pruning", "none"),
          with("tolerance", "1"),
          with("snap", true),
          with("set", {"effects.depth_cue.on=true"}),
          with("set", {"effects.cuts.0.normal=0,0,1", "effects.cuts.0.point=0,0,3"}),
          with("set", {"alu.bits=4"}),
          {{"knobs", small}, {"source", "cube(size=[9,9,9],center=true);"}}};
}

/// The answer without its wall-clock times.
Json timeless(Json answer) {
  answer.erase("seconds");
  return answer;
}

struct Question {
  const char* name;
  Json members = Json::object();
};

std::vector<Question> questions() {
  return {{"draw"},
          {"tree"},
          {"explain", {{"pixel", "20,15"}}},
          {"instant", {{"number", 30}, {"field", "Z1"}, {"tinted", true}}},
          {"instant", {{"number", 12}}},
          {"verdict"}};
}

Json answer_to(viewer::Session& session, const Question& question, const Json& base) {
  Json request = base;
  request.update(question.members);
  const testing::Answer answer = ask(session, question.name, request);
  CHECK_MESSAGE(answer.status == 200, answer.json.dump());
  return timeless(answer.json);
}

Json fresh_answer(const Question& question, const Json& request) {
  viewer::Session session({file, {}, Json::object()});
  return answer_to(session, question, request);
}

/// Replaces the recording of waves: the only lane shows the options of the request.
struct Recorder {
  int count = 0;

  std::string operator()(const isa::Program& program, std::span<const std::string> options) {
    ++count;
    std::string label = std::to_string(program.shape.width);
    for (const std::string& option : options) label += " " + option;
    return fmt::format(
        R"({{"traceEvents":[{{"ph":"M","name":"process_name","pid":1,"tid":0,"args":{{"name":"host"}}}},
{{"ph":"M","name":"thread_name","pid":1,"tid":1,"args":{{"name":"state"}}}},
{{"ph":"X","name":"{}","pid":1,"tid":1,"args":{{"clock":0,"clocks":100}}}}]}})",
        label);
  }
};

/// Text of the only lane.
std::string lane_in(const testing::Answer& answer) {
  REQUIRE_MESSAGE(answer.status == 200, answer.json.dump());
  return answer.json["lanes"][0]["stretches"][0][2];
}

}  // namespace

TEST_CASE("a session answers each request after any change as a new session does") {
  for (const Question& question : questions()) {
    const Json plain{{"knobs", small}};
    const Json expected = fresh_answer(question, plain);
    viewer::Session session({file, {}, Json::object()});
    for (const Json& changed : changes()) {
      const std::string label = fmt::format("{} {}", question.name, changed.dump());
      CAPTURE(label);
      CHECK(answer_to(session, question, plain) == expected);
      CHECK(answer_to(session, question, changed) == fresh_answer(question, changed));
      CHECK(answer_to(session, question, plain) == expected);
    }
  }
}

TEST_CASE("each of the tested changes affects the instructions or the picture") {
  const Json plain{{"knobs", small}};
  for (const Json& changed : changes()) {
    const std::string label = changed.dump();
    CAPTURE(label);
    const bool is_same = fresh_answer({"draw"}, plain)["picture"] == fresh_answer({"draw"}, changed)["picture"] &&
                         fresh_answer({"draw"}, plain)["stats"] == fresh_answer({"draw"}, changed)["stats"];
    CHECK_FALSE(is_same);
  }
}

TEST_CASE("a rewritten model file is drawn again") {
  const std::filesystem::path model =
      std::filesystem::temp_directory_path() / ("csgsim-session-" + std::to_string(::getpid()) + ".csg");
  const auto write = [&](const char* text) { std::ofstream(model) << text; };
  write("cube(size=[9,9,9],center=true);");
  viewer::Session session({model, {}, Json::object()});
  const auto primitives = [&] { return ask(session, "tree", {{"knobs", small}}).json["tree"].size(); };
  CHECK(primitives() == 1);
  write("cube(size=[9,9,9],center=true);sphere(r=6);");
  CHECK(primitives() == 3);
  std::filesystem::remove(model);
}

TEST_CASE("a session records the frame's lanes once and a pixel's lanes for each request") {
  Recorder recorder;
  viewer::Session session({file, {}, Json::object()}, {.recorder = std::ref(recorder)});
  const Json frame{{"knobs", small}};
  const Json pixel{{"knobs", small}, {"pixel", "3,4"}, {"window", "i2:i4"}};
  const Json other{{"knobs", small}, {"pixel", "4,4"}, {"window", "i2:i4"}};
  const Json probed{{"knobs", small}, {"pixel", "3,4"}, {"window", "i2:i4"}, {"probes", {"tree.x:0"}}};
  for (int i = 0; i < 2; ++i) {
    CHECK(lane_in(ask(session, "lanes", pixel)) == "40 --pixel=3,4 --window=i2:i4 --lanes");
    CHECK(lane_in(ask(session, "lanes", frame)) == "40 --lanes");
    CHECK(lane_in(ask(session, "lanes", other)) == "40 --pixel=4,4 --window=i2:i4 --lanes");
    CHECK(lane_in(ask(session, "lanes", probed)) == "40 --pixel=3,4 --window=i2:i4 --probe=tree.x:0 --lanes");
    CHECK(lane_in(ask(session, "lanes", frame)) == "40 --lanes");
  }
  // The frame is recorded once, pixels each time.
  CHECK(recorder.count == 7);
  CHECK(ask(session, "wave", pixel).json["wave"].get<std::string>().find("--lanes") == std::string::npos);
}

TEST_CASE("the last two drawings keep their lanes and a third is recorded again") {
  Recorder recorder;
  viewer::Session session({file, {}, Json::object()}, {.recorder = std::ref(recorder)});
  const auto recordings_of = [&](const char* width) {
    const int before = recorder.count;
    const Json request{{"knobs", {{"size", std::string(width) + "x30"}}}};
    CHECK(lane_in(ask(session, "lanes", request)) == std::string(width) + " --lanes");
    return recorder.count - before;
  };
  CHECK(recordings_of("40") == 1);
  CHECK(recordings_of("41") == 1);
  CHECK(recordings_of("40") == 0);
  CHECK(recordings_of("41") == 0);
  CHECK(recordings_of("40") == 0);
  CHECK(recordings_of("42") == 1);
  CHECK(recordings_of("40") == 0);  // 41 was requested longer ago
  CHECK(recordings_of("41") == 1);
}

TEST_CASE("a part of the lanes states the first and last clock of the whole") {
  Recorder recorder;
  viewer::Session session({file, {}, Json::object()}, {.recorder = std::ref(recorder)});
  const Json part = ask(session, "lanes", {{"knobs", small}, {"begin", 10}, {"end", 30}}).json;
  CHECK(part["first"] == 0);
  CHECK(part["last"] == 100);
  CHECK(part["begin"] == 10);
  CHECK(part["end"] == 30);
  CHECK(part["lanes"][0]["stretches"][0][0] == 10);
  CHECK(part["lanes"][0]["stretches"][0][1] == 20);
  const Json whole = ask(session, "lanes", {{"knobs", small}}).json;
  CHECK(whole["begin"] == 0);
  CHECK(whole["end"] == 100);
  CHECK(recorder.count == 1);
}

TEST_CASE("two drawings are compared again when either changes") {
  viewer::Session session({file, {}, Json::object()});
  const Json plain{{"knobs", small}};
  const auto pixels = [&](const Json& a, const Json& b) {
    return ask(session, "two", {{"a", a}, {"b", b}}).json["pixels"];
  };
  const Json coarse = with("z-bits", "6");
  const Json cued = with("set", {"effects.depth_cue.on=true"});
  viewer::Session fresh({file, {}, Json::object()});
  const Json with_coarse = ask(fresh, "two", {{"a", plain}, {"b", coarse}}).json["pixels"];
  CHECK(pixels(plain, cued) > 100);
  CHECK(pixels(plain, coarse) == with_coarse);
  CHECK(pixels(plain, plain) == 0);
  CHECK(pixels(cued, cued) == 0);
  CHECK(pixels(cued, plain) > 100);
}
