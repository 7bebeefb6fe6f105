#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "hw/machines/machine.h"
#include "tests/rtl/vector.h"
#include "tests/support/plain_cells.h"

/// The chain in Verilog, compiled by Verilator with the parameters of one build.
namespace csgsim::rtl {

/// The scan-line array of the build's parameters, with a picture as wide as the chain.
machines::Machine chain_of_parameters();

/// Values on the wires from the chain after an edge: an equal number of bits per cell, those of cell 0 first.
struct ChainRegisters {
  bool refresh_valid = false;
  std::uint32_t refresh_colour = 0;
  Vector next_f;  ///< words of F that the next cell receives
  Vector next_a;
  Vector next_aa;
  Vector carry;  ///< carry of the running sum
  Vector difference_carry;
  Vector enable;
  Vector written;  ///< one bit per cell: the packet's result has been written
  Vector memory;
  Vector f;
  Vector x;
  Vector y;
  Vector alu_carry;
  Vector differs;
  Vector beyond;
  Vector negative;
  Vector negative_x;
  Vector held;
  Vector shifting;
};

class RtlChain {
 public:
  /// The chain after reset.
  RtlChain();
  RtlChain(const RtlChain&) = delete;
  RtlChain& operator=(const RtlChain&) = delete;
  RtlChain(RtlChain&&) = delete;
  RtlChain& operator=(RtlChain&&) = delete;
  ~RtlChain();

  /// Runs a clock with that beat in cell 0. `fault` is the number of the planted fault (hw/rtl/scan_line/faults.vh); 0:
  /// none.
  void edge(const test::PlainBeat& entry, std::uint32_t pixels, std::uint8_t fault);
  [[nodiscard]] const ChainRegisters& registers() const { return registers_; }

 private:
  struct Verilated;
  void read();

  std::unique_ptr<Verilated> verilated_;
  ChainRegisters registers_;
};

}  // namespace csgsim::rtl
