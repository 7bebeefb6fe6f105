#include "hw/process/process.h"

#include "hw/isa/opcodes.h"
#include "hw/kinds/load.h"
#include "hw/machines/area_table.h"
#include "hw/machines/change_error.h"
#include "hw/machines/kind.h"
#include "hw/process/price.h"
#include "tests/support/test.h"

using namespace csgsim;
using process::ClockPath;
using process::Process;

namespace {

/// Round figures for calculation by hand: half of 140 fF times the square of 10 mV are 7 aJ.
const std::string round_figures = R"(
name = "round"
description = "of round figures"
[gate.delay]
value = 10
unit = "ps"
provenance = "assumed"
source = "a test"
[gate.fan_in]
value = 4
unit = "inputs"
provenance = "assumed"
source = "a test"
[gate.static_power]
value = 4
unit = "pW"
provenance = "assumed"
source = "a test"
[logic.family]
value = "cmos"
provenance = "assumed"
source = "a test"
[logic.utilization]
value = 100
unit = "%"
provenance = "assumed"
source = "a test"
[supply.voltage]
value = 10
unit = "mV"
provenance = "assumed"
source = "a test"
[register.delay]
value = 100
unit = "ps"
provenance = "assumed"
source = "a test"
[register.energy]
value = 2
unit = "aJ a bit"
provenance = "assumed"
source = "a test"
[adder.energy]
value = 5
unit = "aJ a bit"
provenance = "assumed"
source = "a test"
[clock.lines]
value = 0
unit = "wires"
provenance = "assumed"
source = "a test"
[memory.access]
value = 1000
unit = "ps"
provenance = "assumed"
source = "a test"
[memory.read_energy]
value = 40
unit = "aJ a bit"
provenance = "assumed"
source = "a test"
[memory.read_bits]
value = 6400
unit = "bits"
provenance = "assumed"
source = "a test"
[memory.cell_transistors]
value = 3
unit = "transistors"
provenance = "assumed"
source = "a test"
[memory.cell_area]
value = 3_000_000
unit = "nm2"
provenance = "assumed"
source = "a test"
[memory.periphery]
value = 0
unit = "%"
provenance = "assumed"
source = "a test"
[memory.refresh_time]
value = 0
unit = "ns"
provenance = "assumed"
source = "a test"
[transistor.area]
value = 2_000_000
unit = "nm2"
provenance = "assumed"
source = "a test"
[wire.delay]
value = 300
unit = "ps a mm"
provenance = "assumed"
source = "a test"
[wire.capacitance]
value = 140
unit = "fF a mm"
provenance = "assumed"
source = "a test"
)";

Process round_process(const std::vector<std::string>& changes = {}) {
  return process::read_process(round_figures, "round.toml", changes);
}

/// Pixel-planes 4 with 64 x 64 pixels of 64 bits.
machines::Machine small_machine(const std::string& changes = "") {
  machines::Machine machine = kinds::load("pixel-planes-4" + changes);
  machines::set_picture_size(machine, {64, 64});
  machine.array.memory_bits = 64;
  return machine;
}

double path(const machines::Machine& machine, const Process& process, std::string_view name) {
  const std::vector<ClockPath> paths = process::clock_paths(machine, process);
  return std::ranges::find(paths, name, &ClockPath::name)->ps;
}

}  // namespace

TEST_CASE("each parameter of each built-in process has a source") {
  for (const std::string_view name : process::process_names()) {
    const Process one = process::load_process(std::string(name));
    CHECK(one.name == name);
    CHECK(one.figures.size() == 20);
    for (const machines::Figure& figure : one.figures) CHECK(figure.source.size() > 10);
  }
}

