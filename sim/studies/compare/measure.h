// Points, rows and measurements of a comparison.
// Used by csgsim compare.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/emit/options.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/camera.h"
#include "host/view/projection.h"
#include "hw/machines/machine.h"
#include "sim/plots/plot.h"
#include "sim/software/work.h"
#include "sim/studies/compare/costly_cell.h"
#include "sim/studies/inputs.h"

namespace csgsim::studies {

/// A picture of the model on one machine, or drawn by software.
struct ComparisonPoint {
  std::string machine;
  std::uint32_t width = 0;   ///< pixels
  std::uint32_t height = 0;  ///< pixels
  double fragments = 0;      ///< fragments per circle; 0: as in the model
  std::string ideal{};       ///< the parameter made ideal, `all`, or empty

  bool operator==(const ComparisonPoint&) const = default;

  static void columns(auto& point, const auto& visit) {
    visit("machine", point.machine);
    visit("width", point.width);
    visit("height", point.height);
    visit("fragments", point.fragments);
    visit("ideal", point.ideal);
  }
};

/// Results of a point. If it cannot be drawn, `reason` says why and the counts are 0.
struct ComparisonRow {
  static constexpr std::size_t point_columns = 5;

  ComparisonPoint point;
  Inputs inputs;
  std::uint64_t primitives = 0;
  std::uint64_t halfspaces = 0;
  std::uint64_t segments = 0;           ///< parts of the picture
  std::uint64_t drawn_segments = 0;     ///< number of segments that contain instructions
  std::uint64_t instructions = 0;       ///< in all segments
  std::uint64_t clocks = 0;             ///< to draw a frame
  double simulated_seconds = 0;         ///< drawing time at the machine's clock rate
  std::uint64_t shown_clocks = 0;       ///< until the last pixel has been shown
  std::uint64_t interval_clocks = 0;    ///< between frames if the host keeps up
  std::uint64_t host_clocks = 0;        ///< for the host to compile a frame
  std::uint64_t host_model_clocks = 0;  ///< for the host's work done once per model
  double frames_per_second = 0;         ///< if the host keeps up
  double hosted_frames_per_second = 0;  ///< limited by the host too
  std::uint64_t pixel_operations = 0;   ///< sum over instructions of clocks times pixels of the region
  std::uint64_t enabled = 0;            ///< pixel operations at pixels whose E was 1 when the instruction began
  std::uint64_t processors = 0;
  std::uint64_t processor_clocks = 0;     ///< processors times clocks: the available capacity
  std::uint64_t machine_memory_bits = 0;  ///< memory bits of all processors and of a separate frame buffer
  std::optional<std::uint64_t>
      pixel_transistors{};  ///< transistors of one processor with its memory: hw/machines/area.h
  std::optional<std::uint64_t> machine_transistors{};  ///< transistors of all processors
  /// Energy of a frame: from the machine's parameters, or for bit-serial pixels estimated in the process of their time.
  std::optional<double> frame_joules{};
  double utilisation = 0;  ///< enabled pixel operations / processor clocks
  std::string bound_by;    ///< unit that limits the frame rate if the host keeps up; empty if the kind of machine does
                           ///< not report it
  double bound_share = 0;  ///< fraction of the clocks between frames in which this unit works
  std::uint64_t instruction_clocks = 0;  ///< clocks of all instructions in all segments, plus the final latency
  CostlyPrimitives dearest;              ///< most expensive primitives, with their part of these clocks
  std::string picture;                   ///< hash of depth, owner and colour of every pixel; empty for software
  std::string surfaces;                  ///< hash of depth and owner of every pixel
  std::string reason;

  [[nodiscard]] bool is_drawn() const { return reason.empty(); }

  static void columns(auto& row, const auto& visit) {
    ComparisonPoint::columns(row.point, visit);
    Inputs::columns(row.inputs, visit);
    visit("primitives", row.primitives);
    visit("halfspaces", row.halfspaces);
    visit("segments", row.segments);
    visit("drawn_segments", row.drawn_segments);
    visit("instructions", row.instructions);
    visit("clocks", row.clocks);
    visit("simulated_seconds", row.simulated_seconds);
    visit("shown_clocks", row.shown_clocks);
    visit("interval_clocks", row.interval_clocks);
    visit("host_clocks", row.host_clocks);
    visit("host_model_clocks", row.host_model_clocks);
    visit("frames_per_second", row.frames_per_second);
    visit("hosted_frames_per_second", row.hosted_frames_per_second);
    visit("pixel_operations", row.pixel_operations);
    visit("enabled", row.enabled);
    visit("processors", row.processors);
    visit("processor_clocks", row.processor_clocks);
    visit("machine_memory_bits", row.machine_memory_bits);
    visit("pixel_transistors", row.pixel_transistors);
    visit("machine_transistors", row.machine_transistors);
    visit("frame_joules", row.frame_joules);
    visit("utilisation", row.utilisation);
    visit("bound_by", row.bound_by);
    visit("bound_share", row.bound_share);
    visit("instruction_clocks", row.instruction_clocks);
    visit("dearest", row.dearest);
    visit("picture", row.picture);
    visit("surfaces", row.surfaces);
    visit("reason", row.reason);
  }
};

/// A processor and the method that runs on it.
struct SoftwareChoice {
  std::string name;  ///< PROCESSOR:METHOD, the point's machine
  software::Priced processor;
  software::Choice choice;
};

/// The inputs of a point that the point itself does not hold.
struct ComparisonJob {
  ComparisonPoint point;
  Inputs inputs;
  machines::Machine machine;
  view::Camera camera;
  view::Sampling sampling;
  emit::Options options;
  std::optional<SoftwareChoice> software{};  ///< replaces the machine
};

/// The faceting that the point selects.
facet::Faceting faceting_of(const ComparisonPoint& point);

/// Compiles the point and draws it at the functional level, or by software.
ComparisonRow measure(const ComparisonJob& job, const model::Tree& tree);

/// Plots of the time between frames, the drawing time and the memory of each machine, and of these times against
/// half-spaces and pixels with a line per machine, as far as these vary. All rows belong to one model. `base` is the
/// picture size of the plots by machine and by half-spaces.
std::vector<plots::Plot> plots_of_comparison(std::span<const ComparisonRow> rows, const machines::Size& base,
                                             const std::string& model);

}  // namespace csgsim::studies
