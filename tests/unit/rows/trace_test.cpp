#include "sim/rows/trace.h"

#include <rapidcheck.h>

#include "hw/bit_serial_memory/timing_rows.h"
#include "hw/isa/opcodes.h"
#include "hw/kinds/load.h"
#include "hw/machines/kind.h"
#include "tests/support/error_of.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

/// Two bits of pixel memory at 9 x 7 pixels; the first instruction enables all pixels, the second clears bit 1.
isa::Program two_instructions(bool shows) {
  isa::Program program;
  program.shape = {9, 7, 2};
  if (shows) program.colour = {1, 1};
  program.segments.push_back({.region = {0, 0, 9, 7},
                              .instructions = {{.opcode = isa::Opcode::enable_all},
                                               {.opcode = isa::Opcode::set_constant, .fields = {isa::Field{1, 1}}}}});
  return program;
}

machines::Machine machine_named(const std::string& name) {
  machines::Machine machine = kinds::load(name + "+array.memory_bits=2");
  machines::set_picture_size(machine, {9, 7});
  return machine;
}

struct Traced {
  rows::TraceSummary summary;
  std::string text;
};

Traced trace(const isa::Program& program, const std::string& machine, const std::string& form) {
  Traced traced;
  traced.summary = rows::write_trace(program, machine_named(machine), {}, rows::form_named(form),
                                     [&](std::string_view text) { traced.text += text; });
  return traced;
}

std::string lines_from(const std::string& text, const std::string& first) { return text.substr(text.find(first)); }

class Counter final : public bit_serial_memory::RowListener {
 public:
  void refresh(std::uint64_t /*clock*/) override { ++refreshes; }
  void command(const bit_serial_memory::RowCommand& /*command*/,
               std::span<const bit_serial_memory::Issue> /*issues*/) override {
    ++commands;
  }
  std::uint64_t refreshes = 0;
  std::uint64_t commands = 0;
};

}  // namespace

TEST_CASE("the complete form lists commands with their clocks, place and operands") {
  const Traced digital = trace(two_instructions(true), "digital-bit-serial-ddr4", "csgsim");
  CHECK(
      digital.text.starts_with("csgsim-rows 1\nmachine digital-bit-serial-ddr4+array.memory_bits=2\n"
                               "clock 1200000000\npicture 9 7 0\ncolour 1 1\nslots 1 65536 16\ntiming restore 39\n"));
  // The request takes 40 clocks, and the segment's words some more. A gate takes 4 clocks, a row 39 + 17.
  const std::string segment = lines_from(digital.text, "segment 0\n");
  const std::uint64_t begin = std::stoull(segment.substr(segment.find('\n') + 1));
  const auto at = [&](std::uint64_t clocks) { return std::to_string(begin + clocks); };
  CHECK(segment.starts_with("segment 0\n" + at(0) + " 0 * - - LOGIC SA = SET0\n" + at(4) + " 0 0 - " + at(43) +
                            " WRITE 0\n" + at(60) + " 0 * - - LOGIC SA = SET0\n" + at(64) + " 0 0 - " + at(103) +
                            " WRITE 1\n"));
  // 63 pixels take a clock on the bus, 34 clocks after the activation; then tWR.
  const std::string scan_out = lines_from(digital.text, "scan_out\n");
  const std::uint64_t drawn = digital.summary.timing.clocks;
  CHECK(scan_out == fmt::format("scan_out\n{} 0 0 - {} SEND 1 bus {} 1\nend {} {}\n", drawn, drawn + 53, drawn + 34,
                                drawn, drawn + 70));
}

TEST_CASE("DRAM commands are activations, precharges and bursts of transferred rows") {
  const isa::Program program = two_instructions(true);
  const Traced power = trace(program, "ambit-ddr4", "drampower");
  const std::uint64_t drawn = power.summary.timing.clocks;
  const std::string data(128, '0');
  CHECK(power.text.ends_with(fmt::format("\n{},ACT,0,0,0,1,0\n{},RD,0,0,0,1,0,{}\n{},PRE,0,0,0,1,0\n{},END,0,0,0,0,0\n",
                                         drawn, drawn + 17, data, drawn + 53, drawn + 70)));
  CHECK(trace(program, "ambit-ddr4", "drampower4")
            .text.ends_with(
                fmt::format("\n{},ACT,0\n{},RD,0\n{},PRE,0\n{},END,0\n", drawn, drawn + 17, drawn + 53, drawn + 70)));
  const Traced recorded = trace(program, "ambit-ddr4", "ramulator2");
  CHECK(recorded.text.starts_with("clock,command,Channel,Rank,BankGroup,Bank,Row,Column,type,source\n"));
  CHECK(recorded.text.ends_with(
      fmt::format("\n{},ACT,0,0,0,0,1,-1,-1,-1\n{},RD,0,0,0,0,1,0,0,-1\n{},PREpb,0,0,0,0,-1,-1,-1,-1\n", drawn,
                  drawn + 17, drawn + 53)));
}