TEST_CASE("a process is loaded by name or file with changed parameters") {
  CHECK(process::load_process("nmos-3um+gate.delay=5000").gate_delay == 5000);
  CHECK(process::load_process("nmos-3um+gate.delay=5000").name == "nmos-3um+gate.delay=5000");
  CHECK_THROWS_AS(process::load_process("nmos-3um+gate.delay=0"), machines::ChangeError);
  CHECK_THROWS_AS(process::load_process("nmos-3um+gate.dealy=5"), machines::ChangeError);
  CHECK_THROWS_WITH_AS(process::load_process("nmos-3"), doctest::Contains("did you mean nmos-3um"), InputError);
  std::string text = round_figures;
  text.replace(text.find("[gate.fan_in]"), 13, "[gate.fan_out]");
  CHECK_THROWS_WITH_AS(process::read_process(text, "round.toml"), doctest::Contains("round.toml:9:7"), InputError);
}

TEST_CASE("Pixel-planes 4 reaches its published 10 MHz in its contemporary process") {
  const auto clock = process::clock_of(kinds::load("pixel-planes-4"), process::load_process("nmos-3um"));
  REQUIRE(clock.has_value());
  CHECK(clock->hz == 10'000'000);
  CHECK(clock->path.name == "pixel");
}

TEST_CASE("the paths that limit the clock equal the hand-counted sums of their gates") {
  const Process one = round_process();
  // Register 100, access 1000; 6 address bits, two levels of gates with four inputs and a driver; 4 gates to select, 2
  // to carry a bit.
  CHECK(path(small_machine(), one, "pixel") == doctest::Approx(100 + 1000 + 10 * (3 + 4 + 2)));
  // Four bits: two levels of the rotator, two gates each.
  CHECK(path(small_machine("+alu.bits=4"), one, "pixel") == doctest::Approx(100 + 1000 + 10 * (3 + 4 + 4 + 8)));
  CHECK(path(small_machine(), one, "trees") == doctest::Approx(100 + 30));
  // Eight bits: the carry passes seven more, two gates each.
  CHECK(path(small_machine("+alu.bits=8+evaluator.bits=8"), one, "trees") == doctest::Approx(100 + 10 * (3 + 7 * 2)));
  // Two adders, and a wire half as long as the longest. Of the 63 nodes of a column those of levels 1, 3 and 5 have
  // registers, 42 of them: the remaining third of the nodes saves two flip-flops of 16 transistors from the 434, so
  // 1038 um2 per pixel.
  CHECK(path(small_machine("+evaluator.register_levels=2"), one, "trees") ==
        doctest::Approx(100 + 10 * 6 + 300 * 16 * std::sqrt(1038e-6)));
  // All six levels: six adders, wires of a half, a quarter and so on; registers after 32 nodes, 16 transistors less.
  CHECK(path(small_machine("+evaluator.register_levels=16"), one, "trees") ==
        doctest::Approx(100 + 10 * 18 + 300 * 31 * std::sqrt(1028e-6)));
  // 434 transistors of 2 um2 and 64 bits of three of 1 um2: 1060 um2 per pixel. The wire spans 32 pixels.
  CHECK(path(small_machine(), one, "wire") == doctest::Approx(100 + 300 * 32 * std::sqrt(1060e-6)));
  // 64 lines per gate: three levels of four.
  CHECK(path(small_machine(), one, "global OR") == doctest::Approx(100 + 30));
  CHECK(path(small_machine("+global_or.fan_in=4"), one, "global OR") == doctest::Approx(100 + 10));
  CHECK(process::clock_paths(small_machine("+global_or.present=0"), one).size() == 3);
  const auto clock = process::clock_of(small_machine(), one);
  CHECK(clock->hz == static_cast<std::uint64_t>(std::llround(1e12 / 1190)));
}

TEST_CASE("the longest wire is half the longer side and the global OR combines all pixels") {
  const Process one = round_process();
  machines::Machine machine = small_machine();
  for (const bool is_high : {false, true}) {
    machine.array.width = is_high ? 16 : 64;
    machine.array.height = is_high ? 64 : 16;
    CHECK(path(machine, one, "wire") == doctest::Approx(100 + 300 * 32 * std::sqrt(1060e-6)));
  }
  // Lines from all 16 pixels where the gates take 64: two levels of four.
  machine.array.width = 4;
  machine.array.height = 4;
  CHECK(path(machine, one, "global OR") == doctest::Approx(100 + 20));
}

