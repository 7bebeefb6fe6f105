#include "sim/session/run/explain.h"

#include "sim/session/model/compiled_model.h"
#include "tests/support/test.h"
#include "tests/unit/session/parsed.h"

using namespace csgsim;
using session::ExplainRequest;
using testing::Parsed;
using testing::Texts;
using testing::usage_error_of;

namespace {

const std::string box = "cube(size=[8,6,4],center=true);";
const session::ContentReplacement box_in_place{.text = box};

/// A view along y from 50 in front of the centre: 33 x 25 pixels, with the origin at the middle one, 16,12. The view of
/// 22.5 degrees is 2 * 50 * tan 11.25 deg = 19.891 high there, so a unit is 1.2568 pixels.
Texts seen(const Texts& more) {
  Texts words{"box.csg", "--size", "33x25", "--camera", "0,-50,0,0,0,0"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

story::PixelExplanation explanation(const Texts& words, const session::ContentReplacement& in_place = box_in_place) {
  const Parsed<ExplainRequest> parsed(words);
  return session::explain(parsed.options, parsed.list, in_place);
}

std::string misuse(const Texts& words, const session::ContentReplacement& in_place = {}) {
  const Parsed<ExplainRequest> parsed(words);
  return usage_error_of([&] { session::refuse_misuse(parsed.options, parsed.list, in_place); });
}

std::string point_error(const Texts& words) {
  return usage_error_of([&] { static_cast<void>(explanation(words)); });
}

/// The box compiled for a machine.
isa::Program compiled_box(const std::string& machine) {
  const session::ModelRequest options =
      session::parse_model_request(seen({"--machine", machine, "--fraction-bits", "10"}));
  const machines::Machine built = session::machine_of(options);
  return session::compile_model(session::read_model_file(options, box), session::choices_of(options, built), built)
      .program;
}

}  // namespace

TEST_CASE("explain takes a pixel or a point of a model but only a pixel of a Program") {
  const std::string which = "explain: name a pixel with --pixel x,y or --point X,Y,Z";
  CHECK(misuse({"a.csg"}) == which);
  CHECK(misuse({"a.csgt"}) == which);
  CHECK(misuse({"a.csg", "--pixel", "1,1"}) == "");
  CHECK(misuse({"a.csg", "--point", "1,1,1"}) == "");
  CHECK(misuse({"a.csgt", "--pixel", "1,1"}) == "");
  CHECK(misuse({"a.csgt", "--point", "1,1,1"}) ==
        "--point: is for models; a Program does not record its camera: take --pixel");
  Parsed<ExplainRequest> both({"a.csg", "--pixel", "1,1"});
  both.options.point = "1,1,1";
  CHECK(usage_error_of([&] { session::refuse_misuse(both.options, both.list); }) == which);
  CHECK(testing::option_error<ExplainRequest>({"a.csg", "--pixel", "1,1", "--point", "1,1,1"}) != "");
  CHECK(testing::option_error<ExplainRequest>({"a.csg", "--pixel", "1,1", "--why-not", ""}) != "");
}

TEST_CASE("explain takes run options for a Program and every compile option for a model") {
  const auto with = [&](const char* file, const Texts& more) {
    Texts words{file, "--pixel", "1,1"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const isa::Program program;
  const session::ContentReplacement a_program{.text = {}, .program = &program};
  const session::ContentReplacement a_text{.text = box};
  const Texts compiling{"--z-bits", "12"};
  CHECK(misuse(with("a.csg", compiling)) == "");
  CHECK(misuse(with("a.csgt", compiling)).find("--z-bits") != std::string::npos);
  // The in-place content decides, not the file's name.
  CHECK(misuse(with("a.csgt", compiling), a_text) == "");
  CHECK(misuse(with("a.csg", compiling), a_program).find("--z-bits") != std::string::npos);
  for (const Texts& more :
       {Texts{"--machine", "pixel-planes-4"}, Texts{"--set", "alu.bits=4"}, Texts{"--why-not", "0"}})
    CHECK(misuse(with("a.csgt", more)) == "");
  CHECK(misuse(with("a.csgt", {"--view-all"})) != "");
}

TEST_CASE("explain shows a point of the model as its pixel with the distance from the eye") {
  struct Row {
    const char* point;
    const char* pixel;
    const char* distance;
  };
  // 16 + 1.2568 X and 12 - 1.2568 Z, rounded; the eye is 50 in front of the origin.
  for (const Row& row : {Row{"0,-3,0", "16,12", "47"}, Row{"1,2,-3", "17,16", "52"},
                         Row{"-3.5,0.25,1.5", "12,10", "50.25"}, Row{"0,-60,0", "16,12", "-10"}}) {
    CAPTURE(row.point);
    const story::PixelExplanation of_point = explanation(seen({"--point", row.point}));
    const story::PixelExplanation of_pixel = explanation(seen({"--pixel", row.pixel}));
    CHECK(of_point.text == std::string("point ") + row.point + " is " + row.distance +
                               " model units in front of the eye, along the view axis\n" + of_pixel.text);
    CHECK(of_point.json["point_distance"].get<double>() == doctest::Approx(std::stod(row.distance)));
    nlohmann::ordered_json rest = of_point.json;
    rest.erase("point_distance");
    CHECK(rest == of_pixel.json);
    CHECK_FALSE(of_pixel.json.contains("point_distance"));
  }
}

TEST_CASE("explain accepts a point in the outermost pixels and rejects one beyond them") {
  // Half a pixel beyond the outer ones: 16.5 / 1.2568 = 13.128 to either side, 12.5 / 1.2568 = 9.946 up and down.
  for (const char* const point : {"-13.1,0,0", "13.1,0,0", "0,0,9.9", "0,0,-9.9", "-13.1,0,9.9", "13.1,0,-9.9"})
    CHECK(point_error(seen({"--point", point})) == "");
  for (const char* const point : {"-13.2,0,0", "13.2,0,0", "0,0,10", "0,0,-10"})
    CHECK(point_error(seen({"--point", point})).find(" is outside the picture of 33 x 25, at column ") !=
          std::string::npos);
  CHECK(point_error(seen({"--point", "13.2,-3,1"})) ==
        "--point: 13.2,-3,1 is outside the picture of 33 x 25, at column 32.6 and row 10.7; move the camera, or take "
        "--view-all");
}

TEST_CASE("explain rejects a point behind the eye in perspective") {
  const auto error = [](const char* point) {
    return point_error(seen({"--projection", "perspective", "--point", point}));
  };
  for (const char* const point : {"0,-50,0", "0,-50.01,0", "0,-90,0"})
    CHECK(error(point) == std::string("--point: ") + point + " is behind the eye; take another point or camera");
  for (const char* const point : {"0,-49.9,0", "0,-49.5,0", "0,0,0", "0,90,0"}) CHECK(error(point) == "");
}

TEST_CASE("explain rejects a point that is not three numbers") {
  for (const char* const point : {"1", "1,2", "1,2,3,4", "1,2,x", "1;2;3"})
    CHECK(point_error(seen({"--point", point})).starts_with("--point"));
}

TEST_CASE("explain reports why a primitive is not seen on request") {
  CHECK(explanation(seen({"--pixel", "3,3"})).text.find("why not") == std::string::npos);
  CHECK(explanation(seen({"--pixel", "3,3", "--why-not", "0"})).text.starts_with("why not p0 "));
  CHECK(point_error(seen({"--pixel", "3,3", "--why-not", "p7"})).starts_with("--why-not"));
  CHECK(point_error(seen({"--pixel", "33,0"})) != "");
  CHECK(point_error(seen({"--pixel", "0,25"})) != "");
}

TEST_CASE("explain names half-spaces only for a model and runs a Program on its own machine") {
  const isa::Program program = compiled_box("pixel-planes-4");
  const session::ContentReplacement in_place{.text = {}, .program = &program};
  const story::PixelExplanation of_program = explanation({"box.csgt", "--pixel", "16,12"}, in_place);
  const story::PixelExplanation of_model = explanation(seen({"--pixel", "16,12", "--fraction-bits", "10"}));
  CHECK(of_model.text.find("half-space 3 of 6") != std::string::npos);
  CHECK(of_program.text.find("half-space 3 of 6") == std::string::npos);
  CHECK(of_program.text.find("p0 cube") != std::string::npos);
  CHECK(of_program.json["owner"] == of_model.json["owner"]);
  // The recorded machine, or figures set by the user: an ALU of four bits takes fewer clocks than one.
  const auto clocks = [&](const isa::Program& of, const Texts& more) {
    Texts words{"box.csgt", "--pixel", "16,12"};
    words.insert(words.end(), more.begin(), more.end());
    const story::PixelExplanation answer = explanation(words, {.text = {}, .program = &of});
    return answer.json["events"].back()["clocks"][1].get<std::uint64_t>();
  };
  CHECK(clocks(program, {"--machine", "pixel-planes-4"}) == clocks(program, {}));
  CHECK(clocks(program, {"--set", "alu.bits=4"}) < clocks(program, {}));
  CHECK(clocks(program, {"--machine", "pixel-planes-4+alu.bits=4"}) == clocks(program, {"--set", "alu.bits=4"}));
  // A Program for another kind runs on that kind by default and not on the default machine for models.
  const isa::Program lines = compiled_box("scan-line");
  CHECK(explanation({"box.csgt", "--pixel", "16,12"}, {.text = {}, .program = &lines}).json["owner"] ==
        of_model.json["owner"]);
  const Parsed<ExplainRequest> other({"box.csgt", "--pixel", "16,12", "--machine", "pixel-planes-4"});
  CHECK(testing::error_of([&] {
          static_cast<void>(session::explain(other.options, other.list, {.text = {}, .program = &lines}));
        }) != "");
  CHECK(usage_error_of([&] {
          const Parsed<ExplainRequest> set({"box.csgt", "--pixel", "16,12", "--set", "effects.depth_cue.on=true"});
          static_cast<void>(session::explain(set.options, set.list, in_place));
        }) != "");
}