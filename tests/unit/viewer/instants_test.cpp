#include "sim/viewer/instants.h"

#include <nlohmann/json.hpp>

#include "hw/isa/facts.h"
#include "hw/isa/pieces.h"
#include "hw/isa/text.h"
#include "hw/kinds/load.h"
#include "places.h"
#include "sim/debug/field_picture.h"
#include "sim/engine/engine.h"
#include "sim/engine/numbers.h"
#include "sim/pictures/encode.h"
#include "sim/report/codec.h"
#include "sim/report/pictures.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/model_request.h"
#include "sim/session/run/run_request.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

struct Subject {
  machines::Machine machine;
  isa::Program program;
};

Subject subject(const std::string& machine, const std::string& size = "48x40") {
  const session::ModelRequest options = session::parse_model_request(std::vector<std::string>{
      CSGSIM_SOURCE_DIR "/tests/models/thesis_fig_2_3.csg", "--machine", machine, "--size", size});
  const machines::Machine built = session::machine_of(options);
  return {built, session::compile_model(options, built).program};
}

std::string as_url(const std::string& png) { return "data:image/png;base64," + report::base64(png); }

/// URL of a grey or coloured picture.
std::string url_of(const observe::Picture& picture) {
  std::vector<std::uint8_t> bytes;
  for (const std::uint8_t byte : picture.bytes) bytes.insert(bytes.end(), picture.channels == 3 ? 1 : 3, byte);
  return as_url(pictures::encode("picture.png", {picture.width, picture.height, 3, {}, pictures::Bytes(bytes)}));
}

}  // namespace

TEST_CASE("after the last instruction the picture is the drawn one on each machine") {
  for (const std::string_view name : kinds::built_in_names()) {
    CAPTURE(name);
    const Subject of = subject(std::string(name));
    const session::DrawnRun drawn = session::draw(of.program, of.machine);
    viewer::Instants instants(of.program, of.machine);
    const nlohmann::ordered_json last = instants.at({.number = ~std::uint64_t{0}, .field = {}});
    CHECK(last["number"] == last["count"]);
    CHECK(last["picture"] == as_url(report::picture_of(drawn.frame, of.program, "", "").png));
  }
}

TEST_CASE("the fields of an instant equal the reference's in steps forwards and backwards") {
  const Subject of = subject("pixel-planes-4");
  viewer::Instants instants(of.program, of.machine);
  const std::vector<isa::Instruction>& all = of.program.segments.front().instructions;
  for (const std::uint64_t number : {0U, 40U, 41U, 90U, 60U, 13U, 120U, 5U}) {
    const std::unique_ptr<engine::Engine> reference = engine::make_reference_engine(of.machine);
    const std::unique_ptr<engine::Run> run = reference->begin(of.program);
    run->advance(number, {});
    for (const isa::NamedField& field : of.program.facts->fields) {
      CAPTURE(field.name);
      const nlohmann::ordered_json instant = instants.at({.number = number, .field = field.name});
      CHECK(instant["number"] == number);
      CHECK(instant["picture"] == url_of(debug::draw_field(field.field, *run, of.program).picture));
    }
    const nlohmann::ordered_json instant = instants.at({.number = number, .field = "E"});
    CHECK(instant["picture"] == url_of(debug::draw_field({}, *run, of.program).picture));
    const auto& listed = instant["instructions"];
    const auto here = std::ranges::find_if(listed, [&](const auto& one) { return one["number"] == number; });
    REQUIRE(here != listed.end());
    CHECK((*here)["text"] == isa::text_of(all[number], of.program.facts->fields));
  }
}

TEST_CASE("tinting changes the picture of an instant only if pixels are enabled") {
  const Subject of = subject("pixel-planes-4", "16x12");
  viewer::Instants instants(of.program, of.machine);
  const auto at = [&](bool is_tinted) { return instants.at({.number = 0, .field = {}, .is_tinted = is_tinted}); };
  CHECK(at(false)["picture"] == at(true)["picture"]);  // no pixel is enabled before the first instruction
  const auto differs = [&](std::uint64_t number) {
    return instants.at({.number = number, .field = "Z1", .is_tinted = true})["picture"] !=
           instants.at({.number = number, .field = "Z1"})["picture"];
  };
  CHECK(differs(1));
}

