#include "hw/machines/machine.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "hw/isa/opcodes.h"
#include "hw/kinds/load.h"
#include "hw/kinds/rows.h"
#include "hw/machines/area.h"
#include "hw/machines/description.h"
#include "hw/machines/regions.h"
#include "hw/machines/runs_on.h"
#include "hw/machines/schema.h"
#include "hw/pixel_planes/figures.h"
#include "places.h"
#include "tests/support/place_in.h"

using namespace csgsim;
using machines::Figure;
using machines::Machine;
using machines::read_description;

namespace {

std::string description_of(std::string_view machine) {
  for (const machines::BuiltIn& one : kinds::built_in())
    if (one.name == machine) return std::string(one.text);
  FAIL("no built-in machine has this name");
  return {};
}

/// Returns the description of Pixel-planes with one piece of its text replaced.
std::string changed(std::string_view from, std::string_view to) {
  std::string text = description_of("pixel-planes-4");
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  text.replace(at, from.size(), to);
  return text;
}

/// Returns the error message of reading the text.
std::string message(std::string_view text) {
  try {
    read_description(text, "my.toml", kinds::all());
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string message_of_change(std::string_view from, std::string_view to) { return message(changed(from, to)); }

}  // namespace

TEST_CASE("a pixel's transistors are those of logic and memory or unknown if unsynthesized") {
  Machine machine = kinds::load("pixel-planes-4");
  const std::uint64_t logic = *machines::pixel_transistors(machine, 0);
  CHECK(logic > 100);
  CHECK(machines::pixel_transistors(machine, 72) == logic + std::uint64_t{3 * 72});
  machine.memory_reads = 2;
  CHECK(*machines::pixel_transistors(machine, 100) == *machines::pixel_transistors(machine, 0) + 5 * 100);
  machine.memory_reads = 1;
  machine.alu_bits = 3;
  CHECK(machines::pixel_transistors(machine, 72) == std::nullopt);
  CHECK(machines::pixel_transistors(kinds::load("pixel-square"), 72) == logic + std::uint64_t{3 * 72});
  CHECK(machines::pixel_transistors(kinds::load("scan-line"), 72) == std::nullopt);
  CHECK(machines::pixel_transistors(kinds::load("multi-processor"), 72) == std::nullopt);
}

TEST_CASE("processor and node transistors match the table in docs/hardware.md") {
  struct Row {
    std::uint32_t alu_bits;
    std::uint32_t reads;
    std::uint32_t degree;
    std::uint64_t logic;
  };
  // docs/hardware.md, "A pixel with its memory".
  const std::vector<Row> rows{{1, 1, 1, 434},  {1, 2, 1, 388},  {2, 1, 1, 670},  {2, 2, 1, 586}, {4, 1, 1, 1160},
                              {4, 2, 1, 1024}, {8, 1, 1, 2196}, {8, 2, 1, 2054}, {1, 1, 2, 650}, {1, 2, 2, 608}};
  Machine machine = kinds::load("pixel-planes-4");
  for (const Row& row : rows) {
    machine.alu_bits = row.alu_bits;
    machine.memory_reads = row.reads;
    machine.evaluator_degree = row.degree;
    CHECK(machines::pixel_transistors(machine, 0) == row.logic);
  }
}

TEST_CASE("a pixel has more transistors with a wider ALU or with quadratic expressions") {
  Machine machine = kinds::load("pixel-planes-4");
  for (const std::uint32_t reads : {1U, 2U}) {
    machine.memory_reads = reads;
    std::array<std::uint64_t, 2> narrower{};
    for (const std::uint32_t alu_bits : {1U, 2U, 4U, 8U, 16U, 32U}) {
      machine.alu_bits = alu_bits;
      machine.evaluator_degree = 1;
      const std::uint64_t linear = machines::pixel_transistors(machine, 0).value();
      machine.evaluator_degree = 2;
      const std::uint64_t quadratic = machines::pixel_transistors(machine, 0).value();
      CHECK(linear > narrower[0]);
      CHECK(quadratic > narrower[1]);
      CHECK(quadratic > linear);
      narrower = {linear, quadratic};
    }
  }
}

TEST_CASE("quadratics and the root flag enlarge a pixel by about the published share") {
  const Machine machine = kinds::load("pixel-powers");
  Machine linear = machine;
  linear.evaluator_degree = 1;
  const auto with = static_cast<double>(*machines::pixel_transistors(machine, 72));
  const auto without = static_cast<double>(*machines::pixel_transistors(linear, 72));
  CHECK(*machines::pixel_transistors(linear, 72) == *machines::pixel_transistors(kinds::load("pixel-planes-4"), 72));
  // Goldfeather and Fuchs 1986: about 35 % more than the chip of Pixel-planes 4, whose pixels have 72 bits.
  CHECK(with / without > 1.25);
  CHECK(with / without < 1.45);
}

TEST_CASE("the built-in pixel-planes-4 has the published array and clock and ports") {
  const Machine machine = kinds::load("pixel-planes-4");
  CHECK(machine.name == "pixel-planes-4");
  CHECK(machine.array == isa::ArrayShape{512, 512, 72});
  CHECK(machine.clock_hz == 10'000'000);
  CHECK(machine.memory_reads == 1);
  CHECK(machine.alu_bits == 1);
  CHECK(machines::kind_figures<pixel_planes::Figures>(machine).has_global_or);
}

TEST_CASE("every built-in machine has the name by which it is loaded") {
  for (const std::string_view name : kinds::built_in_names()) {
    CAPTURE(name);
    const Machine machine = kinds::load(std::string(name));
    CHECK(machine.name == name);
    CHECK(machine.figures.size() == machine.kind->schema.size());
  }
}

TEST_CASE("multi-machine studies cover every built-in machine except bit-serial memories") {
  std::vector<std::string_view> names = kinds::built_in_names();
  std::erase_if(names,
                [](std::string_view name) { return kinds::load(std::string(name)).kind->name == "bit-serial-memory"; });
  CHECK(names == kinds::studied_names());
}

TEST_CASE("a machine's parameters have the file's order with unit and provenance and source") {
  const Machine machine = kinds::load("pixel-planes-4");
  std::string keys;
  for (const Figure& figure : machine.figures) {
    keys += figure.key + ' ';
    CHECK((figure.provenance == "published" || figure.provenance == "assumed"));
    CHECK(figure.unit.empty() ==
          (figure.key == "scan_out.port" || figure.key == "evaluator.degree" || figure.key == "host.processor"));
    CHECK_FALSE(figure.source.empty());
  }
  CHECK(keys ==
        "array.width array.height array.memory_bits clock.frequency alu.bits memory.reads memory.writes "
        "global_or.present global_or.fan_in scan_out.pixels scan_out.port scan_out.buffers evaluator.level_latency "
        "evaluator.degree evaluator.bits evaluator.register_levels "
        "memory.clear_clocks link.width link.word_clocks "
        "link.fifo_depth link.latency host.processor host.count ");
  CHECK(machine.figures[3].value == "10000000");
  CHECK(machine.figures[3].unit == "Hz");
}

TEST_CASE("a machine file is loaded by path whatever its name") {
  const std::string path = std::string(CSGSIM_BINARY_DIR) + "/machine_test_two_reads.toml";
  std::ofstream(path) << changed("[memory.reads]\nvalue = 1", "[memory.reads]\nvalue = 2");
  CHECK(kinds::load(path).memory_reads == 2);
}

TEST_CASE("the ALU width is read from a machine file") {
  CHECK(
      read_description(changed("[alu.bits]\nvalue = 1", "[alu.bits]\nvalue = 16"), "my.toml", kinds::all()).alu_bits ==
      16);
}

TEST_CASE("the tree bits per clock are read from a machine file up to the ALU width") {
  const std::string trees = "[evaluator.bits]\nvalue = ";
  CHECK(read_description(changed(trees + "1", trees + "1"), "my.toml", kinds::all()).evaluator_bits == 1);
  std::string wide = changed("[alu.bits]\nvalue = 1", "[alu.bits]\nvalue = 8");
  wide.replace(wide.find(trees + "1"), trees.size() + 1, trees + "8");
  CHECK(read_description(wide, "my.toml", kinds::all()).evaluator_bits == 8);
  const std::string text = changed(trees + "1", trees + "2");
  const auto line = 1 + std::ranges::count(text.substr(0, text.find(trees)), '\n');
  CHECK(message_of_change(trees + "1", trees + "2") ==
        fmt::format(
            "my.toml:{}:1: evaluator.bits is 2 and alu.bits 1: the ALU must process all bits that the trees deliver "
            "in a clock; make evaluator.bits at most 1, or alu.bits at least 2",
            line));
  for (const std::string name : {"pixel-planes-4", "pixel-square", "pixel-planes-5", "pixel-powers"}) {
    CAPTURE(name);
    CHECK(kinds::load(name + "+evaluator.bits=3+alu.bits=3").evaluator_bits == 3);
    CHECK_THROWS_AS(kinds::load(name + "+alu.bits=3+evaluator.bits=4"), InputError);
  }
}

TEST_CASE("global_or.present accepts only 0 and 1") {
  const Machine without = read_description(changed("[global_or.present]\nvalue = 1", "[global_or.present]\nvalue = 0"),
                                           "my.toml", kinds::all());
  CHECK_FALSE(machines::kind_figures<pixel_planes::Figures>(without).has_global_or);
  CHECK(message_of_change("[global_or.present]\nvalue = 1", "[global_or.present]\nvalue = 2")
            .ends_with("global_or.present is 2; it must be 0 to 1 lines"));
}

TEST_CASE("rejects an unknown machine and suggests the nearest name") {
  CHECK_THROWS_WITH_AS(
      kinds::load("pixel-plane-4"),
      fmt::format(
          "there is no machine 'pixel-plane-4'; did you mean pixel-planes-4? The machines are {}; the name of a "
          "machine file must end in .toml",
          fmt::join(kinds::built_in_names(), ", "))
          .c_str(),
      InputError);
  CHECK_THROWS_WITH_AS(kinds::load("none/such.toml"),
                       "none/such.toml: cannot be read: No such file or directory; check the path and its permissions",
                       InputError);
}

TEST_CASE("an unknown key in a machine file is rejected with its place and the nearest key") {
  const std::string group = changed("[clock.frequency]", "[clok.frequency]");
  CHECK(message(group) == testing::place_in(group, "clok") + ": unknown key 'clok'; the nearest known is 'clock'");
  const std::string figure = changed("[array.memory_bits]", "[array.memory_bit]");
  CHECK(message(figure) == testing::place_in(figure, "memory_bit]") +
                               ": unknown key 'array.memory_bit'; the nearest known is 'array.memory_bits'");
  const std::string part = changed("[array.width]\nvalue", "[array.width]\nvalu");
  CHECK(message(part) == testing::place_in(part, "valu =") +
                             ": unknown key 'array.width.valu'; the nearest known is 'array.width.value'");
}

TEST_CASE("a wrong type in a machine file is rejected with its place") {
  const std::string number = changed("value = 72", "value = 72.5");
  CHECK(message(number) ==
        testing::place_in(number, "72.5") + ": array.memory_bits is a number with a point; make it an integer");
  const std::string text = changed("unit = \"Hz\"", "unit = 7");
  CHECK(message(text) == testing::place_in(text, "7\nprovenance") + ": 'unit' is an integer; make it a string");
  const std::string plain = "name = \"x\"\ndescription = \"y\"\nkind = \"frame-buffer\"\narray = 3\n";
  CHECK(message(plain) == testing::place_in(plain, "3") + ": 'array' is an integer; make it a table");
}

TEST_CASE("out-of-range values and wrong units in a machine file are rejected with a place") {
  const std::string big = changed("value = 72", "value = 4097");
  CHECK(message(big) == testing::place_in(big, "4097") + ": array.memory_bits is 4097; it must be 1 to 4096 bits");
  CHECK(message_of_change("value = 512", "value = 0").ends_with("array.width is 0; it must be 1 to 16384 pixels"));
  CHECK(message_of_change("[alu.bits]\nvalue = 1", "[alu.bits]\nvalue = 33")
            .ends_with("alu.bits is 33; it must be 1 to 32 bits"));
  CHECK(message_of_change("[memory.writes]\nvalue = 1", "[memory.writes]\nvalue = 2")
            .ends_with("memory.writes is 2; the simulator supports only 1"));
  const std::string unit = changed("unit = \"Hz\"", "unit = \"MHz\"");
  CHECK(message(unit) == testing::place_in(unit, "\"MHz\"") + ": clock.frequency has the unit 'MHz'; write 'Hz'");
  const std::string provenance = changed("provenance = \"assumed\"", "provenance = \"guessed\"");
  CHECK(message(provenance) == testing::place_in(provenance, "\"guessed\"") +
                                   ": memory.reads has the provenance 'guessed'; write 'published' or 'assumed'");
}

TEST_CASE("every assumed number of a built-in machine has a range with a reason") {
  for (const std::string_view name : kinds::built_in_names()) {
    const Machine machine = kinds::load(std::string(name));
    for (const Figure& figure : machine.figures) {
      CAPTURE(name);
      CAPTURE(figure.key);
      const bool is_number = figure.value.find_first_not_of("0123456789") == std::string::npos;
      const bool is_guess = figure.provenance == "assumed" && is_number;
      if (is_guess) CHECK(figure.range.has_value());
      if (!figure.range) continue;
      CHECK(figure.range->reason.size() > 10);
      if (is_number)
        CHECK((figure.range->low <= std::stoll(figure.value) && std::stoll(figure.value) <= figure.range->high));
    }
  }
}

TEST_CASE("a range in a machine file is complete and ordered and within the limits") {
  const std::string source = "[array.memory_bits]\nvalue = 72\n";
  const auto with = [&](const std::string& lines) { return changed(source, source + lines); };
  const std::string limits = "low = 64\nhigh = 0x80\nrange = \"chips of the time\"\n";
  const Machine machine = read_description(with(limits), "my.toml", kinds::all());
  REQUIRE(machine.figures[2].range.has_value());
  CHECK(machine.figures[2].range->low == 64);
  CHECK(machine.figures[2].range->high == 128);
  CHECK(machine.figures[2].range->reason == "chips of the time");
  const std::vector<std::string> changes = {"array.memory_bits=100"};
  CHECK_FALSE(read_description(with(limits), "my.toml", kinds::all(), changes).figures[2].range.has_value());
  CHECK(message(with("low = 64\nhigh = 128\n"))
            .ends_with("array.memory_bits has 'low' but no 'range'; give low, high and the reason, range"));
  CHECK(message(with("range = \"why\"\n"))
            .ends_with("array.memory_bits has 'range' but no 'low'; give low, high and the reason, range"));
  CHECK(message(with("low = 73\nhigh = 72\nrange = \"why\"\n"))
            .ends_with("the range of array.memory_bits is 73 to 72; make low at most high"));
  CHECK(message(with("low = 0\nhigh = 128\nrange = \"why\"\n"))
            .ends_with("array.memory_bits is 0; it must be 1 to 4096 bits"));
  const std::string word = changed("[scan_out.port]\n", "[scan_out.port]\nlow = 1\nhigh = 2\nrange = \"why\"\n");
  CHECK(message(word).ends_with("scan_out.port is a word, which has no range; remove 'low'"));
}

TEST_CASE("the error for a missing key in a machine file names the key") {
  CHECK(message_of_change("name = \"pixel-planes-4\"", "").ends_with("key 'name' is missing; add name = \"...\""));
  CHECK(message_of_change("value = 72\n", "").ends_with("array.memory_bits has no value; add value = ..."));
  CHECK(message("name = \"x\"\ndescription = \"y\"\n").ends_with("key 'kind' is missing; add kind = \"...\""));
  const std::string text = "name = \"x\"\ndescription = \"y\"\nkind = \"frame-buffer\"\n";
  CHECK(message(text) ==
        "my.toml:1:1: key 'array.width' is missing; add a table [array.width] with value, unit, provenance and source");
}

TEST_CASE("a parameter that belongs to another kind of machine is rejected") {
  const std::string text = changed("[memory.writes]", "[refresh.rate]");
  CHECK(
      message(text).starts_with(testing::place_in(text, "refresh.rate") +
                                ": unknown key 'refresh'; the keys here are name, description, kind, array, clock, "));
}

TEST_CASE("the error for an unknown kind or square order lists the valid names") {
  std::string names;
  for (const machines::Kind* const one : kinds::all()) names += (names.empty() ? "" : ", ") + std::string(one->name);
  CHECK(names.starts_with("frame-buffer, scan-line, pixel-square"));
  const std::string kind = changed("\"frame-buffer\"", "\"frame\"");
  CHECK(message(kind) == testing::place_in(kind, "\"frame\"") + ": unknown kind 'frame'; the kinds are " + names);
  std::string order = description_of("pixel-square");
  order.replace(order.find("value = \"rows\""), 14, "value = \"columns\"");
  CHECK(message(order) == testing::place_in(order, "\"columns\"") +
                              ": divider.order is 'columns'; it must be one of rows, serpentine, morton");
}

TEST_CASE("a scan-line machine whose picture is wider than its chain is rejected") {
  std::string text = description_of("scan-line");
  text.replace(text.find("value = 512"), 11, "value = 511");
  CHECK(message(text).find("a line of 512 pixels exceeds the 511 cells of scan-line") != std::string::npos);
}

TEST_CASE("a machine file's key of very many parts is rejected without exhausting the stack") {
  std::string key = "a";
  for (int i = 0; i < 400'000; ++i) key += ".a";
  CHECK(message("\n" + key + " = 1\n").starts_with("my.toml:2:1: more than 50 dots in a line"));
  CHECK(message("[" + key + "]\n").starts_with("my.toml:1:1: more than 50 dots in a line"));
}

TEST_CASE("a machine file's keys and nested values are accepted at the allowed limits") {
  const std::string key = [] {
    std::string parts = "a";
    for (int i = 0; i < 50; ++i) parts += ".a";
    return parts;
  }();
  std::string text = key + " = [\n";
  for (int i = 0; i < 125; ++i) text += "{ " + key + " = [\n";
  CHECK(message(text).starts_with("my.toml:"));
}

TEST_CASE("the error for a machine file that is not TOML states the place") {
  CHECK(message("name = \"x\"\nwidth = = 3\n").starts_with("my.toml:2:9: "));
}

TEST_CASE("parameters changed after a machine's name appear in it and count as assumed") {
  const Machine plain = kinds::load("pixel-square");
  const Machine other = kinds::load("pixel-square+divider.kind=host+array.memory_bits=100");
  CHECK(other.name == "pixel-square+divider.kind=host+array.memory_bits=100");
  CHECK(other.array.memory_bits == 100);
  CHECK(machines::division(plain).has_value());
  CHECK_FALSE(machines::division(other).has_value());
  const auto figure = std::find_if(other.figures.begin(), other.figures.end(),
                                   [](const machines::Figure& one) { return one.key == "array.memory_bits"; });
  REQUIRE(figure != other.figures.end());
  CHECK(figure->value == "100");
  CHECK(figure->provenance == "assumed");
  CHECK(kinds::file_of("a/my.toml+array.width=8") == "a/my.toml");
  CHECK(kinds::file_of("pixel-square+divider.kind=host").empty());
}

TEST_CASE("a change of an unknown parameter or to an invalid value is rejected") {
  CHECK_THROWS_WITH_AS(kinds::load("pixel-square+divider.kin=host"),
                       "pixel-square: unknown parameter 'divider.kin'; the nearest known is 'divider.kind'",
                       csgsim::InputError);
  CHECK_THROWS_AS(kinds::load("pixel-square+divider.kind=hots"), csgsim::InputError);
  CHECK_THROWS_AS(kinds::load("pixel-square+divider.kind"), csgsim::InputError);
  CHECK_THROWS_AS(kinds::load("pixel-square+"), csgsim::InputError);
  CHECK_THROWS_AS(kinds::load("pixel-planes-4+array.memory_bits=0"), csgsim::InputError);
}

TEST_CASE("a degree-1 machine rejects squares and suggests a machine that supports them") {
  isa::Program program;
  program.shape = {8, 4, 16};
  const isa::Linear wide{.a = 1, .width = 9};
  program.segments = {{.region = {0, 0, 8, 4},
                       .instructions = {{.opcode = isa::Opcode::enable_all},
                                        {.opcode = isa::Opcode::squares, .linear = wide},
                                        {.opcode = isa::Opcode::edge_negative, .linear = wide}}}};
  Machine machine = kinds::load("pixel-planes-4");
  machines::adopt_shape(machine, program);
  CHECK_THROWS_WITH_AS(
      machines::check_runs_on(program, machine),
      "segment 0, instruction 1: squares needs quadratic expressions, which the machine pixel-planes-4 "
      "does not have; compile the model for this machine, or use one with evaluator.degree = 2, such "
      "as pixel-powers",
      InputError);
  for (const std::string name : {"pixel-powers", "pixel-planes-4+evaluator.degree=2"}) {
    machine = kinds::load(name);
    machines::adopt_shape(machine, program);
    CHECK_NOTHROW(machines::check_runs_on(program, machine));
  }
  program.segments.front().instructions.erase(program.segments.front().instructions.begin() + 1);
  machine = kinds::load("pixel-planes-4");
  machines::adopt_shape(machine, program);
  CHECK_NOTHROW(machines::check_runs_on(program, machine));
}

TEST_CASE("expressions are of degree 2 only on machines documented to have them") {
  for (const std::string_view name : kinds::built_in_names()) {
    CAPTURE(name);
    const bool quadratic = name == "pixel-powers" || name == "pixel-planes-5";
    CHECK(kinds::load(std::string(name)).evaluator_degree == (quadratic ? 2 : 1));
  }
}

TEST_CASE("a Program's machine record rebuilds the machine including changed parameters") {
  std::vector<std::string> names{"pixel-planes-4+array.memory_bits=96+alu.bits=4", "scan-line+link.latency=ideal",
                                 "pixel-square+divider.kind=host", "digital-bit-serial-ddr4+logic.expressions=trees"};
  for (const std::string_view name : kinds::built_in_names()) names.emplace_back(name);
  for (const std::string& name : names) {
    CAPTURE(name);
    const Machine machine = kinds::load(name);
    const isa::MachineRecord record = machines::machine_record(machine);
    const Machine again = kinds::load(record);
    CHECK(record.figures.size() == machine.kind->schema.size());
    CHECK(again.name == machine.name);
    CHECK(machines::is_same_hardware(again, machine));
    CHECK((machines::machine_record(again) == record));
  }
}

TEST_CASE("a Program's recorded parameters take precedence over csgsim's current ones") {
  isa::MachineRecord record = machines::machine_record(kinds::load("pixel-planes-4"));
  for (std::string& figure : record.figures)
    if (figure == "alu.bits=1") figure = "alu.bits=2";
  const Machine machine = kinds::load(record);
  CHECK(machine.alu_bits == 2);
  CHECK(machine.name == "pixel-planes-4+alu.bits=2");
  CHECK(machines::figure_differences(machine, kinds::load("pixel-planes-4")) ==
        std::vector<std::string>{"alu.bits 2 instead of 1"});
  CHECK(kinds::load(record, {"alu.bits=4"}).alu_bits == 4);
}

TEST_CASE("an unknown machine is rebuilt from a complete set of parameters only") {
  isa::MachineRecord record = machines::machine_record(kinds::load("scan-line+clock.frequency=12000000"));
  record.name = "my lines";
  const Machine machine = kinds::load(record);
  CHECK(machine.name == "my lines");
  CHECK(machine.clock_hz == 12'000'000);
  CHECK(machine.kind->name == "scan-line");
  record.figures.pop_back();
  CHECK_THROWS_AS(kinds::load(record), csgsim::InputError);
  CHECK_THROWS_AS(kinds::load(isa::MachineRecord{"/dev/null.toml", "", {}}), csgsim::InputError);
  CHECK_THROWS_AS(kinds::load(isa::MachineRecord{"scan-line", "frame-buffer", {}}), csgsim::InputError);
  CHECK_THROWS_AS(kinds::load(isa::MachineRecord{"scan-line", "", {"no.figure=1"}}), csgsim::InputError);
}
