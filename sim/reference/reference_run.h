// Runs of the reference engine.
// Used by the reference engine and tests.
#pragma once

#include "hw/machines/machine.h"
#include "sim/engine/met_recorder.h"
#include "sim/engine/run.h"
#include "sim/reference/reference_array.h"

namespace csgsim::reference {

/// A run that executes one instruction at a time, one pixel at a time. The Program must outlive it.
class ReferenceRun final : public engine::Run {
 public:
  /// Throws InputError if the machine lacks a feature that the Program needs.
  ReferenceRun(const isa::Program& program, const machines::Machine& machine);

  [[nodiscard]] engine::Place place() const override { return place_; }
  [[nodiscard]] bool is_finished() const override;
  void advance(std::uint64_t number, std::span<engine::Observer* const> observers) override;
  [[nodiscard]] engine::RunState save() const override;
  void restore(const engine::RunState& state) override;
  [[nodiscard]] engine::RunResult result() const override;

  [[nodiscard]] isa::Region region() const override { return array_.region(); }
  void read_field(isa::Field field, std::span<std::uint32_t> values) const override {
    array_.read_field(field, values);
  }
  void read_enable(std::span<std::uint64_t> words) const override { array_.read_enable(words); }
  [[nodiscard]] std::uint32_t value(isa::Field field, std::uint32_t x, std::uint32_t y) const override {
    return array_.read(field, x, y);
  }
  [[nodiscard]] bool is_enabled(std::uint32_t x, std::uint32_t y) const override { return array_.is_enabled(x, y); }

 private:
  /// Moves to the segment's first instruction and clears all pixels.
  void begin_segment(std::uint32_t segment);
  void execute(std::span<engine::Observer* const> observers);
  [[nodiscard]] std::vector<machines::PixelActivity> record_pixel_activity() const;

  const isa::Program& program_;
  machines::Machine machine_;
  engine::Numbers numbers_;
  engine::Place place_;
  bool is_end_notified_ = false;
  ReferenceArray array_{isa::Region{}, 0};
  engine::RunResult result_;
  std::vector<machines::Skip> skips_;
  engine::PixelActivityRecorder met_;
};

}  // namespace csgsim::reference