TEST_CASE("bits of a second buffer have one read port whatever the pixel memory has") {
  const Process one = round_process();
  const double shared = (machines::controller_transistors.cmos + double{machines::fifo_transistors.cmos}) * 2e-6;
  const machines::Machine two_reads = small_machine("+memory.reads=2");
  // 298 and 90 of logic, and five transistors per bit of the pixels; three per bit of the buffer.
  const double pixels = 4096 * (388 * 2e-6 + 64 * 5e-6);
  CHECK(process::machine_mm2(two_reads, {4096, 4096 * 64 + 1000}, one) ==
        doctest::Approx(pixels + shared + 1000 * 3e-6));
  CHECK(process::machine_mm2(two_reads, {4096, 4096 * 64}, one) == doctest::Approx(pixels + shared));
  CHECK(process::machine_mm2(two_reads, {4096, 0}, one) == doctest::Approx(pixels + shared));
}

TEST_CASE("the silicon of a machine includes pixels and buffers and controllers and FIFOs") {
  const Process one = round_process();
  const machines::Machine machine = small_machine();
  const machines::Resources pixels{4096, 4096 * 64};
  const double shared = (machines::controller_transistors.cmos + double{machines::fifo_transistors.cmos}) * 2e-6;
  CHECK(process::machine_mm2(machine, pixels, one) == doctest::Approx(4096 * 1060e-6 + shared));
  // With four bits per clock, a pixel has 1070 transistors of ALU logic and 294 of tree logic.
  CHECK(process::machine_mm2(small_machine("+alu.bits=4+evaluator.bits=4"), pixels, one) ==
        doctest::Approx(4096 * (1364 * 2e-6 + 64 * 3e-6) + shared));
  const machines::Resources buffered{4096, 4096 * 64 + 1000};
  CHECK(process::machine_mm2(machine, buffered, one) == doctest::Approx(4096 * 1060e-6 + shared + 1000 * 3e-6));
  const auto squares = [&](const std::string& changes) {
    const machines::Machine several = kinds::load("pixel-planes-5" + changes);
    return *process::machine_mm2(several, {4096, 4096 * several.array.memory_bits}, one);
  };
  const machines::Link link = kinds::load("pixel-planes-5").link;
  const double of_one = (machines::controller_transistors.cmos +
                         link.fifo_depth * link.width * (machines::fifo_transistors.cmos / 512.0)) *
                        2e-6;
  CHECK(squares("+renderers.count=4") - squares("+renderers.count=1") == doctest::Approx(3 * of_one));
}

