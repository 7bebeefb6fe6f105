#include <array>

#include "hw/machines/shared_figures.h"
#include "tests/kinds/figures.h"
#include "tests/kinds/raster.h"

namespace csgsim::raster {

namespace {

using machines::Machine;
namespace shared = machines::shared;

constexpr auto schema = std::to_array<machines::FigureSchema>({
    shared::array_width,
    shared::array_height,
    shared::memory_bits,
    shared::clock_frequency,
    machines::or_ideal(machines::own_figure<Figures, &Figures::pixel_clocks>("processor.pixel_clocks", "clocks", 0, 100,
                                                                             "of an instruction at a pixel"),
                       0),
});

class Raster final : public machines::KindOf<Figures> {
 public:
  using KindOf::KindOf;

  void complete(Machine& machine) const override { machine.picture = {machine.array.width, machine.array.height}; }

  void set_picture(Machine& machine, machines::Size size) const override {
    machine.array.width = size.width;
    machine.array.height = size.height;
  }

  std::vector<isa::Region> regions(const Machine& machine) const override {
    return {{0, 0, machine.array.width, machine.array.height}};
  }

  std::uint64_t clocks(const isa::Instruction& /*instruction*/, const Machine& machine) const override {
    return std::uint64_t{machine.array.width} * machine.array.height * figures_of(machine).pixel_clocks;
  }

  machines::FrameTiming time(const isa::Program& program, const Machine& machine,
                             const machines::RunOutcome& /*told*/) const override {
    machines::FrameTiming timing;
    for (const isa::Segment& segment : program.segments) {
      for (const isa::Instruction& instruction : segment.instructions) timing.clocks += clocks(instruction, machine);
    }
    timing.account.parts = {{"processor", {{"working", timing.clocks}}}};
    return timing;
  }

  machines::Resources resources(const Machine& machine, const isa::FrameHeader& /*header*/) const override {
    return {1, std::uint64_t{machine.array.width} * machine.array.height * machine.array.memory_bits};
  }
};

const Raster raster{"raster", schema};

}  // namespace

const machines::Kind& kind = raster;

}  // namespace csgsim::raster
