#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "tests/rtl/scan_line/cell_check.h"
#include "tests/rtl/scan_line/clocked_chain.h"
#include "tests/rtl/scan_line/rtl_chain.h"

namespace csgsim::rtl {

/// Runs the chain in SystemC with the packets of its host, and feeds the same packets to the chain in Verilog and to
/// the plain chain, which provides each clock's registers.
class ChainLockstep {
 public:
  explicit ChainLockstep(const machines::Machine& machine);

  /// Draws frames one after the other on all. Returns the first difference; empty if there is none.
  std::string run(std::span<const isa::Program> programs, std::uint8_t fault = 0);

  [[nodiscard]] std::uint64_t clocks_compared() const { return clocks_compared_; }

 private:
  void draw(std::span<const isa::Program> programs, std::uint8_t fault);
  void clock(std::uint8_t fault);
  void drain(std::uint8_t fault);
  void compare();
  void clear();

  machines::Machine machine_;
  scan_line::CellShape shape_;
  ClockedChain systemc_;
  test::PlainChain plain_;
  std::unique_ptr<RtlChain> verilog_;
  std::uint32_t pixels_ = 0;
  std::deque<test::PlainBeat> worked_;  ///< the beat in each cell during the previous clock
  std::vector<CellCheck> cells_;
  bool comparing_ = false;
  std::uint64_t clock_ = 0;  ///< clock within the current frames
  std::uint64_t clocks_compared_ = 0;
  std::string difference_;
};

}  // namespace csgsim::rtl