TEST_CASE("a frame's energy is that of its pixel clocks plus static power") {
  const Process one = round_process();
  const machines::Resources pixels{4096, 4096 * 64};
  // Two ports of a bit, each 40 aJ scaled by the memory's side, a tenth; two adder bits; 3 + 1 + 3 registers; two
  // streams over the pixel's pitch.
  const double clock = 1e-18 * (2 * 40 * 0.1 + 2 * 5 + 7 * 2 + 2 * 7 * std::sqrt(1060e-6));
  // doctest's Approx does not compare ratios of numbers this small.
  const auto part_of = [&](const std::string& changes, const process::FrameWork& work, double joules) {
    return *process::frame_joules(small_machine(changes), pixels, work, one) / joules;
  };
  CHECK(part_of("", {1000, 0}, 1000 * clock) == doctest::Approx(1));
  // Two reads: one more port, two more transistors per bit, 298 + 90 of logic, and no operand latch.
  const double two_reads = 1e-18 * (3 * 40 * 0.1 + 2 * 5 + 6 * 2 + 2 * 7 * std::sqrt(388 * 2e-6 + 64 * 5e-6));
  CHECK(part_of("+memory.reads=2", {1000, 0}, 1000 * two_reads) == doctest::Approx(1));
  // Four bits: each port, the ALU and the operand latch are four bits wide.
  const double four_bits =
      1e-18 * (2 * 4 * 40 * 0.1 + 5 * 5 + 10 * 2 + 2 * 7 * std::sqrt((1070 + 90) * 2e-6 + 64 * 3e-6));
  CHECK(part_of("+alu.bits=4", {1000, 0}, 1000 * four_bits) == doctest::Approx(1));
  // Degree 2: three adders, eight flip-flops and four streams per node, and a flag at the pixel.
  const double squares = 1e-18 * (2 * 40 * 0.1 + 4 * 5 + 13 * 2 + 4 * 7 * std::sqrt((392 + 258) * 2e-6 + 64 * 3e-6));
  CHECK(part_of("+evaluator.degree=2", {1000, 0}, 1000 * squares) == doctest::Approx(1));
  // Per node of a four-bit tree of degree 1: 4 adders; 8 flip-flops of streams and 1 of a carry; 8 stream wires. A
  // pixel has 1070 transistors of ALU logic and 294 of tree logic. Degree 2: 12 adders; 16 flip-flops of streams, 3 of
  // carries and 1 of the flag; 16 stream wires; 1154 and 801 transistors.
  const auto wide = [](double adders, double registers, double streams, double logic) {
    const double pitch = std::sqrt(logic * 2e-6 + 64 * 3e-6);
    return 1e-18 * (2 * 4 * 40 * 0.1 + (4 + adders) * 5 + (3 + 4 + registers) * 2 + streams * 7 * pitch);
  };
  CHECK(part_of("+alu.bits=4+evaluator.bits=4", {1000, 0}, 1000 * wide(4, 9, 8, 1364)) == doctest::Approx(1));
  CHECK(part_of("+alu.bits=4+evaluator.bits=4+evaluator.degree=2", {1000, 0}, 1000 * wide(12, 20, 16, 1955)) ==
        doctest::Approx(1));
  // Registers at two thirds of the nodes.
  const double fewer = 1e-18 * (2 * 40 * 0.1 + 2 * 5 + (5 + 4.0 / 3) * 2 + 2 * 7 * std::sqrt(1038e-6));
  CHECK(part_of("+evaluator.register_levels=2", {1000, 0}, 1000 * fewer) == doctest::Approx(1));
  const double gates = (4096 * 434 + machines::controller_transistors.cmos + machines::fifo_transistors.cmos) / 4.0;
  CHECK(part_of("", {1000, 2}, 1000 * clock + gates * 4e-12 * 2) == doctest::Approx(1));
  CHECK(part_of("", {0, 2}, gates * 4e-12 * 2) == doctest::Approx(1));
}

TEST_CASE("wires between cells and the periphery of the memory enlarge a pixel") {
  const machines::Machine machine = small_machine();
  const auto pixel = [&](const std::vector<std::string>& changes) {
    return *process::pixel_mm2(machine, round_process(changes));
  };
  CHECK(pixel({}).logic == doctest::Approx(434 * 2e-6));
  CHECK(pixel({}).memory == doctest::Approx(64 * 3e-6));
  CHECK(pixel({"logic.utilization=80"}).logic == doctest::Approx(434 * 2.5e-6));
  CHECK(pixel({"memory.periphery=50"}).memory == doctest::Approx(64 * 4.5e-6));
  // A cell of one transistor gets two for the second read port, one of six transistors a third more.
  const machines::Machine two_reads = small_machine("+memory.reads=2");
  for (const auto& [transistors, area] : {std::pair{1, 9e-6}, {3, 5e-6}, {6, 4e-6}}) {
    const Process one = round_process({fmt::format("memory.cell_transistors={}", transistors)});
    CHECK(process::pixel_mm2(two_reads, one)->memory == doctest::Approx(64 * area));
    CHECK(process::pixel_mm2(machine, one)->memory == doctest::Approx(64 * 3e-6));
  }
  CHECK(!process::pixel_mm2(kinds::load("scan-line"), round_process()).has_value());
}

