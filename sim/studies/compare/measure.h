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
#include "sim/studies/compare/dear_cell.h"
#include "sim/studies/inputs.h"

namespace csgsim::studies {

/// One picture of the model on one machine, or by software.
struct ComparisonPoint {
  std::string machine;
  std::uint32_t width = 0;   ///< pixels
  std::uint32_t height = 0;  ///< pixels
  double fragments = 0;      ///< of a circle; 0 for facets as the model asks for them
  std::string ideal{};       ///< the figure that is made ideal, `all` of them, or none

  bool operator==(const ComparisonPoint&) const = default;

  static void columns(auto& point, const auto& visit) {
    visit("machine", point.machine);
    visit("width", point.width);
    visit("height", point.height);
    visit("fragments", point.fragments);
    visit("ideal", point.ideal);
  }
};

/// What a point takes. Where `reason` says why the machine cannot draw it, the counts are 0.
struct ComparisonRow {
  static constexpr std::size_t point_columns = 5;

  ComparisonPoint point;
  Inputs inputs;
  std::uint64_t primitives = 0;
  std::uint64_t halfspaces = 0;
  std::uint64_t segments = 0;           ///< parts of the picture
  std::uint64_t drawn_segments = 0;     ///< of these, those that something touches
  std::uint64_t instructions = 0;       ///< in all segments
  std::uint64_t clocks = 0;             ///< in which a frame is drawn
  double simulated_seconds = 0;         ///< these, at the machine's clock rate
  std::uint64_t shown_clocks = 0;       ///< until its last pixel has been shown
  std::uint64_t interval_clocks = 0;    ///< from one frame to the next, where the host keeps up
  std::uint64_t host_clocks = 0;        ///< in which the host compiles a frame
  double frames_per_second = 0;         ///< in a sequence of such frames, where the host keeps up
  double hosted_frames_per_second = 0;  ///< with its host
  std::uint64_t pixel_operations = 0;   ///< clocks of each instruction times the pixels of its region
  std::uint64_t enabled = 0;            ///< of these, at pixels whose E was 1 when the instruction began
  std::uint64_t processors = 0;
  std::uint64_t processor_clocks = 0;                  ///< processors times clocks: what was paid for
  std::uint64_t machine_memory_bits = 0;               ///< of all processors, and of a frame buffer beside them
  std::optional<std::uint64_t> pixel_transistors{};    ///< of one processor with its memory: hw/machines/area.h
  std::optional<std::uint64_t> machine_transistors{};  ///< of all processors
  /// Of a frame: by the machine's figures, or of bit-serial pixels by a model, in the process of their time.
  std::optional<double> frame_joules{};
  double utilisation = 0;  ///< enabled pixel operations in processor clocks
  std::string bound_by;    ///< the part that bounds the frame if the host keeps up; empty where the kind does not tell
  double bound_share = 0;  ///< of the clocks from one frame to the next, in which it works
  std::uint64_t instruction_clocks = 0;  ///< of all instructions, over all segments, and the final latency
  DearPrimitives dearest;                ///< what they take of these
  std::string picture;                   ///< hash of depth, owner and colour of every pixel; none of software
  std::string surfaces;                  ///< the same without colours
  std::string reason;

  [[nodiscard]] bool drawn() const { return reason.empty(); }

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
  std::string name;  ///< PROCESSOR:METHOD, as a point's machine
  software::Priced processor;
  software::Choice choice;
};

/// All that a point is made from, but for what the point says.
struct ComparisonJob {
  ComparisonPoint point;
  Inputs inputs;
  machines::Machine machine;
  view::Camera camera;
  view::Sampling sampling;
  emit::Options options;
  std::optional<SoftwareChoice> software{};  ///< in place of the machine
};

/// As the point asks for it.
facet::Faceting faceting_of(const ComparisonPoint& point);

/// Compiles the point and draws it at the functional level, or by software.
ComparisonRow measure(const ComparisonJob& job, const model::Tree& tree);

/// On each machine the time from one frame to the next, that of drawing alone, and memory; these times against
/// half-spaces and against pixels, a line a machine: what varies among the rows, which are of one model. `base` is the
/// picture size at which half-spaces vary.
std::vector<plots::Plot> plots_of_comparison(std::span<const ComparisonRow> rows, const machines::Size& base,
                                             const std::string& model);

}  // namespace csgsim::studies
