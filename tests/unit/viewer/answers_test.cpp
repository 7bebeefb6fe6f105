// Tests of a session's answers to the requests that other files do not cover: for a box, against figures calculated by
// hand; and of cancellation and time limits.

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "hw/base/interruption.h"
#include "hw/kinds/load.h"
#include "places.h"
#include "sim/report/codec.h"
#include "sim/session/model/model_request.h"
#include "sim/viewer/drawings.h"
#include "sim/viewer/evaluations.h"
#include "sim/viewer/knobs.h"
#include "sim/viewer/session.h"
#include "tests/support/test.h"
#include "tests/unit/viewer/asked.h"

using namespace csgsim;
using testing::Answer;
using testing::ask;
using viewer::Json;

namespace {

const std::string figure = CSGSIM_SOURCE_DIR "/tests/models/thesis_fig_2_3.csg";

/// A view along y from 50 in front: 33 x 25 pixels, with 1.2568 pixels per unit: 25 / (2 * 50 * tan 11.25 deg). A box
/// of 8 x 6 x 4 about the origin covers columns 16 - 5.03 to 16 + 5.03 and rows 12 - 2.51 to 12 + 2.51.
const Json front{{"size", "33x25"}, {"camera", "0,-50,0,0,0,0"}};
const std::string box = "cube(size=[8,6,4],center=true);";

/// Moved along x and z.
std::string moved(const char* by, const std::string& what) {
  const std::string shift = by;
  const std::size_t comma = shift.find(',');
  return "multmatrix([[1,0,0," + shift.substr(0, comma) + "],[0,1,0,0],[0,0,1," + shift.substr(comma + 1) +
         "],[0,0,0,1]]){" + what + "}";
}

Json box_request(const std::string& source = box) { return {{"knobs", front}, {"source", source}}; }

viewer::Session figure_session(viewer::SessionOptions options = {}) {
  return viewer::Session({figure, {}, Json::object()}, std::move(options));
}

std::string as_text(const Answer& answer) { return std::to_string(answer.status) + " " + answer.json.dump(); }

/// Options with a recorder that calls `does` and answers "recorded".
viewer::SessionOptions recording(std::function<void()> does) {
  return {.recorder = [does = std::move(does)](const isa::Program&, std::span<const std::string>) {
    does();
    return std::string("recorded");
  }};
}

}  // namespace

TEST_CASE("the answer to draw has the picture's size and camera and command and duration") {
  viewer::Session session({figure, {"--fraction-bits", "10"}, Json::object()});
  const Json answer = ask(session, "draw", box_request()).json;
  CHECK(answer["width"] == 33);
  CHECK(answer["height"] == 25);
  CHECK(answer["camera"] == "0,-50,0,0,0,0");
  CHECK(answer["command"] == "csgsim render " + figure + " --fraction-bits 10 --size 33x25 --camera 0,-50,0,0,0,0");
  CHECK(answer["warnings"].empty());
  CHECK(answer["seconds"]["compiling"].get<double>() > 0);
  CHECK(answer["seconds"]["running"].get<double>() > 0);
  Json request = box_request();
  request["knobs"]["camera"] = "-1.5,-50,2,0.25,0,-3";
  request["knobs"]["snap"] = true;
  request["knobs"]["view-all"] = false;
  request["knobs"]["set"] = {"alu.bits=4", "background.colour=[0, 0, 1]"};
  const Json turned = ask(session, "draw", request).json;
  CHECK(turned["camera"] == "-1.5,-50,2,0.25,0,-3");
  CHECK(turned["command"] == "csgsim render " + figure +
                                 " --fraction-bits 10 --size 33x25 --camera=-1.5,-50,2,0.25,0,-3 --snap --set "
                                 "alu.bits=4 --set 'background.colour=[0, 0, 1]'");
}