TEST_CASE("nMOS logic has the transistors of nMOS circuits and three per gate") {
  const Process one = round_process({"logic.family=nmos"});
  const machines::Machine machine = small_machine();
  // 217 transistors of the pixel and 50 of the node.
  CHECK(process::pixel_mm2(machine, one)->logic == doctest::Approx(267 * 2e-6));
  const double shared = machines::controller_transistors.nmos + double{machines::fifo_transistors.nmos};
  CHECK(process::machine_mm2(machine, {4096, 4096 * 64}, one) ==
        doctest::Approx(4096 * (267 * 2e-6 + 64 * 3e-6) + shared * 2e-6));
  const double watts = (4096 * 267 + shared) / 3 * 4e-12;
  CHECK(*process::frame_joules(machine, {4096, 4096 * 64}, {0, 2}, one) / (2 * watts) == doctest::Approx(1));
  // Registers at two thirds of the nodes save a third of two flip-flops of two latches of three transistors.
  CHECK(process::pixel_mm2(small_machine("+evaluator.register_levels=2"), one)->logic == doctest::Approx(263 * 2e-6));
  CHECK_THROWS_WITH_AS(round_process({"logic.family=bipolar"}), doctest::Contains("logic.family"),
                       machines::ChangeError);
}

TEST_CASE("the clock's wires cross each pixel and are charged in every clock of the frame") {
  const machines::Machine machine = small_machine();  // 10 MHz
  const machines::Resources pixels{4096, 4096 * 64};
  const double without = *process::frame_joules(machine, pixels, {1000, 2}, round_process());
  const double with = *process::frame_joules(machine, pixels, {1000, 2}, round_process({"clock.lines=3"}));
  // C V2 is 14 aJ a mm.
  const double expected = 4096 * 3 * std::sqrt(1060e-6) * 14e-18 * 10e6 * 2;
  CHECK((with - without) / expected == doctest::Approx(1));
}

TEST_CASE("dynamic memory is refreshed in clocks and with energy") {
  const machines::Machine machine = small_machine();
  const machines::Resources resources{4096, 4096 * 64 + 1000};
  const Process fixed = round_process();
  const Process dynamic = round_process({"memory.refresh_time=1000"});
  // A clock takes 1190 ps: 64 rows take 76.16 of the 1000 ns.
  CHECK(process::clock_of(machine, fixed)->usable_hz == process::clock_of(machine, fixed)->hz);
  const auto clock = process::clock_of(machine, dynamic);
  CHECK(clock->hz == static_cast<std::uint64_t>(std::llround(1e12 / 1190)));
  CHECK(clock->usable_hz == static_cast<std::uint64_t>(std::llround(1e12 / 1190 * (1 - 0.07616))));
  // Two bits a row, with an ALU of two; its clock takes 20 ps more for the rotator and 20 ps for the carry.
  CHECK(process::clock_of(small_machine("+alu.bits=2"), dynamic)->usable_hz ==
        static_cast<std::uint64_t>(std::llround(1e12 / 1230 * (1 - 32 * 1.23 / 1000))));
  CHECK(process::clock_of(machine, round_process({"memory.refresh_time=1"}))->usable_hz == 1);
  // Every bit, also of the buffer, is read and written each microsecond, 4 aJ each.
  const double refresh = (4096 * 64 + 1000) * 2 * 4e-18 / 1e-6;
  const double without = *process::frame_joules(machine, resources, {1000, 3}, fixed);
  CHECK((*process::frame_joules(machine, resources, {1000, 3}, dynamic) - without) / (3 * refresh) ==
        doctest::Approx(1));
}

TEST_CASE("a cell of one transistor is written again after each read") {
  const machines::Machine machine = small_machine();
  const machines::Resources pixels{4096, 4096 * 64};
  const double three = *process::frame_joules(machine, pixels, {1000, 0}, round_process());
  const double one = *process::frame_joules(machine, pixels, {1000, 0}, round_process({"memory.cell_transistors=1"}));
  CHECK((one - three) / (1000 * 4e-18) == doctest::Approx(1));
}

