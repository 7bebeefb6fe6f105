#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/machines/kind.h"
#include "hw/machines/timing.h"
#include "hw/systemc/kernel.h"
#include "tests/support/test.h"
#include "tests/unit/bit_serial_memory/clocked.h"

// Hand calculation of a frame of the smallest memory, clock by clock: total clocks, account and wave.
//
// Ten clocks after the request, which is at 0, the host sends SegmentStart (6 + 4 * 16 bits in two words of three
// clocks) and then commands of one word each. The queue has one entry. A command is accepted at the earliest one clock
// after its last word, and accepting it takes one clock. A gate takes 4 clocks, a row 39 + 17, the wired OR 20; SEND
// takes 34 clocks, 64 bits in 4 clocks, and 18 + 17 clocks, in total 73.
//
// clear accepted at 17; SET0 and WRITE of eight bits, and SET0 of E: 1 + 8 * 60 + 4 clocks, until 502
// 0 enable_all sent from 17 to 20; 1 + 4, until 507
// 1 enable_invert sent from 502 to 505; until 512
// 2 skip_if_none sent from 507 to 510; a gate and the OR: 1 + 4 + 20, until 537
// 3 sent from 512 to 515; discarded
// 4 waits for a free entry from 515
// 5 global_or requested at 537: sent from 547 to 550, accepted at 551; 1 + 4 + 20, until 576
// FrameEnd sent from 551, when 5 has left the queue, to 554
// the picture four rows: 4 * 73, until 868

using namespace csgsim;
using testing::ClockedMemory;
using testing::Recording;

