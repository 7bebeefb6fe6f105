// Runs of the functional engine.
// Used by the functional engine.
#pragma once

#include <optional>

#include "hw/machines/machine.h"
#include "sim/engine/met_recorder.h"
#include "sim/engine/run.h"
#include "sim/functional/tiles.h"

namespace csgsim::functional {

/// A run on tiles of bit planes and lanes. The Program must outlive it.
class FunctionalRun final : public engine::Run {
 public:
  /// Throws InputError if the machine lacks a feature that the Program needs.
  FunctionalRun(const isa::Program& program, const machines::Machine& machine, unsigned threads);

  [[nodiscard]] engine::Place place() const override { return place_; }
  [[nodiscard]] bool is_finished() const override;
  void advance(std::uint64_t number, std::span<engine::Observer* const> observers) override;
  [[nodiscard]] engine::RunState save() const override;
  void restore(const engine::RunState& state) override;
  [[nodiscard]] engine::RunResult result() const override;

  [[nodiscard]] isa::Region region() const override { return tiles_.region(); }
  void read_field(isa::Field field, std::span<std::uint32_t> values) const override {
    tiles_.read_field(field, values);
  }
  void read_enable(std::span<std::uint64_t> words) const override { tiles_.read_enable(words); }
  [[nodiscard]] std::uint32_t value(isa::Field field, std::uint32_t x, std::uint32_t y) const override {
    return tiles_.value(field, x, y);
  }
  [[nodiscard]] bool is_enabled(std::uint32_t x, std::uint32_t y) const override { return tiles_.is_enabled(x, y); }

 private:
  [[nodiscard]] std::span<const isa::Instruction> instructions() const;
  /// Executes instructions, at most `max_count`, until one after which an observer reads the pixels.
  void execute_stretch(std::uint64_t max_count, std::span<engine::Observer* const> observers);
  void notify_segment_end(std::span<engine::Observer* const> observers);
  [[nodiscard]] std::optional<machines::PixelClocks> at_pixels() const;
  [[nodiscard]] std::vector<machines::PixelActivity> record_pixel_activity() const;

  const isa::Program& program_;
  machines::Machine machine_;
  engine::Numbers numbers_;
  Tiles tiles_;
  engine::Place place_;
  bool is_end_notified_ = false;
  std::uint64_t overflows_ = 0;
  std::uint64_t skipped_ = 0;
  std::vector<bool> answers_;
  std::vector<machines::Skip> skips_;
  engine::PixelActivityRecorder met_;
};

}  // namespace csgsim::functional
