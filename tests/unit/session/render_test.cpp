#include "sim/session/run/render.h"

#include <unistd.h>

#include <nlohmann/json.hpp>

#include "hw/base/messages.h"
#include "hw/isa/facts.h"
#include "places.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/run/run_request.h"
#include "sim/studies/accuracy/choose_bits.h"
#include "tests/support/captured.h"
#include "tests/support/test.h"
#include "tests/unit/session/parsed.h"

using namespace csgsim;
using session::RenderRequest;
using testing::Parsed;
using testing::Texts;

namespace {

const std::string house = CSGSIM_SOURCE_DIR "/tests/models/rietveld_house.csg";

Texts house_words(const Texts& more) {
  Texts words{house, "--size", "40x32", "--camera", "3430,-2900,1950,590,230,220"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Returns the judge's report on the picture that the options draw.
nlohmann::ordered_json judged(const RenderRequest& options, const session::Compiled& compiled) {
  nlohmann::ordered_json json;
  const session::Judge judge = session::make_judge(options, compiled);
  REQUIRE(judge);
  CHECK_FALSE(judge(session::draw(compiled.model.program, compiled.machine).frame, json).empty());
  return json;
}

}  // namespace

TEST_CASE("render accepts model and run and report options and --check and a pixel limit") {
  const Parsed<RenderRequest> plain({"a.csg"});
  CHECK(plain.options.model.model == "a.csg");
  CHECK_FALSE(plain.options.check);
  CHECK_FALSE(RenderRequest{}.check);
  CHECK_FALSE(plain.options.max_wrong_pixels);
  const Parsed<RenderRequest> all({"a.csg", "--check", "--max-wrong-pixels", "3", "--memory-bits", "96", "--stats",
                                   "s.json", "--report", "p.html"});
  CHECK(all.options.check);
  CHECK(all.options.max_wrong_pixels == 3);
  CHECK(all.options.model.memory_bits == 96);
  CHECK(all.options.run.stats == "s.json");
  const std::vector<session::GivenOption> given = all.list.given();
  CHECK(std::ranges::count(given, std::string("p.html"), &session::GivenOption::value) == 1);
  for (const char* const wrong : {"-1", "1.5", "x"})
    CHECK(testing::option_error<RenderRequest>({"a.csg", "--max-wrong-pixels", wrong}) != "");
}

TEST_CASE("a compiled model records its file and imports or its text in memory as inputs") {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("csgsim-render-" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  const std::string model = folder / "m.csg";
  std::ofstream stl(folder / "t.stl");
  stl << "solid t\n";
  for (const char* const corners :
       {"0 0 0,0 1 0,1 0 0", "0 0 0,1 0 0,0 0 1", "0 0 0,0 0 1,0 1 0", "1 0 0,0 1 0,0 0 1"}) {
    std::istringstream each(corners);
    stl << "facet normal 0 0 0\nouter loop\n";
    for (std::string corner; std::getline(each, corner, ',');) stl << "vertex " << corner << "\n";
    stl << "endloop\nendfacet\n";
  }
  stl << "endsolid t\n";
  stl.close();
  std::ofstream(model) << "cube(size=[8,6,4],center=true);\nimport(file=\"t.stl\");\n";
  Parsed<RenderRequest> parsed({model, "--size", "24x20", "--camera", "0,-50,0,0,0,0"});
  {
    const session::Compiled compiled = session::compile(parsed.options, studies::choose_bits);
    REQUIRE(compiled.inputs.size() == 2);
    CHECK(compiled.inputs[0] == model);
    CHECK(compiled.inputs[1].filename() == "t.stl");
    CHECK_FALSE(compiled.is_text);
    const session::RunSubject subject = compiled.subject(parsed.options);
    CHECK_FALSE(subject.is_in_place);
    CHECK(&subject.program == &compiled.model.program);
    CHECK(&subject.machine == &compiled.machine);
    CHECK(subject.hash == compiled.model.hash);
    CHECK(subject.camera == &compiled.model.camera);
  }
  const session::Compiled of_text = session::compile(parsed.options, studies::choose_bits, {.text = "sphere(r=3);"});
  CHECK(of_text.is_text);
  CHECK(of_text.subject(parsed.options).is_in_place);
  CHECK(of_text.inputs == std::vector<std::filesystem::path>{model});
  CHECK(of_text.model.program.facts->primitives.size() == 1);
  CHECK(of_text.machine.picture.width == 24);
  CHECK(of_text.machine.picture.height == 20);
  std::filesystem::remove_all(folder);
}

TEST_CASE("render --check compares with the exact picture and rejects transparency") {
  Parsed<RenderRequest> plain(house_words({}));
  const session::Compiled compiled = session::compile(plain.options, studies::choose_bits);
  CHECK_FALSE(session::make_judge(plain.options, compiled));
  Parsed<RenderRequest> checked(house_words({"--check", "--z-bits", "6"}));
  const nlohmann::ordered_json coarse =
      judged(checked.options, session::compile(checked.options, studies::choose_bits));
  Parsed<RenderRequest> fine(house_words({"--check"}));
  const nlohmann::ordered_json usual = judged(fine.options, session::compile(fine.options, studies::choose_bits));
  CHECK(coarse["wrong"].get<std::uint64_t>() > usual["wrong"].get<std::uint64_t>());
  const session::ContentReplacement glass{.text = "color([1,0,0,0.5]) { cube(size=[8,6,4],center=true); }"};
  for (const bool is_checked : {true, false}) {
    Parsed<RenderRequest> parsed({"glass.csg", "--size", "24x20", "--camera", "0,-50,0,0,0,0"});
    parsed.options.check = is_checked;
    const session::Compiled seen_through = session::compile(parsed.options, studies::choose_bits, glass);
    const std::string error =
        testing::error_of([&] { static_cast<void>(session::make_judge(parsed.options, seen_through)); });
    CHECK((error.find("supports opaque solids only") != std::string::npos) == is_checked);
  }
}

TEST_CASE("--max-wrong-pixels chooses the cheapest bits with at most that many wrong pixels") {
  const auto wrong_of = [](unsigned z_bits, unsigned fraction_bits) {
    Parsed<RenderRequest> parsed(
        house_words({"--check", "--z-bits", std::to_string(z_bits), "--fraction-bits", std::to_string(fraction_bits)}));
    return judged(parsed.options, session::compile(parsed.options, studies::choose_bits))["wrong"].get<std::uint64_t>();
  };
  unsigned last = 31;
  for (const char* const most : {"0", "10", "1280"}) {
    CAPTURE(most);
    Parsed<RenderRequest> parsed(house_words({"--max-wrong-pixels", most}));
    const testing::Captured output(STDOUT_FILENO);
    const session::Compiled compiled = session::compile(parsed.options, studies::choose_bits);
    const std::string bits = "--z-bits " + std::to_string(parsed.options.model.z_bits) + " --fraction-bits " +
                             std::to_string(parsed.options.model.fraction_bits);
    CHECK(output.text() == "chosen            " + bits + ": the cheapest with at most " + most + " wrong pixels\n");
    CHECK(wrong_of(parsed.options.model.z_bits, parsed.options.model.fraction_bits) <= std::stoul(most));
    // The compiled Program has these bits: the depth fields have the same width.
    for (const isa::NamedField& field : compiled.model.program.facts->fields) {
      if (field.name == "Z1") CHECK(field.field.width == parsed.options.model.z_bits);
    }
    // Allowing more wrong pixels needs fewer bits.
    CHECK(parsed.options.model.z_bits <= last);
    last = parsed.options.model.z_bits;
  }
  CHECK(last < 12);
  Parsed<RenderRequest> usual(house_words({}));
  static_cast<void>(session::compile(usual.options, studies::choose_bits));
  CHECK(usual.options.model.z_bits == 20);
  CHECK(usual.options.model.fraction_bits == 12);
  // Nothing fits 20 bits of memory.
  Parsed<RenderRequest> small(house_words({"--max-wrong-pixels", "5", "--memory-bits", "20"}));
  CHECK(testing::error_of([&] { static_cast<void>(session::compile(small.options, studies::choose_bits)); }) ==
        "every choice of --z-bits and --fraction-bits that fits the machine has more than 5 wrong pixels; allow more "
        "wrong pixels, or use csgsim accuracy to find their causes");
  Parsed<RenderRequest> glass({"glass.csg", "--size", "24x20", "--camera", "0,-50,0,0,0,0", "--max-wrong-pixels", "5"});
  CHECK(testing::error_of([&] {
          static_cast<void>(session::compile(glass.options, studies::choose_bits,
                                             {.text = "color([1,0,0,0.5]) { cube(size=[8,6,4],center=true); }"}));
        }).find("supports opaque solids only") != std::string::npos);
}

TEST_CASE("render --advice measures advice for the requested machine") {
  for (const bool is_asked : {false, true}) {
    Parsed<RenderRequest> parsed(house_words({"--machine", "pixel-planes-4+alu.bits=2"}));
    parsed.options.run.advice = is_asked;
    const session::Compiled compiled = session::compile(parsed.options, studies::choose_bits);
    const session::Advice advice = session::advice_of(parsed.options, compiled);
    CHECK(advice.machine == "pixel-planes-4+alu.bits=2");
    CHECK(advice.is_asked == is_asked);
    CHECK(advice.ask == "--advice tries machine parameters, settings and prunings");
    REQUIRE(advice.commands.size() == 1);
    if (!is_asked) continue;
    const session::DrawnRun drawn = session::draw(compiled.model.program, compiled.machine);
    CHECK(advice.settings(drawn.result).size() > 0);
  }
}

TEST_CASE("render warns of nearly coplanar faces") {
  const auto warnings = [](const char* text) {
    const CollectedLines kept;
    Parsed<RenderRequest> parsed({"m.csg", "--size", "24x20", "--camera", "0,-50,0,0,0,0"});
    static_cast<void>(session::compile(parsed.options, studies::choose_bits, {.text = text}));
    return kept.lines().size();
  };
  CHECK(warnings("cube(size=[8,6,4]);cube(size=[6,3,4.00000001]);") == 1);
  CHECK(warnings("cube(size=[8,6,4]);cube(size=[6,3,5]);") == 0);
}