TEST_CASE("comparing two pictures reports the pixels of a box that only one has") {
  viewer::Session session = figure_session();
  const Json nothing = box_request(moved("0,90", "cube(size=[1,1,1]);"));
  const auto two = [&](const Json& a, const Json& b) { return ask(session, "two", {{"a", a}, {"b", b}}); };
  const Answer found = two(box_request(), nothing);
  REQUIRE_MESSAGE(found.status == 200, as_text(found));
  CHECK(found.json["pixels"] == 11 * 5);  // columns 11 to 21, rows 10 to 14
  CHECK(found.json["first"] == Json{11, 10});
  CHECK(found.json["picture"].get<std::string>().starts_with("data:image/png;base64,iVBOR"));
  CHECK(found.json["instruction"]["number"].is_number_unsigned());
  const Answer same = two(box_request(), box_request());
  CHECK(same.json["pixels"] == 0);
  CHECK(same.json["first"].is_null());
  CHECK(same.json["instruction"].is_null());
  // One unit wider to the right, to 16 + 5 * 1.2568 = 22.3: one more column.
  const Answer wider = two(box_request(moved("0.5,0", "cube(size=[9,6,4],center=true);")), box_request());
  CHECK(wider.json["first"] == Json{22, 10});
  CHECK(wider.json["pixels"] == 5);
  // Different widths only, and different heights only.
  for (const char* const size : {"34x25", "33x26"}) {
    Json other = box_request();
    other["knobs"]["size"] = size;
    const std::string words = std::string(size).replace(2, 1, " x ");
    CHECK(two(box_request(), other).json["error"] ==
          "A is 33 x 25 pixels and B " + words + "; give both the same size");
  }
}

TEST_CASE("comparing two drawings reports the first different instruction with both texts") {
  viewer::Session session = figure_session();
  const Json plain = box_request();
  Json other = box_request();
  other["knobs"]["set"] = {"background.colour=[0, 0, 1]"};
  const Json difference = ask(session, "two", {{"a", plain}, {"b", other}}).json["instruction"];
  const auto number = difference["number"].get<std::uint64_t>();
  for (const char* const side : {"a", "b"}) {
    Json request = side == std::string("a") ? plain : other;
    request["number"] = number;
    const Json instant = ask(session, "instant", request).json;
    bool is_listed = false;
    for (const Json& one : instant["instructions"])
      is_listed = is_listed || (one["number"] == number && one["text"] == difference[side]);
    CHECK(is_listed);
  }
}

TEST_CASE("a request explains a pixel by its place and an unseen primitive by its index") {
  viewer::Session session = figure_session();
  Json request = box_request();
  request["pixel"] = "16,12";
  const Json seen = ask(session, "explain", request).json;
  CHECK(seen["text"].get<std::string>().starts_with("pixel 16,12 shows p0 "));
  CHECK(seen["text"].get<std::string>().find("half-space") != std::string::npos);
  CHECK(seen["story"]["pixel"] == Json{16, 12});
  request["pixel"] = "3,3";
  CHECK(ask(session, "explain", request).json["text"].get<std::string>().starts_with("pixel 3,3 shows nothing"));
  request["why_not"] = "p0";
  CHECK(ask(session, "explain", request).json["text"].get<std::string>().starts_with("why not p0 "));
  for (const char* const pixel : {"33,0", "0,25", "3", ""}) {
    request["pixel"] = pixel;
    CHECK(ask(session, "explain", request).status == 422);
  }
}

TEST_CASE("an instant is the start by default and has the drawn surface's active tree") {
  viewer::Session session = figure_session();
  const std::string source = "difference(){" + box + "sphere(r=3);}";
  const Json begin = ask(session, "instant", box_request(source)).json;
  CHECK(begin["number"] == 0);
  CHECK_FALSE(begin.contains("active"));
  Json request = box_request(source);
  request["primitive"] = 0;
  const Json cube = ask(session, "instant", request).json;
  REQUIRE(cube["active"].size() == 1);
  CHECK(cube["active"][0]["depth"] == 0);
  CHECK(cube["active"][0]["primitive"] == 1);
  CHECK(cube["active"][0]["complemented"] == true);
  request["primitive"] = 1;
  const Json sphere = ask(session, "instant", request).json;
  REQUIRE(sphere["active"].size() == 1);
  CHECK(sphere["active"][0]["primitive"] == 0);
  CHECK(sphere["active"][0]["complemented"] == false);
  request["primitive"] = 2;
  CHECK(ask(session, "instant", request).status == 422);
}

