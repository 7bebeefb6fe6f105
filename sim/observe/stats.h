#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "sim/engine/engine.h"

namespace csgsim::observe {

/// What some of the instructions cost.
struct Cost {
  std::uint64_t instructions = 0;
  std::uint64_t clocks = 0;
  std::uint64_t pixel_operations = 0;  ///< bit steps times pixel processors; or what these take, where that differs
  std::uint64_t enabled = 0;           ///< of these, at pixels whose E was 1 when the instruction began

  Cost& operator+=(const Cost& other);
  bool operator==(const Cost&) const = default;
};

/// The cost of a run, accounted to opcodes, purposes and primitives. Each account adds up to the total. Where the array
/// is the whole picture that is the run's clocks without its final latency; elsewhere the parts of the picture are
/// worked on side by side, and the run's clocks are another account (machines::Account).
struct Stats {
  Cost total;
  std::array<Cost, isa::opcode_numbers> by_opcode{};  ///< by its number
  std::array<Cost, isa::purpose_table.size()> by_purpose{};
  std::vector<Cost> by_primitive;  ///< one a primitive of the Program
  /// Of these, what no effect but flat shading calls for. With by_effect, but for its first and last, and with what
  /// serves neither a primitive nor an effect, it adds up to the total too.
  std::vector<Cost> plain_by_primitive;
  std::vector<Cost> by_effect;  ///< one an effect of the Program, flat shading first; the last what no effect calls for

  bool operator==(const Stats&) const = default;
};

class StatsObserver : public engine::Observer {
 public:
  explicit StatsObserver(const isa::Program& program);
  [[nodiscard]] bool reads_after(const isa::Instruction& /*instruction*/) const override { return false; }
  void after_instruction(const engine::Step& step, const engine::PixelState& state) override;
  [[nodiscard]] const Stats& stats() const { return stats_; }
  /// Goes on from what an observer of the same Program counted.
  void restore(Stats stats) { stats_ = std::move(stats); }

 private:
  std::vector<std::uint64_t> pixels_of_segment_;
  std::vector<std::uint32_t> primitive_of_piece_;
  Stats stats_;
};

}  // namespace csgsim::observe