namespace {

constexpr std::uint64_t drawn = 576;
constexpr std::uint64_t shown = drawn + 4 * 73;

isa::Program frame() {
  using isa::Opcode;
  const isa::Instruction all{.opcode = Opcode::enable_all};
  isa::Program program;
  program.shape = {8, 8, 8};
  program.colour = {2, 4};
  program.facts->fields = {{"colour", {2, 4}}};
  program.segments.push_back({.region = {0, 0, 8, 8},
                              .instructions = {all,
                                               {.opcode = Opcode::enable_invert},
                                               {.opcode = Opcode::skip_if_none, .constant = 2},
                                               all,
                                               all,
                                               {.opcode = Opcode::global_or}}});
  return program;
}

const machines::Skip skip{0, 2};

std::uint64_t of_part(const machines::Account& account, std::string_view part, std::string_view activity) {
  return machines::clocks_of(account, part, activity);
}

void check_account(const machines::Account& account) {
  CHECK(of_part(account, "controller", "starved") == 17);
  CHECK(of_part(account, "controller", "clearing") == 485);
  CHECK(of_part(account, "controller", "issuing") == 5 + 5);
  CHECK(of_part(account, "controller", "answering") == 25 + 25);
  CHECK(of_part(account, "controller", "jumping") == 14);
  CHECK(of_part(account, "controller", "refreshing") == 0);
  CHECK(of_part(account, "host link", "sending") == 6 + 6 * 3);
  CHECK(of_part(account, "host link", "waiting") == drawn - 24);
  CHECK(account.count("scan_out_clocks") == 292);
  // 8 * 2 + 1 for the clear, then 1, 1, 2 and 2, and four SEND.
  CHECK(account.count("row_commands") == 17 + 6 + 4);
  CHECK(account.count("activations") == 8 + 4);
  CHECK(account.count("further_rows") == 0);
  CHECK(account.count("logic_commands") == 9 + 1 + 1 + 1 + 1);
  CHECK(account.count("leaf_commands") == 0);
  CHECK(account.count("transferred_bits") == 4 * 64);
  CHECK(account.count("refreshes") == 0);
}

/// Changes of a tap: the first clock of each value and the value.
std::vector<std::string> changes_of(const std::vector<std::string>& values) {
  std::vector<std::string> changes;
  for (std::size_t clock = 0; clock < values.size(); ++clock)
    if (clock == 0 || values[clock] != values[clock - 1]) changes.push_back(fmt::format("{} {}", clock, values[clock]));
  return changes;
}

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("a frame with a jump takes hand-calculated clocks and work at both levels") {
  const ClockedMemory& memory = testing::smallest_memory();
  const isa::Program program = frame();
  const machines::FrameTiming timing =
      memory.machine.kind->time(program, memory.machine, machines::RunOutcome{{&skip, 1}, {}});
  CHECK(timing.clocks == drawn);
  CHECK(timing.shown_clocks == shown);
  check_account(timing.account);
  systemc::RunListener no_listener;
  const systemc::RunReport report = memory.hardware->run(program, no_listener);
  CHECK(report.clocks == drawn);
  CHECK(report.shown_clocks == shown);
  CHECK(report.skipped == 2);
  CHECK(report.answers == std::vector<bool>{false});
  check_account(report.account);
}

TEST_CASE("the timeline and work of a frame with a jump match the hand calculation") {
  const machines::Machine& machine = testing::smallest_memory().machine;
  const isa::Program program = frame();
  const machines::RunOutcome outcome{{&skip, 1}, {}};
  const auto timeline = machine.kind->timeline(program, machine, outcome);
  REQUIRE(timeline.has_value());
  CHECK(timeline->cleared == std::vector<machines::ClockSpan>{{17, 502}});
  CHECK(timeline->issued ==
        std::vector<std::vector<machines::ClockSpan>>{{{502, 507}, {507, 512}, {512, 537}, {}, {}, {551, 576}}});
  CHECK(machine.kind->spans_at_pixel(*timeline, program, machine, 0, 7, 7) == timeline->issued[0]);
  std::vector<std::string> loads;
  for (const machines::Load& load : machine.kind->loads(machine.kind->time(program, machine, outcome)))
    loads.push_back(fmt::format("{} {}", load.part, load.clocks));
  CHECK(loads == Lines{"rank of chips 10", "clearing of the rows 485", "reads of all enable bits 50", "refresh 0",
                       "jumps of the host 14", "link from the host 24", "scan-out 292"});
}

TEST_CASE("a wave of a memory shows the states of all units in each clock") {
  const Recording wave(testing::smallest_memory(), frame(), {{3, 2}}, {0, shown});
  CHECK(changes_of(wave.of("host.state")) == Lines{"0 waiting", "10 sending", "16 blocked", "17 sending", "20 blocked",
                                                   "502 sending", "505 blocked", "507 sending", "510 blocked",
                                                   "512 sending", "515 blocked", "537 waiting", "547 sending",
                                                   "550 blocked", "551 sending", "554 "});
  CHECK(changes_of(wave.of("controller.state")) ==
        Lines{"0 waiting", "17 clearing", "502 issuing", "537 waiting", "551 issuing", "576 scanning out"});
  CHECK(changes_of(wave.of("controller.instruction")) ==
        Lines{"0 ", "502 0", "507 1", "512 2", "537 ", "551 5", "576 "});
  Lines commands{"0 "};
  for (unsigned bit = 0; bit < 8; ++bit) {
    commands.push_back(fmt::format("{} LOGIC SA = SET0", 18 + 60 * bit));
    commands.push_back(fmt::format("{} WRITE {}", 22 + 60 * bit, bit));
  }
  for (const char* const line : {"498 LOGIC R4 = SET0", "502 ", "503 LOGIC R4 = SET1", "507 ", "508 LOGIC R4 = NOT R4",
                                 "512 ", "513 LOGIC SA = MOVE R4", "517 OR", "537 ", "552 LOGIC SA = MOVE R4", "556 OR",
                                 "576 SEND 2", "649 SEND 3", "722 SEND 4", "795 SEND 5"})
    commands.emplace_back(line);
  CHECK(changes_of(wave.of("controller.row_command")) == commands);
  CHECK(changes_of(wave.of("bank_0.busy")) ==
        Lines{"0 0", "18 1", "502 0", "503 1", "507 0", "508 1", "512 0", "513 1", "537 0", "552 1"});
}

TEST_CASE("a wave of a memory shows a pixel's values only after the memory is cleared") {
  for (int frames = 0; frames < 2; ++frames) {
    const Recording wave(testing::smallest_memory(), frame(), {{3, 2}}, {0, shown});
    const std::vector<std::string>& enable = wave.of("pixel_3_2.enable");
    CHECK(wave.count("pixel_3_2.enable", "") == 502);
    CHECK(enable[501] == "");
    CHECK(enable[502] == "0");
    CHECK(enable[506] == "1");
    CHECK(enable[511] == "0");
    CHECK(wave.of("pixel_3_2.colour")[501] == "");
    CHECK(wave.of("pixel_3_2.colour")[502] == "0");
    CHECK(changes_of(wave.of("pixel_3_2.instruction")) == changes_of(wave.of("controller.instruction")));
  }
}

TEST_CASE("a wave of a memory shows the requested pixels and one tap per bank") {
  for (const ClockedMemory& memory : testing::clocked_memories()) {
    CAPTURE(memory.name);
    const machines::Size size = memory.machine.picture;
    isa::Program program;
    program.shape = {size.width, size.height, memory.machine.array.memory_bits};
    // There are fewer than 256 pixels, so the eight bits of F hold the pixel number and fit in the smallest memory.
    const auto base = static_cast<std::uint16_t>(program.shape.memory_bits - 8);
    program.facts->fields = {{"number", {base, 8}}, {"third bit", {static_cast<std::uint16_t>(base + 2), 1}}};
    const isa::Linear number{.a = 1, .b = size.width, .c = 0, .width = 10, .shift = 0};
    const isa::Linear below_100{.a = 1, .b = size.width, .c = -100, .width = 10, .shift = 0};
    program.segments.push_back(
        {.region = {0, 0, size.width, size.height},
         .instructions = {{.opcode = isa::Opcode::enable_all},
                          {.opcode = isa::Opcode::load_linear, .fields = {{{base, 8}}}, .linear = number},
                          {.opcode = isa::Opcode::edge_negative, .linear = below_100}}});
    const std::vector<wave::Pixel> pixels{
        {0, 0}, {size.width - 1, 0}, {0, size.height - 1}, {size.width - 1, size.height - 1}, {2, 1}};
    systemc::RunListener no_listener;
    const std::uint64_t clocks = memory.hardware->run(program, no_listener).clocks;
    const Recording wave(memory, program, pixels, {clocks - 60, clocks});
    for (const wave::Pixel& pixel : pixels) {
      const std::uint32_t expected = pixel.y * size.width + pixel.x;
      const std::string part = fmt::format("pixel_{}_{}.", pixel.x, pixel.y);
      CHECK(wave.of(part + "number").back() == fmt::format("{}", expected));
      CHECK(wave.of(part + "third_bit").back() == fmt::format("{}", expected / 4 % 2));
      CHECK(wave.of(part + "enable").back() == (expected < 100 ? "1" : "0"));
    }
    // Three taps, six for the controller's instruction, one per bank, and nine per pixel: six, E and two fields.
    const std::uint32_t banks = bit_serial_memory::slots_of(memory.machine).used_banks();
    CHECK(wave.names().size() == 3 + 6 + banks + pixels.size() * (6 + 1 + 2));
  }
}

TEST_CASE("controller states in a wave match the account and include refreshes") {
  const isa::Instruction all{.opcode = isa::Opcode::enable_all};
  const isa::Instruction set{.opcode = isa::Opcode::set_constant, .fields = {{{0, 6}}}, .constant = 37};
  const isa::Instruction query{.opcode = isa::Opcode::skip_if_none, .constant = 1};
  for (const ClockedMemory& memory : testing::clocked_memories()) {
    CAPTURE(memory.name);
    isa::Program program;
    program.shape = {memory.machine.picture.width, memory.machine.picture.height, memory.machine.array.memory_bits};
    program.colour = {0, 8};
    program.segments.push_back({.region = {0, 0, program.shape.width, program.shape.height},
                                .instructions = {query, all, set, query, set, {.opcode = isa::Opcode::global_or}}});
    systemc::RunListener no_listener;
    const systemc::RunReport report = memory.hardware->run(program, no_listener);
    const Recording wave(memory, program, {}, {0, report.shown_clocks});
    const auto count = [&](const std::string& state) { return wave.count("controller.state", state); };
    const auto spent = [&](std::string_view activity) { return of_part(report.account, "controller", activity); };
    CHECK(count("waiting") == spent("starved") + spent("jumping"));
    CHECK(count("clearing") == spent("clearing"));
    CHECK(count("issuing") == spent("issuing") + spent("answering"));
    CHECK(count("scanning out") + count("refreshing") == spent("refreshing") + report.account.count("scan_out_clocks"));
    CHECK(count("refreshing") >= spent("refreshing"));
    CHECK(wave.count("host.state", "sending") == of_part(report.account, "host link", "sending"));
    // The clear alone opens a row per bit for 39 + 17 clocks.
    for (std::uint32_t bank = 0; bank < bit_serial_memory::slots_of(memory.machine).used_banks(); ++bank)
      CHECK(wave.count(fmt::format("bank_{}.busy", bank), "1") >= program.shape.memory_bits * (39 + 17));
  }
}

TEST_CASE("rejects a request for tree levels in a wave of a memory") {
  const isa::Program program = frame();
  const wave::Request request{
      .windows = {{0, 1}}, .pixels = {{0, 0}}, .tree_levels = {{wave::TreeLevel::Axis::x, 0}}, .write = nullptr};
  CHECK_THROWS_WITH_AS(static_cast<void>(testing::smallest_memory().hardware->taps(program, request)),
                       "waves of a bit-serial memory show no tree levels; omit the tree levels", InputError);
}