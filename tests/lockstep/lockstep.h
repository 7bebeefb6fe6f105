#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "hw/machines/machine.h"
#include "sim/engine/engine.h"

namespace csgsim::test {

/// Where two engines differ first.
class Difference : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What two engines made of a Program.
struct Results {
  engine::RunResult judge;
  engine::RunResult engine;
};

/// Runs the Program on both engines, the judge's level being one that can stop, and throws Difference unless they agree
/// at every instruction boundary, in the answers, overflows and clocks, and the clocks are those of hw/machines and add
/// up.
Results check_lockstep(engine::Engine& judge, engine::Engine& engine, const isa::Program& program,
                       const machines::Machine& machine);

/// Every clock of the frame is accounted for, in every part.
bool adds_up(const engine::RunResult& result);

/// The clocks, and what each part spent them on.
std::string show(const engine::RunResult& result);

/// A machine with made-up figures for that array.
machines::Machine machine_of(isa::ArrayShape shape, std::uint32_t memory_reads, std::uint32_t alu_bits = 1);

}  // namespace csgsim::test
