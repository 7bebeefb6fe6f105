#include "hw/bit_serial_memory/figures.h"

#include "hw/bit_serial_memory/account.h"
#include "hw/bit_serial_memory/micro_program.h"
#include "hw/bit_serial_memory/slots.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/program.h"
#include "hw/kinds/load.h"
#include "hw/machines/kind.h"
#include "hw/machines/timing.h"
#include "tests/support/test.h"

// Absolute values of the memories, calculated by hand: the clocked level and the analytic timing share the code under
// test, so lockstep cannot detect an error in it.

using namespace csgsim;
using bit_serial_memory::Figures;
using bit_serial_memory::FrameEnergy;
using bit_serial_memory::RowCommand;
using bit_serial_memory::RowOp;
using bit_serial_memory::Slots;
using bit_serial_memory::WordLine;
using bit_serial_memory::WordLines;
using bit_serial_memory::Work;

namespace {

/// Source: configs/DDR4_8Gb_x8_2400.ini of umd-memsys/DRAMsim3, commit 2981759 (timing and currents since 0ee9f69).
/// Units: clocks, V and mA.
struct Sheet {
  static constexpr std::uint32_t cl = 17;
  static constexpr std::uint32_t rcd = 17;
  static constexpr std::uint32_t rp = 17;
  static constexpr std::uint32_t ras = 39;
  static constexpr std::uint32_t rfc = 420;
  static constexpr std::uint32_t refi = 9360;
  static constexpr std::uint32_t rrd_s = 4;
  static constexpr std::uint32_t faw = 26;
  static constexpr std::uint32_t wr = 18;
  static constexpr std::uint32_t ccd_s = 4;
  static constexpr std::uint32_t bank_groups = 4;
  static constexpr std::uint32_t banks_per_group = 4;
  static constexpr std::uint32_t columns = 1024;
  static constexpr std::uint32_t device_width = 8;
  static constexpr double vdd = 1.2;
  static constexpr double idd0 = 48;
  static constexpr double idd2n = 34;
  static constexpr double idd3n = 43;
  static constexpr double idd4r = 135;
  static constexpr double idd5ab = 250;
};

constexpr double clocks_per_ns = 1.2;  // DDR4-2400
constexpr double fj_per_pj = 1000;

const std::array<std::string, 3> names{"ambit-ddr4", "simdram-ddr4", "digital-bit-serial-ddr4"};

const Figures& figures_of(const machines::Machine& machine) { return machines::kind_figures<Figures>(machine); }

RowCommand reading(RowOp op, WordLines from) { return {.op = op, .from = from}; }
RowCommand writing(RowOp op, WordLines to) { return {.op = op, .to = to}; }

/// Work that one command adds in 4 slots with 250 pixels.
Work work_of(const RowCommand& command) {
  Work work;
  bit_serial_memory::add(command, 4, 250, work);
  CHECK(work.commands[static_cast<std::size_t>(command.op)] == 1);
  work.commands = {};
  return work;
}

isa::Instruction instruction(isa::Opcode opcode) { return {.opcode = opcode}; }

std::uint64_t clocks_of(const std::string& machine, isa::Opcode opcode) {
  const machines::Machine one = kinds::load(machine);
  return one.kind->clocks(instruction(opcode), one);
}

}  // namespace

