#include "sim/viewer/session.h"

#include <nlohmann/json.hpp>

#include "places.h"
#include "sim/observe/stats_json.h"
#include "sim/report/codec.h"
#include "sim/report/page.h"
#include "sim/report/pictures.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/model_request.h"
#include "sim/session/run/run_request.h"
#include "tests/support/test.h"
#include "tests/unit/viewer/asked.h"

using namespace csgsim;
using testing::Answer;
using testing::ask;
using viewer::Json;

namespace {

const std::string file = CSGSIM_SOURCE_DIR "/tests/models/thesis_fig_2_3.csg";

viewer::Session session(Json knobs = Json::object()) { return viewer::Session({file, {}, std::move(knobs)}); }

/// Returns the drawing of this command line.
Json drawn_by(const std::vector<std::string>& words) {
  const session::ModelRequest options = session::parse_model_request(words);
  const machines::Machine machine = session::machine_of(options);
  const session::CompiledModel compiled = session::compile_model(options, machine);
  const session::DrawnRun drawn = session::draw(compiled.program, machine);
  const observe::Report report{compiled.program, machine, "functional", drawn.result, drawn.stats};
  return {{"picture",
           "data:image/png;base64," + report::base64(report::picture_of(drawn.frame, compiled.program, "", "").png)},
          {"stats", report::without_wall_times(observe::to_json(report))}};
}

void check_drawn(const Answer& answer, const std::vector<std::string>& words) {
  REQUIRE(answer.status == 200);
  const Json expected = drawn_by(words);
  CHECK(answer.json["picture"] == expected["picture"]);
  CHECK(answer.json["stats"] == expected["stats"]);
}

}  // namespace

TEST_CASE("a request is drawn like the equivalent command line whatever came before") {
  viewer::Session drawing = session();
  const std::vector<std::string> size{"--size", "40x30"};
  const std::vector<std::pair<Json, std::vector<std::string>>> rows{
      {{{"camera", "30,-40,25,0,0,2"}}, {"--camera", "30,-40,25,0,0,2"}},
      {{{"camera", "-30,40,25,0,0,2"}}, {"--camera=-30,40,25,0,0,2"}},
      {{{"machine", "pixel-square"}, {"projection", "perspective"}},
       {"--machine", "pixel-square", "--projection", "perspective"}},
      {{{"machine", "pixel-powers"}}, {"--machine", "pixel-powers"}},
      {{{"machine", "pixel-powers"}, {"camera", "3,-10,9,0,0,2"}},
       {"--machine", "pixel-powers", "--camera", "3,-10,9,0,0,2"}},
      {{{"set", {"alu.bits=4", "effects.depth_cue.on=true"}}},
       {"--set", "alu.bits=4", "--set", "effects.depth_cue.on=true"}},
      {{{"tolerance", "0.5px"}, {"camera", "30,-40,25,0,0,2"}},
       {"--tolerance", "0.5px", "--camera", "30,-40,25,0,0,2"}},
      {{{"tolerance", "0.5px"}, {"camera", "300,-400,250,0,0,2"}},
       {"--tolerance", "0.5px", "--camera", "300,-400,250,0,0,2"}},
      {Json::object(), {}}};
  for (const auto& [knobs, words] : rows) {
    const std::string label = knobs.dump();
    CAPTURE(label);
    Json all = knobs;
    all["size"] = "40x30";
    std::vector<std::string> line{file};
    line.insert(line.end(), size.begin(), size.end());
    line.insert(line.end(), words.begin(), words.end());
    check_drawn(ask(drawing, "draw", {{"knobs", all}}), line);
  }
}

TEST_CASE("an edited source replaces the file and errors have their place in it") {
  viewer::Session drawing = session({{"size", "32x24"}});
  const Answer cube = ask(drawing, "draw", {{"source", "cube(size=[1,2,3],center=true);"}});
  REQUIRE(cube.status == 200);
  CHECK(cube.json["stats"]["model"]["primitives"] == 1);
  const Answer wrong = ask(drawing, "draw", {{"source", "cube(size=[1,2,3],center=true);\n  cube(size=;"}});
  CHECK(wrong.status == 422);
  CHECK(wrong.json["line"] == 2);
  CHECK(wrong.json["error"].get<std::string>().starts_with(file + ":2:"));
  CHECK(ask(drawing, "draw", Json::object()).json["stats"]["model"]["primitives"] > 1);
}

TEST_CASE("the answer to draw contains each warning about the model") {
  viewer::Session drawing = session();
  const Answer empty =
      ask(drawing, "draw", {{"source", "import(file=\"there_is_none.stl\");cube(size=[1,2,3],center=true);"}});
  REQUIRE(empty.status == 200);
  REQUIRE(empty.json["warnings"].size() == 1);
  CHECK(empty.json["warnings"][0].get<std::string>().find("there_is_none.stl") != std::string::npos);
}

TEST_CASE("malformed requests get 400 and undrawable models 422 and unknown requests 404") {
  viewer::Session drawing = session();
  for (const char* body : {"", "{", "[]", "3", R"({"knobs":[]})", R"({"knobs":{"size":3}})", R"({"knobs":{"set":"x"}})",
                           R"({"source":1})", R"({"knobs":{"scene":"x"}})", R"({"knobs":{"machine":"x.toml"}})"})
    CHECK(drawing.answer({.method = "POST", .body = body}, "draw").status == 400);
  for (const char* body :
       {R"({"knobs":{"size":"0x0"}})", R"({"knobs":{"machine":"none"}})", R"({"knobs":{"z-bits":"x"}})",
        R"({"knobs":{"size":"8x8\u0000x9"}})", R"({"knobs":{"set":["link.width=8\u0000"]}})"})
    CHECK(drawing.answer({.method = "POST", .body = body}, "draw").status == 422);
  CHECK(drawing.answer({.method = "POST", .body = R"({"pixel":"1"})"}, "explain").status == 422);
  CHECK(drawing.answer({.method = "POST", .body = "{}"}, "paint").status == 404);
  CHECK(drawing.answer({.method = "GET"}, "draw").status == 404);
  CHECK(drawing.answer({.method = "GET"}, "report").status == 400);
}

TEST_CASE("two drawings are compared by pixels and by their first different instruction") {
  viewer::Session drawing = session({{"size", "40x30"}, {"camera", "30,-40,25,0,0,2"}});
  const auto two = [&](const Json& a, const Json& b) { return ask(drawing, "two", {{"a", a}, {"b", b}}); };
  const auto with = [](const char* name, const char* value) { return Json{{"knobs", {{name, value}}}}; };
  const Json plain = Json::object();
  const Answer same = two(plain, plain);
  CHECK(same.status == 200);
  CHECK(same.json["pixels"] == 0);
  CHECK(same.json["instruction"].is_null());
  const Answer unpruned = two(plain, with("pruning", "none"));
  CHECK(unpruned.json["pixels"] == 0);
  REQUIRE(unpruned.json["instruction"].is_object());
  CHECK(unpruned.json["instruction"]["a"] != unpruned.json["instruction"]["b"]);
  const Json cube{{"source", "cube(size=[4,4,4],center=true);"}};
  const Answer models = two(plain, cube);
  CHECK(models.json["pixels"] > 0);
  CHECK(models.json["picture"] != same.json["picture"]);
  CHECK(models.json["pixels"] == two(cube, plain).json["pixels"]);
  CHECK(two(plain, with("size", "41x30")).status == 422);
  CHECK(two(3, plain).status == 400);
}
