#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "hw/machines/machine.h"
#include "tests/rtl/vector.h"
#include "tests/support/plain_cells.h"

/// The chain in Verilog, as Verilator made it, with the parameters of one build.
namespace csgsim::rtl {

/// What the parameters say of a scan-line array, whose picture is as wide as the chain.
machines::Machine chain_of_parameters();

/// On the wires from the chain after an edge: of each cell as many bits, those of cell 0 first.
struct ChainRegisters {
  bool refresh_valid = false;
  std::uint32_t refresh_colour = 0;
  Vector next_f;  ///< as the next cell gets it
  Vector next_a;
  Vector next_aa;
  Vector carry;  ///< of the running sum
  Vector difference_carry;
  Vector enable;
  Vector written;  ///< a bit: the packet's result is
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
  /// After reset.
  RtlChain();
  RtlChain(const RtlChain&) = delete;
  RtlChain& operator=(const RtlChain&) = delete;
  RtlChain(RtlChain&&) = delete;
  RtlChain& operator=(RtlChain&&) = delete;
  ~RtlChain();

  /// A clock in which that beat is in cell 0. `fault`: number of the planted one (hw/rtl/scan_line/faults.vh), 0 for
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
