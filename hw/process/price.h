#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/kind.h"
#include "hw/machines/timing.h"
#include "hw/process/process.h"

/// What a process makes of a machine of bit-serial pixels, those whose area is known (hw/machines/area.h). A model, of
/// which docs/design-space.md says what is in it and what is not.
namespace csgsim::process {

/// What has to settle between two edges of the clock.
struct ClockPath {
  std::string_view name;
  double ps = 0;

  bool operator==(const ClockPath&) const = default;
};

/// - `pixel`: a bit of its memory is decoded and read, turned to the ALU's place, and goes through the carries of the
///   ALU's bits, two gates each.
/// - `trees`: a full adder of a node, three gates, and two more for each further bit of a stream that the trees bring
///   in a clock, through which its carry goes; with registers behind every r-th level alone r full adders, and the
///   wires between them, the first a quarter of a side long, each other half as long as the one before.
/// - `wire`: the longest of a tree or of the broadcast, half a side of the array.
/// - `global OR`: a gate of its lines, where the machine has one, made of gates of as many inputs as the process has.
///
/// Each with a register. None of machines of other processors, or where the pixel has not been synthesised.
std::vector<ClockPath> clock_paths(const machines::Machine& machine, const Process& process);

/// The slowest of the paths, and the clocks a second that it leaves, at most what a description takes; none where there
/// are no paths.
struct Clock {
  std::uint64_t hz = 0;
  ClockPath path;
};
std::optional<Clock> clock_of(const machines::Machine& machine, const Process& process);

/// mm² of processors with their trees and memory, of a frame buffer, and of controller and FIFO of each array.
std::optional<double> machine_mm2(const machines::Machine& machine, const machines::Resources& resources,
                                  const Process& process);

/// Clocks of the instructions that are carried out, times the pixels of their regions.
std::uint64_t pixel_clocks(const isa::Program& program, const machines::Machine& machine,
                           std::span<const machines::Skip> skips);

/// What a frame is worked at.
struct FrameWork {
  std::uint64_t pixel_clocks = 0;
  double seconds = 0;  ///< until the next begins
};

/// Joules of a frame: in each pixel clock all ports of the memory, the ALU, the node of the trees and their registers
/// work, and the streams of the trees cross the pixel; besides what gates draw whatever they do.
std::optional<double> frame_joules(const machines::Machine& machine, const machines::Resources& resources,
                                   const FrameWork& work, const Process& process);

}  // namespace csgsim::process