TEST_CASE("memory accesses have addresses in a rank of eight chips and others are rejected") {
  const isa::Program program = two_instructions(true);
  const Traced accesses = trace(program, "ambit-ddr4", "dramsim3");
  // Row 1 of bank 0: above 6 bits of a burst's bytes, 7 of bursts, 4 of banks and 1 of ranks.
  CHECK(accesses.text.ends_with(fmt::format("\n0x40000 READ {}\n", accesses.summary.timing.clocks + 17)));
  CHECK(trace(program, "ambit-ddr4", "ramulator2-accesses").text.ends_with("\nLD 0x20000\n"));
  const std::string refusal = "are those of eight chips with 16 banks";
  for (const std::string change : {"chips.count=4", "chips.banks=8", "chips.columns=4096", "chips.rows=1024"}) {
    CAPTURE(change);
    CHECK(testing::error_of([&] { trace(program, "ambit-ddr4+" + change, "dramsim3"); }).find(refusal) !=
          std::string::npos);
  }
}

TEST_CASE("a trace counts the commands that its form replaces or omits") {
  const isa::Program program = two_instructions(false);
  const auto replaced = [&](const std::string& machine, const std::string& form) {
    std::string text;
    for (const rows::Replacement& one : trace(program, machine, form).summary.replacements)
      text += fmt::format("{} {}: {}\n", one.count, one.what, one.instead);
    return text;
  };
  CHECK(replaced("digital-bit-serial-ddr4", "csgsim") == "");
  CHECK(replaced("ambit-ddr4", "csgsim") == "");
  // Clearing: two rows and E; E := 1; bit 1 := bit 1 and not E, as 2 + 4 commands, of which one raises three rows.
  CHECK(replaced("ambit-ddr4", "drampower") ==
        "10 AAP: ACT, ACT and PRE\n2 second and third rows activated together: nothing\n");
  CHECK(replaced("ambit-ddr4", "dramsim3") ==
        "10 AAP: a read and a write of one burst\n2 second and third rows activated together: nothing\n");
  CHECK(replaced("ambit-ddr4+logic.enable=1", "drampower4") ==
        "5 AAP: ACT, ACT and PRE\n1 LATCH: ACT and PRE\n1 masks of writes: nothing\n");
}

TEST_CASE("a machine without row commands is rejected") {
  CHECK(testing::error_of([] {
          rows::write_trace(two_instructions(false), kinds::load("pixel-planes-4"), {}, rows::form_named("csgsim"),
                            [](std::string_view) {});
        }).find("pixel-planes-4 has no row commands; choose a machine of kind bit-serial-memory") == 0);
}

TEST_CASE("a traced frame has the clocks and counts of the kind's timing") {
  for (const std::string name :
       {"ambit-ddr4+chips.columns=1", "simdram-ddr4", "digital-bit-serial-ddr4+chips.columns=2"}) {
    CAPTURE(name);
    CHECK(rc::check("the timings of " + name + " are equal", [&] {
      machines::Machine machine =
          kinds::load(name + "+array.memory_bits=32+picture.width=7+picture.height=6+timing.refresh_interval=2000");
      const isa::Program program = *test::arbitrary_program_in_parts(machine, 12, 1);
      Counter counter;
      const machines::FrameTiming traced = bit_serial_memory::time_rows(program, machine, {}, counter);
      const machines::FrameTiming timing = machine.kind->time(program, machine, {});
      RC_ASSERT(traced.clocks == timing.clocks);
      RC_ASSERT(traced.shown_clocks == timing.shown_clocks);
      RC_ASSERT(counter.commands == timing.account.count("row_commands"));
      RC_ASSERT(counter.refreshes == timing.account.count("refreshes"));
    }));
  }
}
