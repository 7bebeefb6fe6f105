#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/program_file.h"
#include "hw/kinds/load.h"
#include "hw/machines/regions.h"
#include "tests/cli/cli.h"
#include "tests/waves/engine_state.h"
#include "tests/waves/vcd.h"

using namespace csgsim;

namespace {

using namespace csgsim::testing::cli;
using csgsim::test::EngineState;
using csgsim::test::Vcd;
using isa::Opcode;

constexpr isa::Field root_field{0, 31};  // a root of 15 bits above the remainder
constexpr isa::Field root{16, 15};
constexpr isa::Field depth{40, 15};
constexpr std::uint16_t width = 36;

/// The depth of an ellipsoid with axes oblique to the picture, at pixel 12,8; x and y count from the region's corner.
std::vector<isa::Instruction> ellipsoid(const isa::Region& region) {
  constexpr std::int64_t scale = 5000;
  const std::int64_t x = 12 - static_cast<std::int64_t>(region.x);
  const std::int64_t y = 8 - static_cast<std::int64_t>(region.y);
  const isa::Linear squares{.a = -scale, .b = -scale, .c = -scale, .width = width};
  const isa::Linear rest{
      .a = scale * (2 * x + y), .b = scale * (2 * y + x), .c = scale * (49 - x * x - x * y - y * y), .width = width};
  const isa::Linear middle{.a = 7, .b = -3, .c = 9000, .width = width};
  return {{.opcode = Opcode::enable_all},
          {.opcode = Opcode::squares, .linear = squares},
          {.opcode = Opcode::edge_not_negative, .linear = rest},
          {.opcode = Opcode::squares, .linear = squares},
          {.opcode = Opcode::load_linear, .fields = {root_field}, .linear = rest},
          {.opcode = Opcode::root, .fields = {root_field}},
          {.opcode = Opcode::copy, .fields = {depth, root}},
          {.opcode = Opcode::linear_minus, .fields = {depth}, .linear = middle},
          {.opcode = Opcode::linear_plus, .fields = {depth}, .linear = middle}};
}

isa::Program drawn_on(const machines::Machine& machine) {
  isa::Program program;
  program.shape = {machine.picture.width, machine.picture.height, 64};
  program.facts->fields = {{"root", root_field}, {"depth", depth, isa::FieldRole::depth}};
  for (const isa::Region& region : machines::regions(machine))
    program.segments.push_back({.region = region, .instructions = ellipsoid(region)});
  return program;
}

struct Drawn {
  machines::Machine machine;
  isa::Program program;
  std::string file;
};

Drawn drawn(const std::string& name, const Folder& folder) {
  Drawn one{kinds::load(name), {}, folder / "p.csgt"};
  machines::set_picture_size(one.machine, {24, 16});
  machines::complete(one.machine);
  one.program = drawn_on(one.machine);
  isa::save_program(one.program, one.file);
  machines::adopt_shape(one.machine, one.program);
  return one;
}

Vcd recorded(const Drawn& one, const std::string& name, const std::string& more, const std::string& file) {
  const Outcome outcome = run(fmt::format("wave {} --machine {} --pixel 12,8 {} -o {}", one.file, name, more, file));
  REQUIRE_MESSAGE(outcome.code == 0, outcome.err);
  return Vcd(content(file));
}

struct Case {
  std::string machine;
  std::string top;
  std::vector<std::string> parts;
};

const std::vector<Case> cases{
    {"pixel-powers", "frame_buffer", {"root.xx", "root.xy", "root.yy", "pixel_12_8.flag"}},
    {"pixel-planes-4+evaluator.degree=2+memory.reads=2+alu.bits=4", "frame_buffer", {"root.xx", "pixel_12_8.flag"}},
    {"pixel-powers+alu.bits=8+evaluator.bits=7",
     "frame_buffer",
     {"root.xx", "root.bits", "pixels.first", "pixel_12_8.flag"}},
    {"scan-line+evaluator.degree=2", "scan_line", {"entry.aa", "pixel_12_8.aa"}},
    {"pixel-square+evaluator.degree=2+divider.kind=host",
     "pixel_square",
     {"renderer_0.root.xx", "renderer_0.root.yy", "pixel_12_8.flag"}},
    {"pixel-planes-5", "pixel_square", {"renderer_0.root.xy", "pixel_12_8.flag"}},
    {"pixel-planes-5+alu.bits=4+evaluator.bits=4", "pixel_square", {"renderer_0.root.xy", "renderer_0.root.bits"}},
};

void check_wave(const Case& one) {
  const Folder folder;
  const Drawn frame = drawn(one.machine, folder);
  const EngineState state(frame.program, frame.machine, 12, 8);
  const std::uint64_t begin = state.first_clock();
  const std::uint64_t end = state.last_clock();
  const Vcd vcd = recorded(frame, one.machine, fmt::format("--window {}:{}", begin, end), folder / "w.vcd");
  const std::uint64_t period = 1'000'000'000'000 / frame.machine.clock_hz;
  for (const std::string& part : one.parts) CHECK_NOTHROW((void)vcd.at(one.top + "." + part, vcd.last_time()));
  std::size_t compared = 0;
  for (std::uint64_t clock = begin; clock < end; ++clock) {
    const auto shown = [&, time = (clock + 1) * period + period / 2](const std::string& name) {
      return vcd.number_at(one.top + ".pixel_12_8." + name, time);
    };
    CAPTURE(clock);
    if (const auto enable = state.enable_at(clock)) REQUIRE(shown("enable") == static_cast<std::uint64_t>(*enable));
    for (const isa::NamedField& named : frame.program.facts->fields) {
      CAPTURE(named.name);
      const auto expected = state.field_at(named.field, clock);
      if (expected) REQUIRE(shown(named.name) == expected);
      if (expected && *expected != 0) ++compared;
    }
  }
  CHECK(compared > 20);
}

TEST_CASE("a wave of any machine shows the reference's roots and quadratic expressions") {
  for (const Case& one : cases) {
    CAPTURE(one.machine);
    check_wave(one);
  }
}

TEST_CASE("a pixel simulated alone has the wave of the whole machine from after squares on") {
  const Folder folder;
  const std::string name = "pixel-powers";
  const Drawn one = drawn(name, folder);
  for (const std::string window : {"i1:i2", "i2:i3", "i4", "i5:i6", "i7:i9"}) {
    CAPTURE(window);
    const std::string words = "--probe tree.x:2 --probe tree.y:1 --window " + window;
    recorded(one, name, words, folder / "probed.vcd");
    recorded(one, name, words + " --whole", folder / "whole.vcd");
    CHECK(content(folder / "probed.vcd") == content(folder / "whole.vcd"));
    recorded(one, name, words + " --evaluator worked-out", folder / "worked_out.vcd");
    CHECK(content(folder / "probed.vcd") == content(folder / "worked_out.vcd"));
  }
}

/// 2^bits - 1.
std::int64_t mask(unsigned bits) { return (std::int64_t{1} << bits) - 1; }

TEST_CASE("tree levels in a wave form the value and the slopes at a node's first leaf") {
  const Folder folder;
  const std::string name = "pixel-powers";
  const Drawn one = drawn(name, folder);
  const EngineState state(one.program, one.machine, 12, 8);
  const std::string words =
      fmt::format("--probe tree.x:2 --probe tree.y:1 --window {}:{}", state.first_clock() - 12, state.last_clock());
  const Vcd vcd = recorded(one, name, words, folder / "w.vcd");
  const isa::Linear& s = one.program.segments.front().instructions[1].linear;
  const isa::Linear& l = one.program.segments.front().instructions[2].linear;
  // After 2 of 5 levels over 24 columns, x = 12 = 01100b is known to be at least 8; after 1 of 4 over 16 rows, y is
  // known to be 8.
  struct Stream {
    std::string name;
    std::int64_t value;
    std::string bit;
  };
  const std::vector<Stream> streams{
      {"tree_x_2", s.a * 8 * 8 + l.a * 8 + l.c, "tree_x_2_bit"},
      {"tree_x_2_slope", 2 * s.a * 8 + l.a, "tree_x_2_bit"},
      {"tree_x_2_row_slope", s.b * 8 + l.b, "tree_x_2_bit"},
      {"tree_y_1", s.a * 12 * 12 + l.a * 12 + l.c + (s.b * 12 + l.b) * 8 + s.c * 8 * 8, "tree_y_1_bit"},
      {"tree_y_1_slope", s.b * 12 + l.b + 2 * s.c * 8, "tree_y_1_bit"}};
  for (const Stream& stream : streams) {
    CAPTURE(stream.name);
    std::int64_t gathered = 0;
    std::size_t found = 0;
    for (std::uint64_t time = vcd.first_time() + 50'000; time < vcd.last_time(); time += 100'000) {
      const auto bit = vcd.number_at("frame_buffer.pixel_12_8." + stream.bit, time);
      if (!bit) continue;
      if (*bit == 0) gathered = 0;
      gathered |= static_cast<std::int64_t>(*vcd.number_at("frame_buffer.pixel_12_8." + stream.name, time)) << *bit;
      if (*bit + 1 == width && gathered == (stream.value & mask(width))) ++found;
    }
    CHECK(found == 2);  // the two instructions preceded by squares
  }
}

TEST_CASE("a curved surface has the root and depth in a wave that explain reports") {
  const Folder folder;
  const std::string scene =
      " " + model("carburettor") + " --camera 220,-255,135,2,0,5 --size 64x64 --machine pixel-powers --pixel 32,32 ";
  require_success(run("explain" + scene + "--json " + (folder / "story.json")));
  const auto story = json(folder / "story.json");
  const auto surface = std::ranges::find_if(story["events"], [](const auto& event) {
    return event["what"] == "surface" && event.contains("decision") && event["decision"].contains("worked_out");
  });
  REQUIRE(surface != story["events"].end());
  const auto& worked_out = (*surface)["decision"]["worked_out"];
  const auto value_after = [&](const nlohmann::json& number, const std::string& field) {
    const std::string file = folder / "w.vcd";
    require_success(run("wave" + scene + "--window i" + number.dump() + " -o " + file));
    const Vcd vcd(content(file));
    const auto value = vcd.number_at("frame_buffer.pixel_32_32." + field, vcd.last_time());
    REQUIRE(value.has_value());
    return *value;
  };
  const auto& taken = worked_out["root"];
  const std::uint64_t root_mask = (std::uint64_t{1} << taken["width"].get<unsigned>() / 2) - 1;
  CHECK((value_after(taken["instruction"], "root") & root_mask) == taken["value"].get<std::uint64_t>());
  CHECK(taken["value"].get<std::uint64_t>() > 1000);
  const auto& made = worked_out["depth"];
  const bool is_far = worked_out["side"] == "far";
  const auto middle = made["middle"].get<std::int64_t>();
  const auto offset = made["offset"].get<std::int64_t>();
  const std::int64_t sum = is_far ? middle + offset : middle - offset;
  CHECK((value_after(made["instruction"], "sum") & static_cast<std::uint64_t>(mask(20))) ==
        static_cast<std::uint64_t>(sum & mask(20)));
}

}  // namespace
