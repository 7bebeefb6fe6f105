// Compiled once for each build of the Verilog, with its parameters in CSGSIM_RTL_....

#include "tests/rtl/scan_line/rtl_chain.h"

#include <verilated.h>

#include <concepts>

#include "Vprobed_chain.h"
#include "hw/scan_line/figures.h"
#include "hw/scan_line/kind.h"
#include "tests/rtl/wires.h"

namespace csgsim::rtl {

namespace {

template <std::unsigned_integral Wire, class Number>
void put(Wire& wire, Number value) {
  wire = static_cast<Wire>(value);
}

std::uint64_t wires_of(const scan_line::FieldWords& field) {
  return field.field.base | std::uint64_t{field.field.width} << 16U | std::uint64_t{field.first} << 32U |
         std::uint64_t{field.count} << 48U;
}

std::uint32_t wires_of(const scan_line::Move& move) { return move.distance | move.words << 16U; }

}  // namespace

machines::Machine chain_of_parameters() {
  machines::Machine machine = machines::blank_machine(scan_line::kind);
  machine.name = "chain";
  machine.array = {CSGSIM_RTL_CELLS, 1, CSGSIM_RTL_WORDS * CSGSIM_RTL_WORD_BITS};
  machine.picture = {CSGSIM_RTL_CELLS, 3};
  machine.evaluator_degree = CSGSIM_RTL_DEGREE;
  machine.clear_clocks = CSGSIM_RTL_CLEAR_CLOCKS;
  machine.clock_hz = 1'000'000;
  machine.own = scan_line::Figures{.words = CSGSIM_RTL_WORDS,
                                   .word_bits = CSGSIM_RTL_WORD_BITS,
                                   .alu_bits = CSGSIM_RTL_ALU_BITS,
                                   .shift_bits = CSGSIM_RTL_SHIFT_BITS,
                                   .ports = CSGSIM_RTL_PORTS,
                                   .chains = 1,
                                   .refresh_hz = 50};
  machine.link = {.width = 100, .word_clocks = 1, .fifo_depth = 4, .latency = 2};
  return machine;
}

struct RtlChain::Verilated {
  VerilatedContext context;
  Vprobed_chain top{&context};
};

RtlChain::RtlChain() : verilated_(std::make_unique<Verilated>()) {
  verilated_->top.reset = 1;
  step(verilated_->top);
  verilated_->top.reset = 0;
  read();
}

RtlChain::~RtlChain() { verilated_->top.final(); }

void RtlChain::edge(const test::PlainBeat& entry, std::uint32_t pixels, std::uint8_t fault) {
  Vprobed_chain& top = verilated_->top;
  top.fault = fault;
  put(top.pixels, pixels);
  put(top.entry_kind, entry.kind);
  put(top.entry_begins_line, entry.begins_line);
  put(top.entry_background, entry.background);
  put(top.entry_number, entry.number);
  put(top.entry_words, entry.words);
  put(top.entry_beats, entry.beats);
  put(top.entry_f, entry.f);
  put(top.entry_a, entry.a);
  put(top.entry_aa, entry.aa);
  put(top.entry_first_source, wires_of(entry.accesses.sources[0]));
  put(top.entry_second_source, wires_of(entry.accesses.sources[1]));
  put(top.entry_target, wires_of(entry.accesses.target));
  put(top.entry_work_from, entry.accesses.work_from);
  put(top.entry_result, entry.accesses.result);
  put(top.entry_first_move, wires_of(entry.work.moves[0]));
  put(top.entry_second_move, wires_of(entry.work.moves[1]));
  put(top.entry_function, entry.work.function);
  put(top.entry_work_bits, entry.work.bits);
  put(top.entry_opcode, entry.instruction.opcode);
  put(top.entry_linear_width, entry.instruction.linear.width);
  put(top.entry_linear_shift, entry.instruction.linear.shift);
  put(top.entry_constant, entry.instruction.constant);
  step(top);
  read();
}

void RtlChain::read() {
  const Vprobed_chain& top = verilated_->top;
  registers_.refresh_valid = top.refresh_valid != 0;
  registers_.refresh_colour = top.refresh_colour;
  assign(registers_.next_f, top.next_f);
  assign(registers_.next_a, top.next_a);
  assign(registers_.next_aa, top.next_aa);
  assign(registers_.carry, top.carry);
  assign(registers_.difference_carry, top.difference_carry);
  assign(registers_.enable, top.enable);
  assign(registers_.written, top.written);
  assign(registers_.memory, top.memory);
  assign(registers_.f, top.f);
  assign(registers_.x, top.x);
  assign(registers_.y, top.y);
  assign(registers_.alu_carry, top.alu_carry);
  assign(registers_.differs, top.differs);
  assign(registers_.beyond, top.beyond);
  assign(registers_.negative, top.negative);
  assign(registers_.negative_x, top.negative_x);
  assign(registers_.held, top.held);
  assign(registers_.shifting, top.shifting);
}

}  // namespace csgsim::rtl