TEST_CASE("a verdict counts wrong pixels and advice lists settings to change") {
  viewer::Session session = figure_session();
  const Json verdict = ask(session, "verdict", box_request()).json;
  CHECK(verdict["accuracy"]["wrong"] == 0);
  CHECK(verdict["text"].get<std::string>().size() > 10);
  const Json advice = ask(session, "advice", box_request()).json;
  CHECK(advice["knobs"].is_array());
  CHECK(advice["knobs"].size() > 3);
}

TEST_CASE("the first answer to the page has the model and its options and the machines") {
  viewer::Session session({figure, {}, {{"size", "40x30"}}});
  const viewer::Reply reply = session.answer({.method = "GET"}, "about");
  CHECK(reply.status == 200);
  CHECK(reply.type == "application/json");
  const Json about = Json::parse(reply.body);
  CHECK(about["model"] == figure);
  std::ifstream file(figure);
  CHECK(about["source"] == std::string(std::istreambuf_iterator<char>(file), {}));
  CHECK(about["knobs"] == Json{{"size", "40x30"}});
  CHECK(about["names"].size() == viewer::knobs.size());
  CHECK(about["machines"].size() == 9);
  CHECK(about["strategies"] == Json(session::strategy_names()));
  CHECK(about["evaluation_time"] == 10);
  CHECK(about["usual"] == Json{{"machine", "pixel-planes-4"}, {"strategy", "stack"}, {"z-bits", 20}});
  const auto machines = [](const char* begun_with) {
    viewer::Session begun({figure, {}, {{"machine", begun_with}}});
    return Json::parse(begun.answer({.method = "GET"}, "about").body)["machines"];
  };
  // A machine of csgsim's list is not repeated; any other machine precedes the list.
  CHECK(machines("scan-line") == about["machines"]);
  const Json more = machines("pixel-planes-4+alu.bits=2");
  CHECK(more.size() == 10);
  CHECK(more[0] == "pixel-planes-4+alu.bits=2");
}

TEST_CASE("the report shows the last drawing and is rejected before the first") {
  viewer::Session session = figure_session();
  CHECK(session.answer({.method = "GET"}, "report").status == 400);
  CHECK(ask(session, "tree", box_request()).status == 200);
  const viewer::Reply compiled = session.answer({.method = "GET"}, "report");
  CHECK(compiled.status == 400);
  CHECK(Json::parse(compiled.body)["error"] == "nothing has been drawn yet");
  CHECK(ask(session, "draw", box_request()).status == 200);
  const viewer::Reply report = session.answer({.method = "GET"}, "report");
  CHECK(report.status == 200);
  CHECK(report.type == "text/html; charset=utf-8");
  CHECK(report.has_scripts);
  CHECK(report.body.find("--size 33x25") != std::string::npos);
}

TEST_CASE("only a message that starts with a place in the model has a line and column") {
  viewer::Session session = figure_session();
  const auto place = [&](const std::string& source) {
    const Answer answer = ask(session, "draw", box_request(source));
    CHECK(answer.status == 422);
    return std::pair(answer.json.value("line", 0), answer.json.value("column", 0));
  };
  using Place = std::pair<int, int>;
  CHECK(place("cube(size=;") == Place{1, 11});
  CHECK(place("cube(1);\n\n  sphere(r=;") == Place{3, 12});
  CHECK(place(std::string(11, '\n') + std::string(20, ' ') + "sphere(r=;") == Place{12, 30});
  Json request = box_request();
  request["knobs"]["size"] = "0x8";
  const Answer other = ask(session, "draw", request);
  CHECK(other.status == 422);
  CHECK_FALSE(other.json.contains("line"));
  CHECK_FALSE(other.json.contains("column"));
}