TEST_CASE("the timing and shape of the memories match DRAMsim3's DDR4 file") {
  for (const std::string& name : names) {
    CAPTURE(name);
    const machines::Machine machine = kinds::load(name);
    const Figures& figures = figures_of(machine);
    CHECK(machine.clock_hz == 1'200'000'000);
    CHECK(figures.banks == Sheet::bank_groups * Sheet::banks_per_group);
    CHECK(figures.row_bits == Sheet::columns * Sheet::device_width);
    CHECK(figures.command.restore == Sheet::ras);
    CHECK(figures.command.precharge == Sheet::rp);
    CHECK(figures.command.column == Sheet::rcd + Sheet::cl);
    CHECK(figures.command.recovery == Sheet::wr);
    CHECK(figures.command.logic == Sheet::ccd_s);
    CHECK(figures.rank.activation_gap == Sheet::rrd_s);
    CHECK(figures.rank.window == Sheet::faw);
    CHECK(figures.rank.refresh_interval == Sheet::refi);
    CHECK(figures.rank.refresh == Sheet::rfc);
  }
}

TEST_CASE("the energies of the memories follow from the currents in DRAMsim3's DDR4 file") {
  const double tras = Sheet::ras / clocks_per_ns;  // ns
  const double trp = Sheet::rp / clocks_per_ns;
  const double activation =
      Sheet::vdd * (Sheet::idd0 * (tras + trp) - Sheet::idd3n * tras - Sheet::idd2n * trp);  // mW * ns = pJ
  const double burst = Sheet::vdd * (Sheet::idd4r - Sheet::idd3n) * Sheet::ccd_s / clocks_per_ns;
  const double refresh = Sheet::vdd * (Sheet::idd5ab - Sheet::idd2n) * Sheet::rfc / clocks_per_ns;
  for (const std::string& name : names) {
    CAPTURE(name);
    const bit_serial_memory::Energies energy = figures_of(kinds::load(name)).energy;
    CHECK(static_cast<double>(energy.activation_fj) == doctest::Approx(activation * fj_per_pj).epsilon(1e-9));
    CHECK(static_cast<double>(energy.transfer_fj) == doctest::Approx(burst * fj_per_pj / 64).epsilon(1e-9));
    CHECK(static_cast<double>(energy.refresh_fj) == doctest::Approx(refresh * fj_per_pj).epsilon(1e-9));
    CHECK(static_cast<double>(energy.background_uw) == doctest::Approx(Sheet::vdd * Sheet::idd3n * 1000).epsilon(1e-9));
    // Each further row adds 22 %. Logic takes 7 uW per column for four clocks of 0.83 ns in designs with gates.
    CHECK(energy.further_row_permille == 220);
    CHECK(energy.logic_fj == (name == "digital-bit-serial-ddr4" ? 23 : 0));
    CHECK(energy.leaf_fj == 23);
  }
}

TEST_CASE("sizes and command clocks of the memories match the documented designs") {
  for (const std::string& name : names) {
    CAPTURE(name);
    const machines::Machine machine = kinds::load(name);
    const Figures& figures = figures_of(machine);
    CHECK(figures.chips == 8);
    CHECK(figures.subarrays == 128);
    CHECK(figures.subarray_rows == 512);
    CHECK(figures.bus_bits == 16);
    CHECK(figures.plane_bits == 128);
    CHECK(figures.queue == 16);
    CHECK(figures.command.second == 5);
    CHECK(figures.command.leaf == 4);
    CHECK(figures.command.global_or == 20);
    CHECK_FALSE(figures.enable_latch);
    CHECK_FALSE(figures.has_wired_or);
    CHECK(figures.expressions == bit_serial_memory::Expressions::rows);
    CHECK(machine.array.memory_bits == 256);
    CHECK(machine.link.width == 64);
    CHECK(machine.link.word_clocks == 1);
    CHECK(machine.link.latency == 40);
    CHECK(machine.host.processor == machines::ideal_processor);
  }
  CHECK(figures_of(kinds::load("ambit-ddr4")).design == bit_serial_memory::Design::and_or_not);
  CHECK(figures_of(kinds::load("simdram-ddr4")).design == bit_serial_memory::Design::majority);
  CHECK(figures_of(kinds::load("digital-bit-serial-ddr4")).design == bit_serial_memory::Design::latches);
}

TEST_CASE("an account charges a command for its work in each slot") {
  const WordLine row{3, false};
  CHECK(work_of({.op = RowOp::copy, .from = WordLines(row), .to = WordLines(row)}) == Work{.activations = 8});
  CHECK(work_of({.op = RowOp::copy, .from = WordLines(row, row, row), .to = WordLines(row, row)}) ==
        Work{.activations = 8, .further_rows = 12});
  CHECK(work_of(reading(RowOp::activate, WordLines(row, row, row))) == Work{.activations = 4, .further_rows = 8});
  CHECK(work_of(reading(RowOp::latch, row)) == Work{.activations = 4});
  CHECK(work_of(reading(RowOp::read, row)) == Work{.activations = 4});
  CHECK(work_of(writing(RowOp::write, row)) == Work{.activations = 4});
  CHECK(work_of({.op = RowOp::logic}) == Work{.logic = 4});
  CHECK(work_of({.op = RowOp::leaf}) == Work{.leaves = 4});
  CHECK(work_of(writing(RowOp::leaf_copy, WordLines(row, row))) ==
        Work{.activations = 4, .further_rows = 4, .leaves = 4});
  CHECK(work_of(writing(RowOp::receive, row)) == Work{.activations = 4, .transferred_bits = 250});
  CHECK(work_of(reading(RowOp::send, row)) == Work{.activations = 4, .transferred_bits = 250});
  CHECK(work_of({.op = RowOp::wired_or}) == Work{});
}

TEST_CASE("a frame's energy is that of its work in all chips and columns") {
  const Work work{
      .activations = 1000, .further_rows = 500, .logic = 300, .leaves = 200, .transferred_bits = 4096, .refreshes = 3};
  // 1.2 million clocks are 1 ms.
  const FrameEnergy energy = bit_serial_memory::energy_of(work, 1'200'000, kinds::load("digital-bit-serial-ddr4"));
  CHECK(energy.activation == 3'845'040);    // 433 pJ in 8 chips, 1000 times, and 0.22 of it 500 times
  CHECK(energy.logic == 452'198);           // 23 fJ in 65,536 columns, 300 times: 452,198.4
  CHECK(energy.leaf == 301'466);            // the same 200 times: 301,465.6
  CHECK(energy.transfer == 23'552);         // 5750 fJ for 4096 bits
  CHECK(energy.refresh == 2'177'280);       // 90,720 pJ in 8 chips, three times
  CHECK(energy.background == 412'800'000);  // 51.6 mW in 8 chips for 1 ms
  CHECK(energy.sum() == 419'599'536);
  // Half of the chips have half of the columns.
  const FrameEnergy half =
      bit_serial_memory::energy_of(work, 1'200'000, kinds::load("digital-bit-serial-ddr4+chips.count=4"));
  CHECK(half.activation == 1'922'520);
  CHECK(half.logic == 226'099);
  CHECK(half.leaf == 150'733);
  CHECK(half.transfer == 23'552);
  CHECK(half.refresh == 1'088'640);
  CHECK(half.background == 206'400'000);
}

TEST_CASE("an account reports the work of the frame and its energies") {
  bit_serial_memory::FrameAccount frame;
  frame.controller = {.issuing = 10, .answering = 5, .clearing = 3, .refreshing = 2, .starved = 1, .jumping = 4};
  frame.sending = 7;
  frame.scan_out_clocks = 11;
  frame.work = {.activations = 2, .further_rows = 1, .logic = 4, .leaves = 5, .transferred_bits = 6, .refreshes = 1};
  frame.work.commands[0] = 8;
  frame.work.commands[5] = 9;
  const machines::Machine machine = kinds::load("digital-bit-serial-ddr4");
  const machines::Account account = bit_serial_memory::account(frame, 25, 36, machine);
  const auto count = [&](std::string_view name) {
    const auto found = std::ranges::find(account.counts, name, &machines::Count::name);
    REQUIRE(found != account.counts.end());
    return found->value;
  };
  CHECK(count("row_commands") == 17);
  CHECK(count("activations") == 2);
  CHECK(count("further_rows") == 1);
  CHECK(count("logic_commands") == 4);
  CHECK(count("leaf_commands") == 5);
  CHECK(count("transferred_bits") == 6);
  CHECK(count("refreshes") == 1);
  CHECK(count("scan_out_clocks") == 11);
  CHECK(count("activation_picojoules") == 7690);  // 3464 pJ twice, plus 762.08
  CHECK(count("logic_picojoules") == 6029);       // 1507.328 four times
  CHECK(count("leaf_picojoules") == 7537);        // the same five times: 7536.64
  CHECK(count("transfer_picojoules") == 35);      // 34.5
  CHECK(count("refresh_picojoules") == 725'760);
  CHECK(count("background_picojoules") == 12'384);  // 412.8 mW for 30 ns
  CHECK(count("frame_picojoules") == 7690 + 6029 + 7537 + 35 + 725'760 + 12'384);
  REQUIRE(account.shares.size() == 2);
  CHECK(account.shares[0].part == 18);
  CHECK(account.shares[0].whole == 25);
  CHECK(account.shares[1].part == 7);
}

TEST_CASE("the account of a memory is zero before a frame begins") {
  const Work work;
  for (const std::uint64_t commands : work.commands) CHECK(commands == 0);
  CHECK(work.activations + work.further_rows + work.logic + work.leaves + work.transferred_bits + work.refreshes == 0);
  const bit_serial_memory::ControllerAccount controller;
  CHECK(controller.issuing + controller.answering + controller.clearing == 0);
  CHECK(controller.refreshing + controller.starved + controller.jumping == 0);
  CHECK(bit_serial_memory::FrameAccount{}.sending == 0);
  CHECK(bit_serial_memory::FrameAccount{}.scan_out_clocks == 0);
  CHECK(FrameEnergy{}.sum() == 0);
  CHECK(bit_serial_memory::energy_of(work, 0, kinds::load("simdram-ddr4")).sum() == 0);
}

TEST_CASE("default-constructed figures of a memory have minimum sizes and delays") {
  const Figures figures;
  CHECK(figures.design == bit_serial_memory::Design::latches);
  CHECK(figures.expressions == bit_serial_memory::Expressions::rows);
  CHECK_FALSE(figures.enable_latch);
  CHECK_FALSE(figures.has_wired_or);
  for (const std::uint32_t one : {figures.chips, figures.row_bits, figures.subarray_rows, figures.banks,
                                  figures.subarrays, figures.bus_bits, figures.plane_bits, figures.queue})
    CHECK(one == 1);
  const bit_serial_memory::CommandClocks& command = figures.command;
  for (const std::uint32_t one : {command.restore, command.precharge, command.second, command.logic, command.column,
                                  command.leaf, command.global_or})
    CHECK(one == 1);
  CHECK(command.recovery == 0);
  CHECK(figures.rank.activation_gap == 1);
  CHECK(figures.rank.window + figures.rank.refresh_interval + figures.rank.refresh == 0);
  const bit_serial_memory::Energies& energy = figures.energy;
  CHECK(energy.activation_fj + energy.further_row_permille + energy.logic_fj + energy.leaf_fj == 0);
  CHECK(energy.transfer_fj + energy.refresh_fj + energy.background_uw == 0);
  CHECK(Slots{}.count() == 0);
  CHECK(Slots{.pixels = 5}.count() == 5);  // one column per slot
  CHECK(Slots{.pixels = 5}.used_banks() == 1);
  const bit_serial_memory::MicroDesign design;
  CHECK(design.design == bit_serial_memory::Design::latches);
  CHECK(design.expressions == bit_serial_memory::Expressions::rows);
  CHECK_FALSE(design.enable_latch);
  CHECK_FALSE(design.has_wired_or);
}

TEST_CASE("a row transfer is limited by the chip bus or the host's unit if that is narrower") {
  Figures figures;
  figures.bus_bits = 16;
  figures.chips = 8;
  figures.plane_bits = 1U << 30U;
  CHECK(bit_serial_memory::transfer_clocks(65'536, figures) == 512);
  CHECK(bit_serial_memory::transfer_clocks(65'537, figures) == 513);
  CHECK(bit_serial_memory::transfer_clocks(128, figures) == 1);
  CHECK(bit_serial_memory::transfer_clocks(129, figures) == 2);
  CHECK(bit_serial_memory::transfer_clocks(1, figures) == 1);
  CHECK(bit_serial_memory::transfer_clocks(0, figures) == 0);
  figures.plane_bits = 64;
  CHECK(bit_serial_memory::transfer_clocks(65'536, figures) == 1024);
  figures.plane_bits = 128;
  figures.chips = 1;
  CHECK(bit_serial_memory::transfer_clocks(65'536, figures) == 4096);
}

TEST_CASE("slots use the columns of all chips and are assigned to banks in turn") {
  const Slots slots{.pixels = 250, .row_columns = 64, .banks = 3};
  CHECK(slots.count() == 4);
  CHECK(slots.columns(0) == 64);
  CHECK(slots.columns(3) == 58);
  CHECK(slots.bank(2) == 2);
  CHECK(slots.bank(3) == 0);
  CHECK(slots.used_banks() == 3);
  CHECK(Slots{.pixels = 128, .row_columns = 64, .banks = 3}.count() == 2);
  CHECK(Slots{.pixels = 128, .row_columns = 64, .banks = 3}.used_banks() == 2);
  const Slots of_machine = bit_serial_memory::slots_of(kinds::load("simdram-ddr4+picture.width=300"));
  CHECK(of_machine.pixels == 300 * 512);
  CHECK(of_machine.row_columns == 65'536);
  CHECK(of_machine.banks == 16);
}

// 512 x 512 pixels are 4 slots in separate banks: commands begin at 0, 4, 8 and 12 (tRRD). One clock to accept the
// instruction comes first.
TEST_CASE("single instructions of a memory take the hand-calculated clocks") {
  // LOGIC, LOGIC, and WRITE from clock 8, in the last bank from 20; closing it takes 39 + 17.
  CHECK(clocks_of("digital-bit-serial-ddr4", isa::Opcode::enable_all) == 1 + 20 + 39 + 17);
  // AAP activates twice, at 0 and 5, 9 and 14. Only four activations fit in 26 clocks, so the next are at 26 and 31, 35
  // and 40.
  CHECK(clocks_of("simdram-ddr4", isa::Opcode::enable_all) == 1 + 40 + 39 + 17);
  CHECK(clocks_of("ambit-ddr4", isa::Opcode::enable_all) == 1 + 40 + 39 + 17);
  // SEND: the bus starts 34 clocks after the first activation, carries four rows of 512 clocks, and the last bank
  // closes 18 + 17 clocks later.
  CHECK(clocks_of("digital-bit-serial-ddr4", isa::Opcode::global_or) == 1 + 34 + 4 * 512 + 18 + 17);
  // The wired OR needs a READ of E, in the last bank from clock 12, and then the 20 clocks of the line.
  CHECK(clocks_of("digital-bit-serial-ddr4+global_or.present=1", isa::Opcode::global_or) == 1 + 12 + 39 + 17 + 20);
  // A latch for E changes with one LOGIC.
  CHECK(clocks_of("digital-bit-serial-ddr4+logic.enable=1", isa::Opcode::enable_all) == 1 + 4);
  CHECK(clocks_of("digital-bit-serial-ddr4+logic.enable=1", isa::Opcode::enable_invert) == 1 + 4);
}

TEST_CASE("a frame of one instruction on a memory takes the hand-calculated clocks") {
  isa::Program program;
  program.shape = {512, 512, 256};
  program.segments.push_back({.region = {0, 0, 512, 512}, .instructions = {instruction(isa::Opcode::enable_all)}});
  const auto clocks = [&](const std::string& change) {
    return machines::time_frame(program, kinds::load("digital-bit-serial-ddr4" + change)).clocks;
  };
  // Two words of 64 bits arrive after 40 clocks (an opcode of 6 bits and a region of 4 * 16), which are accepted a
  // clock later. The word of the instruction overlaps with them.
  constexpr std::uint64_t link = 40 + 2 + 1;
  // The first bank executes SET0 and WRITE for each of 256 bits, then SET0, MOVE and WRITE for E. A bit takes 4 + 56
  // clocks; the last bank ends 12 clocks later.
  constexpr std::uint64_t clear = 1 + 256 * (4 + 56) + 2 * 4 + 56 + 12;
  constexpr std::uint64_t enable = 1 + 2 * 4 + 12 + 56;
  CHECK(clocks("+timing.refresh_interval=ideal") == link + clear + enable);
  // The refresh of clock 9360 waits for the end of the clear, because the sense amplifiers are in use throughout it.
  CHECK(clocks("") == link + clear + 420 + enable);
}

TEST_CASE("a smaller picture takes only the clocks of the slots that it occupies") {
  isa::Program program;
  program.shape = {64, 64, 256};
  program.segments.push_back({.region = {0, 0, 64, 64}, .instructions = {instruction(isa::Opcode::enable_all)}});
  const machines::Machine machine = kinds::load("digital-bit-serial-ddr4+timing.refresh_interval=ideal");
  // The same in a single bank, without the 12 clocks of the others.
  constexpr std::uint64_t cleared = 40 + 2 + 1 + 1 + 256 * (4 + 56) + 2 * 4 + 56;
  constexpr std::uint64_t drawn = cleared + 1 + 2 * 4 + 56;
  CHECK(machine.kind->time(program, machine, {}).clocks == drawn);
  const auto timeline = machine.kind->timeline(program, machine, {});
  REQUIRE(timeline.has_value());
  CHECK(timeline->cleared == std::vector<machines::ClockSpan>{{43, cleared}});
  CHECK(timeline->issued == std::vector<std::vector<machines::ClockSpan>>{{{cleared, drawn}}});
}