TEST_CASE("a primitive's first instruction is the first whose origin names it") {
  const Subject of = subject("pixel-planes-4");
  viewer::Instants instants(of.program, of.machine);
  for (std::uint32_t primitive = 0; primitive < of.program.facts->primitives.size(); ++primitive) {
    const nlohmann::ordered_json instant = instants.at({.number = 0, .field = {}, .primitive = primitive});
    const auto number = instant["number"].get<std::uint64_t>();
    const std::vector<isa::Instruction>& all = of.program.segments.front().instructions;
    const auto serves = [&](const isa::Instruction& one) {
      return one.origin.primitive != isa::no_primitive &&
             isa::primitive_of(*of.program.facts, one.origin.primitive) == primitive;
    };
    CHECK(serves(all[number]));
    CHECK(std::none_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(number), serves));
  }
  CHECK(testing::error_of([&] { (void)instants.at({.number = 0, .field = {}, .primitive = 99}); }).find("p99") !=
        std::string::npos);
  CHECK(testing::error_of([&] {
          (void)instants.at({.number = 0, .field = "Z3"});
        }).starts_with("there is no field 'Z3'; the fields are E, "));
}

TEST_CASE("an instant has the clocks of its instruction or a reason for their absence") {
  for (const std::string_view name : kinds::built_in_names()) {
    CAPTURE(name);
    const Subject of = subject(std::string(name));
    viewer::Instants instants(of.program, of.machine);
    const nlohmann::ordered_json instant = instants.at({.number = 3, .field = {}});
    CHECK(instant.contains("clocks") != instant.contains("no_clocks"));
    if (instant.contains("clocks"))
      CHECK(instant["clocks"][0].get<std::uint64_t>() <= instant["clocks"][1].get<std::uint64_t>());
  }
}

TEST_CASE("the listing of an instant has 12 instructions before it and 24 from it on") {
  const Subject of = subject("pixel-planes-4");
  viewer::Instants instants(of.program, of.machine);
  const std::uint64_t count = of.program.segments.front().instructions.size();
  REQUIRE(of.program.segments.size() == 1);
  REQUIRE(count > 100);
  const auto listed = [&](std::uint64_t number) {
    const nlohmann::ordered_json instant = instants.at({.number = number, .field = {}});
    const auto& rows = instant["instructions"];
    return std::pair{rows.front()["number"].get<std::uint64_t>(), rows.back()["number"].get<std::uint64_t>()};
  };
  using Range = std::pair<std::uint64_t, std::uint64_t>;
  CHECK(listed(0) == Range{0, 23});
  CHECK(listed(12) == Range{0, 35});
  CHECK(listed(13) == Range{1, 36});
  CHECK(listed(count - 24) == Range{count - 36, count - 1});
  CHECK(listed(count - 1) == Range{count - 13, count - 1});
  CHECK(listed(count) == Range{count - 12, count - 1});
  CHECK(listed(count + 1) == Range{count - 12, count - 1});
}

namespace {

/// Places of the instructions in the order of their numbers.
std::vector<engine::Place> places_of(const isa::Program& program) {
  std::vector<engine::Place> places;
  for (std::uint32_t segment = 0; segment < program.segments.size(); ++segment) {
    for (std::size_t index = 0; index < program.segments[segment].instructions.size(); ++index)
      places.push_back({segment, static_cast<decltype(engine::Place::index)>(index)});
  }
  return places;
}

const isa::Instruction& instruction_at(const isa::Program& program, engine::Place place) {
  return program.segments[place.segment].instructions[place.index];
}

/// The picture with three channels per pixel; grey is repeated in each.
std::vector<std::uint8_t> rgb_bytes_of(const observe::Picture& picture) {
  std::vector<std::uint8_t> bytes;
  for (const std::uint8_t byte : picture.bytes) bytes.insert(bytes.end(), picture.channels == 3 ? 1 : 3, byte);
  return bytes;
}

}  // namespace

TEST_CASE("tinting mixes half the mark's colour into enabled pixels in any region") {
  struct Row {
    const char* machine;
    const char* size;
  };
  // Regions: the whole picture with more than 64 pixels a row, 128 x 128 pixels, a row, 16 x 16 pixels.
  for (const Row& row : {Row{"pixel-planes-4", "70x40"}, Row{"pixel-planes-5", "140x140"}, Row{"scan-line", "40x30"},
                         Row{"pixel-square", "40x40"}}) {
    CAPTURE(row.machine);
    const Subject of = subject(row.machine, row.size);
    viewer::Instants instants(of.program, of.machine);
    const std::uint64_t count = places_of(of.program).size();
    std::size_t tinted = 0;
    for (std::uint64_t part = 1; part < 8; ++part) {
      const nlohmann::ordered_json instant =
          instants.at({.number = count * part / 8, .field = "Z1", .is_tinted = true});
      const std::unique_ptr<engine::Engine> reference = engine::make_reference_engine(of.machine);
      const std::unique_ptr<engine::Run> run = reference->begin(of.program);
      run->advance(instant["number"].get<std::uint64_t>(), {});
      const auto field = std::ranges::find(of.program.facts->fields, std::string("Z1"), &isa::NamedField::name)->field;
      std::vector<std::uint8_t> expected = rgb_bytes_of(debug::draw_field(field, *run, of.program).picture);
      const observe::Picture enabled = debug::draw_field({}, *run, of.program).picture;
      REQUIRE(enabled.channels == 1);
      for (std::size_t pixel = 0; pixel < enabled.bytes.size(); ++pixel) {
        if (enabled.bytes[pixel] == 0) continue;
        ++tinted;
        // 192, 85, 16 is the mark's colour.
        const unsigned mark[] = {192, 85, 16};
        for (std::size_t i = 0; i < 3; ++i)
          expected[3 * pixel + i] = static_cast<std::uint8_t>((expected[3 * pixel + i] + mark[i]) / 2);
      }
      CHECK(instant["picture"] ==
            as_url(pictures::encode("picture.png", {enabled.width, enabled.height, 3, {}, pictures::Bytes(expected)})));
    }
    CHECK(tinted > 0);
  }
}