TEST_CASE("a request must be an object with limited nesting and number of values") {
  viewer::Session session = figure_session();
  const auto status = [&](const std::string& body) {
    return session.answer({.method = "POST", .body = body}, "tree").status;
  };
  const auto nested = [](int arrays) {
    return "{\"x\":" + std::string(static_cast<std::size_t>(arrays), '[') +
           std::string(static_cast<std::size_t>(arrays), ']') + "}";
  };
  CHECK(status(nested(15)) == 200);
  CHECK(status(nested(16)) == 400);
  const auto values = [](int numbers) {
    std::string text = "{\"x\":[0";
    for (int i = 1; i < numbers; ++i) text += ",0";
    return text + "]}";
  };
  // The object, its key and the array are three.
  CHECK(status(values(9'997)) == 200);
  CHECK(status(values(9'998)) == 400);
  CHECK(status("[]") == 400);
  CHECK(status("{") == 400);
}

TEST_CASE("the answer to a rejected request states its error") {
  viewer::Session session({figure, {}, {{"machine", "own.toml"}}});
  const auto error = [&](const Json& knobs) {
    const Answer answer = ask(session, "tree", {{"knobs", knobs}});
    return std::to_string(answer.status) + " " + answer.json.value("error", "");
  };
  CHECK(error({{"scene", "x"}}) == "400 there is no setting 'scene'");
  CHECK(error({{"size", 3}}) == "400 size must be a string");
  CHECK(error({{"set", "x"}}) == "400 set must be an array of strings");
  CHECK(error({{"set", {1}}}) == "400 set must be a string");
  CHECK(error({{"machine", "other.toml"}}) ==
        "400 machine: other.toml is a file; start csgsim view with --machine other.toml");
  CHECK(error({{"machine", "other.toml+alu.bits=2"}}).starts_with("400 "));
  // The machine that the session started with is read if it exists.
  CHECK(error({{"machine", "own.toml"}}).starts_with("422 "));
  CHECK(error({{"machine", "own.toml+alu.bits=2"}}).starts_with("422 "));
  CHECK(error({{"machine", "pixel-planes-4"}}) == "200 ");
  CHECK(testing::error_of([] { const viewer::Session none({"/nosuch.csg", {}, Json::object()}); }) != "");
}

TEST_CASE("a wave request cancelled by its name reports the cancellation") {
  viewer::Session* running = nullptr;
  Json progress;
  viewer::Session session = figure_session(recording([&] {
    progress = ask(*running, "progress", {{"evaluation", "mine"}}).json;
    CHECK(ask(*running, "cancel", {{"evaluation", "other"}}).json == Json::object());
    throw_if_interrupted();
    CHECK(ask(*running, "cancel", {{"evaluation", "mine"}}).status == 200);
    throw_if_interrupted();
  }));
  running = &session;
  Json request = box_request();
  request["evaluation"] = "mine";
  const Answer cancelled = ask(session, "wave", request);
  CHECK(cancelled.status == 422);
  CHECK(cancelled.json == Json{{"error", figure + ": cancelled"}, {"cancelled", true}});
  CHECK(progress["doing"] == "drawing");
  CHECK(progress["seconds"].get<double>() >= 0);
  // The evaluation has ended and left nothing behind.
  CHECK(ask(session, "progress", {{"evaluation", "mine"}}).json == Json::object());
}

TEST_CASE("a closed session cancels pending and later requests") {
  viewer::Session* running = nullptr;
  viewer::Session session = figure_session(recording([&] {
    running->close();
    throw_if_interrupted();
  }));
  running = &session;
  for (int i = 0; i < 2; ++i) {
    const Answer answer = ask(session, "wave", box_request());
    CHECK(answer.status == 503);
    CHECK(answer.json == Json{{"error", "csgsim view is stopping"}});
  }
}

TEST_CASE("a model whose evaluation exceeds the time limit is rejected") {
  viewer::Session session = figure_session({.evaluation_time = std::chrono::milliseconds(1500)});
  CHECK(Json::parse(session.answer({.method = "GET"}, "about").body)["evaluation_time"] == 1.5);
  viewer::Session limited({CSGSIM_SOURCE_DIR "/tests/models/carburettor.csg", {}, Json::object()},
                          {.evaluation_time = std::chrono::milliseconds(0)});
  std::atomic<bool> is_done = false;
  std::thread watch([&] {
    while (!is_done) limited.end_overdue();
  });
  // Seconds of work, so that the other thread runs before the end.
  std::string slow;
  for (int i = 0; i < 2000; ++i)
    slow += fmt::format("multmatrix([[1,0,0,{}],[0,1,0,{}],[0,0,1,0],[0,0,0,1]]) {{ sphere(r=3,$fn=60); }}\n", i % 50,
                        i / 50);
  const Answer late = ask(limited, "draw", Json{{"source", "difference() { cube(100);\n" + slow + "}"}});
  is_done = true;
  watch.join();
  CHECK(late.status == 422);
  CHECK(late.json == Json{{"error", CSGSIM_SOURCE_DIR
                           "/tests/models/carburettor.csg: evaluating it takes longer than 0 s; simplify the "
                           "model, or start csgsim view with a longer --evaluation-time SECONDS"}});
}

TEST_CASE("a recording passes the pixel and the window and any probes to csgsim wave") {
  std::vector<std::string> words;
  viewer::SessionOptions options;
  options.recorder = [&](const isa::Program&, std::span<const std::string> all) {
    words.assign(all.begin(), all.end());
    return std::string("recorded");
  };
  viewer::Session session = figure_session(std::move(options));
  Json request = box_request();
  CHECK(ask(session, "wave", request).json == Json{{"wave", "recorded"}});
  CHECK(words.empty());
  request["window"] = "i1:i2";
  ask(session, "wave", request);
  CHECK(words == std::vector<std::string>{"--window=i1:i2"});
  request["pixel"] = "1,2";
  request["probes"] = {"a", "b"};
  ask(session, "wave", request);
  CHECK(words == std::vector<std::string>{"--pixel=1,2", "--window=i1:i2", "--probe=a", "--probe=b"});
}

TEST_CASE("a drawing requested several times at once is evaluated once") {
  viewer::Drawings drawings({CSGSIM_SOURCE_DIR "/tests/models/carburettor.csg", {}, Json::object()});
  CHECK(drawings.latest() == nullptr);
  viewer::Evaluations evaluations(std::chrono::hours(1));
  const Json request{{"knobs", {{"size", "64x64"}}}};
  constexpr std::size_t count = 4;
  std::atomic<std::size_t> waiting = 0;
  std::vector<std::shared_ptr<viewer::Drawing>> drawn(count);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < count; ++i) {
    threads.emplace_back([&, i] {
      viewer::Evaluation evaluation(evaluations, "");
      ++waiting;
      while (waiting < count) std::this_thread::yield();
      drawn[i] = drawings.draw(request, evaluation);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::shared_ptr<viewer::Drawing>& one : drawn) CHECK(one == drawn[0]);
  CHECK(drawings.latest() == drawn[0]);
  viewer::Evaluation evaluation(evaluations, "");
  const std::shared_ptr<viewer::Drawing> other = drawings.compile(box_request(), evaluation);
  CHECK(other != drawn[0]);
  CHECK_FALSE(other->found->drawn);
  CHECK(drawings.latest() == other);
  CHECK(drawings.compile(request, evaluation) == drawn[0]);
  CHECK(drawings.latest() == drawn[0]);
  CHECK(drawings.draw(box_request(), evaluation) == other);
  CHECK(other->found->drawn);
}
