#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "hw/machines/runs_on.h"
#include "hw/pixel_square/pixel_square.h"
#include "sim/cycle/fit.h"
#include "sim/cycle/in_order.h"
#include "sim/cycle/kinds.h"
#include "sim/cycle/overflow.h"

namespace csgsim::sim {

namespace {

using pixel_square::PixelSquareMachine;

/// Passes what the renderers tell on in program order, and counts the overflows, which they do not notice.
class Relay final : public pixel_square::RunListener {
 public:
  Relay(const isa::Program& program, const isa::ArrayShape& array, std::span<Observer* const> observers)
      : program_(program), in_order_(program, array, observers) {}

  void begin() { in_order_.begin(); }

  void after_instruction(const pixel_square::Retired& retired, const array::PixelArray& pixels) override {
    const isa::Segment& segment = program_.segments[retired.segment];
    const Step step{.segment = retired.segment,
                    .index = retired.index,
                    .instruction = segment.instructions[retired.index],
                    .clocks = retired.clocks,
                    .enabled_pixels = retired.enabled_pixels};
    in_order_.after_instruction(step, pixels);
    if (retired.index + 1 < segment.instructions.size()) before_instruction(segment, retired.index + 1, pixels);
  }

  void after_square(std::uint32_t segment, const array::PixelArray& pixels) override {
    in_order_.after_segment(segment, pixels);
  }

  [[nodiscard]] std::uint64_t overflows() const { return overflows_; }

 private:
  /// A segment's first instruction finds no pixel enabled.
  void before_instruction(const isa::Segment& segment, std::uint32_t index, const array::PixelArray& pixels) {
    overflows_ += count_overflows(segment.instructions[index].linear, segment.region, pixels.enable(),
                                  pixels.shape().row_words());
  }

  const isa::Program& program_;
  InOrder in_order_;
  std::uint64_t overflows_ = 0;
};

class PixelSquareEngine final : public Engine {
 public:
  PixelSquareEngine(PixelSquareMachine& hardware, const machines::Machine& machine)
      : hardware_(hardware), machine_(machine) {}

  [[nodiscard]] std::string_view level() const override { return "cycle"; }

  RunResult run(const isa::Program& program, std::span<Observer* const> observers) override {
    machines::check_runs_on(program, machine_);
    check_fits(program.shape, {machine_.picture.width, machine_.picture.height, machine_.array.memory_bits});
    Relay relay(program, machine_.array, observers);
    relay.begin();
    pixel_square::RunReport report = hardware_.run(program, relay);
    RunResult result{
        .clocks = report.clocks, .overflows = relay.overflows(), .answers = {}, .account = std::move(report.account)};
    const bool fills_picture = machine_.picture == machines::Size{program.shape.width, program.shape.height};
    if (fills_picture && isa::field_of(program, isa::FieldRole::colour).width > 0) {
      result.scanned_out.assign(hardware_.picture().begin(), hardware_.picture().end());
    }
    return result;
  }

 private:
  PixelSquareMachine& hardware_;
  machines::Machine machine_;
};

PixelSquareMachine& hardware_of(const machines::Machine& machine) {
  claim_elaboration(machine);
  static const auto hardware = std::make_unique<PixelSquareMachine>("pixel_square", machine);
  return *hardware;
}

}  // namespace

std::unique_ptr<Engine> make_pixel_square_engine(const machines::Machine& machine) {
  return std::make_unique<PixelSquareEngine>(hardware_of(machine), machine);
}

}  // namespace csgsim::sim