TEST_CASE("an instant has its next instruction with primitive and segment and context") {
  for (const char* const machine : {"pixel-planes-4", "scan-line", "pixel-square"}) {
    CAPTURE(machine);
    const Subject of = subject(machine);
    const isa::Facts& facts = *of.program.facts;
    viewer::Instants instants(of.program, of.machine);
    const std::vector<engine::Place> places = places_of(of.program);
    std::size_t compared = 0;
    for (std::uint64_t part = 0; part < 12; ++part) {
      const nlohmann::ordered_json instant = instants.at({.number = places.size() * part / 12, .field = {}});
      const auto number = instant["number"].get<std::uint64_t>();
      REQUIRE(number < places.size());
      CHECK(instant["count"] == places.size());
      CHECK(instant["segment"] == places[number].segment);
      const std::uint32_t piece = instruction_at(of.program, places[number]).origin.primitive;
      CHECK(instant.contains("piece") == (piece != isa::no_primitive));
      if (instant.contains("piece")) CHECK(instant["piece"] == piece);
      for (const auto& one : instant["instructions"]) {
        const isa::Instruction& instruction = instruction_at(of.program, places.at(one["number"].get<std::uint64_t>()));
        CHECK(one["text"] == isa::text_of(instruction, facts.fields));
        const isa::Origin& origin = instruction.origin;
        CHECK(one.contains("primitive") == (origin.primitive != isa::no_primitive));
        CHECK(one.contains("against") == (origin.node != isa::no_primitive));
        if (one.contains("primitive")) CHECK(one["primitive"] == isa::primitive_of(facts, origin.primitive));
        if (!one.contains("against")) continue;
        CHECK(one["against"] == isa::primitive_of(facts, origin.node));
        ++compared;
      }
    }
    CHECK(compared > 0);
    // The first instruction that serves a primitive, over all segments.
    for (std::uint64_t primitive = 0; primitive < facts.primitives.size(); ++primitive) {
      const auto first = std::ranges::find_if(places, [&](engine::Place place) {
        const std::uint32_t piece = instruction_at(of.program, place).origin.primitive;
        return piece != isa::no_primitive && isa::primitive_of(facts, piece) == primitive;
      });
      REQUIRE(first != places.end());
      CHECK(instants.at({.number = 0, .field = {}, .primitive = primitive})["number"].get<std::uint64_t>() >=
            static_cast<std::uint64_t>(first - places.begin()));
    }
  }
}

TEST_CASE("a clock belongs to the first instruction that is not yet completely issued") {
  const Subject of = subject("pixel-planes-4");
  viewer::Instants instants(of.program, of.machine);
  const auto number_at_clock = [&](std::uint64_t clock) {
    return instants.at({.number = 0, .field = {}, .primitive = {}, .clock = clock})["number"].get<std::uint64_t>();
  };
  CHECK(number_at_clock(0) == 0);
  for (const std::uint64_t number : {0U, 1U, 7U, 40U, 90U}) {
    const nlohmann::ordered_json instant = instants.at({.number = number, .field = {}});
    REQUIRE(instant["number"] == number);
    const auto end = instant["clocks"][1].get<std::uint64_t>();
    CHECK(number_at_clock(end - 1) == number);
    CHECK(number_at_clock(end) == number + 1);
    const auto next = instants.at({.number = number + 1, .field = {}})["clocks"];
    CHECK(next[0].get<std::uint64_t>() >= end);
  }
}

TEST_CASE("an instant lists fields by name and describes the scale of the displayed one") {
  const Subject of = subject("pixel-planes-4");
  viewer::Instants instants(of.program, of.machine);
  std::vector<std::string> names{"E"};
  for (const isa::NamedField& field : of.program.facts->fields) names.push_back(field.name);
  CHECK(instants.fields() == names);
  const nlohmann::ordered_json colour = instants.at({.number = 0, .field = {}});
  CHECK(colour["fields"] == names);
  CHECK(colour["scale"] == "colour");
  CHECK(instants.at({.number = 0, .field = "Z1"})["scale"] != colour["scale"]);
}
