// Observer that counts instructions and clocks.
// Used throughout sim.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "sim/engine/engine.h"

namespace csgsim::observe {

/// Cost of a set of executed instructions.
struct Cost {
  std::uint64_t instructions = 0;
  std::uint64_t clocks = 0;
  std::uint64_t pixel_operations = 0;  ///< bit steps times pixel processors, or the machine's own count if it differs
  std::uint64_t enabled = 0;           ///< pixel operations at pixels whose E was 1 when the instruction began

  Cost& operator+=(const Cost& other);
  bool operator==(const Cost&) const = default;
};

/// The cost of a run, by opcode, purpose and primitive. Each account adds up to the total. If the array covers the
/// whole picture, the total is the run's clocks without the final latency. Otherwise parts of the picture are processed
/// in parallel, and the run's clocks have a separate account (machines::Account).
struct Stats {
  Cost total;
  std::array<Cost, isa::opcode_numbers> by_opcode{};  ///< indexed by opcode number
  std::array<Cost, isa::purpose_table.size()> by_purpose{};
  std::vector<Cost> by_primitive;  ///< one per primitive of the Program
  /// The part of by_primitive that belongs to no effect other than flat shading. Together with by_effect without its
  /// first and last element, and with instructions for neither a primitive nor an effect, it adds up to the total.
  std::vector<Cost> plain_by_primitive;
  std::vector<Cost> by_effect;  ///< one per effect of the Program, flat shading first; the last one is for instructions
                                ///< of no effect

  bool operator==(const Stats&) const = default;
};

class StatsObserver : public engine::Observer {
 public:
  explicit StatsObserver(const isa::Program& program);
  [[nodiscard]] bool reads_after(const isa::Instruction& /*instruction*/) const override { return false; }
  void after_instruction(const engine::Step& step, const engine::PixelState& state) override;
  [[nodiscard]] const Stats& stats() const { return stats_; }
  /// Continues from the counts of an observer of the same Program.
  void restore(Stats stats) { stats_ = std::move(stats); }

 private:
  std::vector<std::uint64_t> pixels_of_segment_;
  std::vector<std::uint32_t> primitive_of_piece_;
  Stats stats_;
};

}  // namespace csgsim::observe
