// Compiled once for each build of the Verilog, with its parameters in CSGSIM_RTL_....

#include "tests/rtl/rtl_machine.h"

#include <verilated.h>

#include <concepts>
#include <cstddef>
#include <limits>

#include "Vprobed_planes.h"
#include "hw/pixel_planes/figures.h"
#include "tests/lockstep/lockstep.h"
#include "tests/rtl/wires.h"

namespace csgsim::rtl {

namespace {

template <std::unsigned_integral Number>
void put(Number& to, const isa::LinkWord& word) {
  to = static_cast<Number>(word.number(0, std::numeric_limits<Number>::digits));
}

template <std::size_t Words>
void put(VlWide<Words>& to, const isa::LinkWord& word) {
  for (std::size_t i = 0; i < Words; ++i)
    to[i] = static_cast<std::uint32_t>(word.number(static_cast<unsigned>(i) * 32U, 32));
}

}  // namespace

machines::Machine machine_of_parameters() {
  machines::Machine machine = test::machine_of({CSGSIM_RTL_WIDTH, CSGSIM_RTL_HEIGHT, CSGSIM_RTL_MEMORY_BITS},
                                               CSGSIM_RTL_MEMORY_READS, CSGSIM_RTL_ALU_BITS);
  machine.evaluator_degree = CSGSIM_RTL_DEGREE;
  machine.link.width = CSGSIM_RTL_LINK;
  machine.link.fifo_depth = CSGSIM_RTL_FIFO_DEPTH;
  machine.clear_clocks = CSGSIM_RTL_CLEAR_CLOCKS;
  auto& own = machines::kind_figures<pixel_planes::Figures>(machine);
  own.has_global_or = CSGSIM_RTL_HAS_OR != 0;
  own.or_fan_in = CSGSIM_RTL_FAN_IN;
  own.scan_out_pixels = CSGSIM_RTL_SCAN_PIXELS;
  own.scan_out_port = CSGSIM_RTL_SCAN_SHARED != 0 ? pixel_planes::ScanOutPort::shared : pixel_planes::ScanOutPort::own;
  own.scan_out_buffers = CSGSIM_RTL_BUFFERS;
  return machine;
}

std::uint32_t colour_wires() { return CSGSIM_RTL_COLOUR_BITS; }

struct Machine::Verilated {
  VerilatedContext context;
  Vprobed_planes top{&context};
};

Machine::Machine() : verilated_(std::make_unique<Verilated>()) { edge({.reset = true}); }

Machine::~Machine() { verilated_->top.final(); }

void Machine::edge(const Inputs& inputs) {
  clock(inputs);
  read_host();
  read_pixels();
}

void Machine::edge_for_host(const Inputs& inputs) {
  clock(inputs);
  read_host();
}

void Machine::clock(const Inputs& inputs) {
  Vprobed_planes& top = verilated_->top;
  top.reset = inputs.reset ? 1 : 0;
  top.fault = inputs.fault;
  top.frame = inputs.frame ? 1 : 0;
  top.word_valid = inputs.word_valid ? 1 : 0;
  put(top.word, inputs.word);
  step(top);
}

void Machine::read_host() {
  const Vprobed_planes& top = verilated_->top;
  outputs_.request = top.request != 0;
  outputs_.request_from = top.request_from;
  outputs_.word_ready = top.word_ready != 0;
  outputs_.told = top.told != 0;
  outputs_.told_any = top.told_any != 0;
  outputs_.done = top.done != 0;
  outputs_.clocks = top.clocks;
  outputs_.video_valid = top.video_valid != 0;
  outputs_.video_row = top.video_row != 0;
  outputs_.video_frame = top.video_frame != 0;
  assign(outputs_.video, top.video);
  outputs_.shown = top.shown != 0;
  for (std::size_t i = 0; i < counted.size(); ++i) outputs_.counts.at(i) = top.counts[i];
}

void Machine::read_pixels() {
  const Vprobed_planes& top = verilated_->top;
  outputs_.tree_valid = top.tree_valid != 0;
  assign(outputs_.tree, top.tree);
  assign(outputs_.enable, top.enable);
  assign(outputs_.carry, top.carry);
  assign(outputs_.flag, top.flag);
  assign(outputs_.latch, top.latch);
  assign(outputs_.memory, top.memory);
}

}  // namespace csgsim::rtl