TEST_CASE("pixel clocks count executed instructions at each pixel of the region") {
  isa::Program program;
  isa::Instruction any;
  any.opcode = isa::Opcode::enable_all;
  isa::Instruction query;
  query.opcode = isa::Opcode::skip_if_none;
  query.constant = 2;
  program.segments.push_back({});
  program.segments[0].region = {0, 0, 8, 4};
  program.segments[0].instructions = {any, query, any, any, any};
  const machines::Machine machine = small_machine();
  const std::uint64_t answer = machine.kind->clocks(query, machine);
  CHECK(process::pixel_clocks(program, machine, {}) == 32 * (answer + 4));
  const machines::Skip skip{0, 1};
  CHECK(process::pixel_clocks(program, machine, {&skip, 1}) == 32 * (answer + 2));
}

TEST_CASE("pixel clocks sum over segments and exclude skipped instructions") {
  const isa::Instruction any{.opcode = isa::Opcode::enable_all};
  const isa::Instruction query{.opcode = isa::Opcode::skip_if_none, .constant = 2};
  isa::Program program;
  for (const isa::Region& region : {isa::Region{0, 0, 8, 4}, isa::Region{8, 0, 3, 5}, isa::Region{0, 4, 2, 2}})
    program.segments.push_back({.region = region, .instructions = {query, any, any, any, query, any, any}});
  program.segments.push_back({.region = {2, 4, 6, 6}, .instructions = {}});
  const machines::Machine machine = small_machine();
  const std::uint64_t answer = machine.kind->clocks(query, machine);
  REQUIRE(machine.kind->clocks(any, machine) == 1);
  const auto clocks = [&](const std::vector<machines::Skip>& skips) {
    return process::pixel_clocks(program, machine, skips);
  };
  const std::uint64_t all = 2 * answer + 5;
  CHECK(clocks({}) == (32 + 15 + 4) * all);
  CHECK(clocks({{0, 0}}) == 32 * (all - 2) + (15 + 4) * all);
  CHECK(clocks({{1, 0}}) == 15 * (all - 2) + (32 + 4) * all);
  CHECK(clocks({{1, 4}}) == 15 * (all - 2) + (32 + 4) * all);  // the skip reaches the segment's end
  CHECK(clocks({{0, 0}, {0, 4}, {2, 4}}) == 32 * (all - 4) + 15 * all + 4 * (all - 2));
  CHECK(clocks({{0, 4}, {1, 0}, {1, 4}, {2, 0}}) == 32 * (all - 2) + 15 * (all - 4) + 4 * (all - 2));
  CHECK(process::pixel_clocks({}, machine, {}) == 0);
}

TEST_CASE("a frame of no work and no time takes no energy") {
  const process::FrameWork none;
  CHECK(process::frame_joules(small_machine(), {4096, 4096 * 64}, none, round_process()) == 0.0);
  const process::Clock clock;
  CHECK(clock.hz == 0);
  CHECK(clock.path.ps == 0);
}

TEST_CASE("the clock of an array of one pixel includes no tree and no wire between levels") {
  const Process one = round_process();
  machines::Machine machine = small_machine("+evaluator.register_levels=16");
  machine.array.width = 1;
  machine.array.height = 1;
  CHECK(path(machine, one, "trees") == doctest::Approx(100 + 10 * 3));
  CHECK(path(machine, one, "global OR") == doctest::Approx(100));
  // Two pixels have one level, four two: the side is four pixels long, and the first wire a quarter of that.
  machine.array.height = 2;
  CHECK(path(machine, one, "trees") == doctest::Approx(100 + 10 * 3));
  CHECK(path(machine, one, "global OR") == doctest::Approx(100 + 10));
  machine.array.height = 4;
  const double side = (path(machine, one, "wire") - 100) / 300;  // half of it, in mm
  CHECK(path(machine, one, "trees") == doctest::Approx(100 + 10 * 6 + 300 * side / 2));
}

TEST_CASE("the trees that limit the clock have the depth of the longer side of the array") {
  const Process one = round_process();
  machines::Machine machine = small_machine("+evaluator.register_levels=16");
  for (const bool is_high : {false, true}) {
    machine.array.width = is_high ? 2 : 64;
    machine.array.height = is_high ? 64 : 2;
    const double side = (path(machine, one, "wire") - 100) / 300;
    // Six levels: wires of a half, a quarter and so on, 31 / 32 of the longest in all.
    CHECK(path(machine, one, "trees") == doctest::Approx(100 + 10 * 18 + 300 * side * 31 / 32));
  }
}

