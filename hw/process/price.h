// Clock rate, area and energy of a machine in a process.
// Used by sim/studies.
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

// Clock rate, area and energy in a process of a machine with bit-serial pixels whose area is known
// (hw/machines/area.h). docs/design-space.md lists what the model includes and omits.
namespace csgsim::process {

/// A path that must settle between two clock edges.
struct ClockPath {
  std::string_view name;
  double ps = 0;

  bool operator==(const ClockPath&) const = default;
};

/// The critical paths of a machine, each including the delay of a register:
/// - `pixel`: a memory bit is decoded, read and rotated to its place in the ALU, and then passes the carries of the
///   ALU's bits, two gates each.
/// - `trees`: the full adder of a node, three gates, plus two for each further bit of a stream per clock, through which
///   its carry ripples. If only every r-th level has registers, r full adders and the wires between them: the first
///   wire is a quarter of the array's side long, each other half as long as the previous one.
/// - `wire`: the longest wire of a tree or of the broadcast, half the side of the array.
/// - `global OR`: if the machine has a global OR, one of its gates, composed of gates with the fan-in of the process.
///
/// Empty for machines with other processors and for pixels that have not been synthesized.
std::vector<ClockPath> clock_paths(const machines::Machine& machine, const Process& process);

/// The slowest path and the clock rate it permits, at most the maximum of machine descriptions.
struct Clock {
  std::uint64_t hz = 0;
  ClockPath path;
  std::uint64_t usable_hz = 0;  ///< clocks per second that the refresh of dynamic memory leaves
};
/// The clock of the machine; empty if there are no paths.
std::optional<Clock> clock_of(const machines::Machine& machine, const Process& process);

/// Area in mm² of the logic and the memory of a pixel; the memory with its share of decoders and sense amplifiers.
struct PixelArea {
  double logic = 0;
  double memory = 0;
};
/// Empty if the pixel has not been synthesized.
std::optional<PixelArea> pixel_mm2(const machines::Machine& machine, const Process& process);

/// Area in mm² of the processors with trees and memory, of a frame buffer, and of the controller and FIFO of each
/// array. Empty if the area of a pixel is not known.
std::optional<double> machine_mm2(const machines::Machine& machine, const machines::Resources& resources,
                                  const Process& process);

/// Clocks of all executed instructions times the pixels of their regions.
std::uint64_t pixel_clocks(const isa::Program& program, const machines::Machine& machine,
                           std::span<const machines::Skip> skips);

/// Work of one frame.
struct FrameWork {
  std::uint64_t pixel_clocks = 0;
  double seconds = 0;  ///< time from the start of the frame until the next frame begins
};

/// Joules to send a bit over a mm of wire: half of C V², the energy of a transition.
double wire_joules(const Process& process);

/// Energy of a frame in joules: in each pixel clock all memory ports, the ALU, the tree node and their registers are
/// active, and the streams of the trees cross the pixel. Added for the time of the frame: the static energy of the
/// gates, the wires of the clock over all pixels at the machine's clock rate, and the refresh of dynamic memory.
std::optional<double> frame_joules(const machines::Machine& machine, const machines::Resources& resources,
                                   const FrameWork& work, const Process& process);

}  // namespace csgsim::process