TEST_CASE("an OR line of ideal fan-in combines all pixels in levels of process gates") {
  const Process one = round_process();
  // 4096 pixels: six levels of four.
  CHECK(path(small_machine("+global_or.fan_in=ideal"), one, "global OR") == doctest::Approx(100 + 60));
}

TEST_CASE("pixel memory one bit beyond a decoder's capacity takes one more level of gates") {
  const Process one = round_process();
  machines::Machine machine = small_machine();
  const auto pixel = [&](std::uint32_t bits) {
    machine.array.memory_bits = bits;
    return path(machine, one, "pixel");
  };
  // Addresses of 0, 1, 2, 4, 5 and 12 bits take 0, 0, 1, 1, 2 and 2 levels of gates with four inputs, and a driver.
  const double others = 100 + 1000 + 10 * (1 + 4 + 2);
  CHECK(pixel(1) == doctest::Approx(others));
  CHECK(pixel(2) == doctest::Approx(others));
  CHECK(pixel(3) == doctest::Approx(others + 10));
  CHECK(pixel(16) == doctest::Approx(others + 10));
  CHECK(pixel(17) == doctest::Approx(others + 20));
  CHECK(pixel(4096) == doctest::Approx(others + 20));
}

TEST_CASE("a process lists its parameters in the order of its file with unit and value") {
  const Process one = round_process();
  CHECK(one.name == "round");
  CHECK(one.description == "of round figures");
  REQUIRE(one.figures.size() == 20);
  CHECK(one.figures[0].key == "gate.delay");
  CHECK(one.figures[0].value == "10");
  CHECK(one.figures[0].unit == "ps");
  CHECK(one.figures[19].key == "wire.capacitance");
  CHECK(one.figures[19].value == "140");
  CHECK(one.figures[19].unit == "fF a mm");
  for (const machines::Figure& figure : one.figures) {
    CHECK(figure.provenance == "assumed");
    CHECK(figure.source == "a test");
  }
  const Process none;
  CHECK(none.gate_delay + none.gate_fan_in + none.register_delay + none.memory_access + none.wire_delay == 0);
  CHECK(none.transistor_area + none.cell_area + none.cell_transistors + none.memory_bits + none.static_power == 0);
  CHECK(none.adder_energy + none.register_energy + none.memory_energy + none.wire_capacitance == 0);
  CHECK(none.family + none.utilization + none.supply + none.clock_lines + none.periphery + none.refresh_time == 0);
}

TEST_CASE("unsynthesized machines have no area or energy in any process") {
  const Process one = process::load_process("cmos-45nm");
  for (const std::string machine : {"scan-line", "multi-processor", "pixel-planes-4+alu.bits=3"}) {
    CAPTURE(machine);
    const machines::Machine other = kinds::load(machine);
    CHECK(process::clock_paths(other, one).empty());
    CHECK(!process::clock_of(other, one).has_value());
    CHECK(!process::machine_mm2(other, {16, 1024}, one).has_value());
    CHECK(!process::frame_joules(other, {16, 1024}, {1, 1}, one).has_value());
  }
}

TEST_CASE("a wider ALU lengthens the clock period and enlarges the silicon in every process") {
  for (const std::string_view name : process::process_names()) {
    const Process one = process::load_process(std::string(name));
    double slowest = 0;
    double largest = 0;
    for (const std::string bits : {"1", "2", "4", "8", "16", "32"}) {
      const machines::Machine machine = small_machine("+alu.bits=" + bits);
      const double ps = process::clock_of(machine, one)->path.ps;
      const double mm2 = *process::machine_mm2(machine, {4096, 4096 * 64}, one);
      CHECK(ps > slowest);
      CHECK(mm2 > largest);
      slowest = ps;
      largest = mm2;
    }
  }
}
