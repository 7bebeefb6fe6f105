// Points and rows of the studies of the design space.
// Used by sweep, accuracy, advise and explore.
#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "sim/studies/design/memory_map.h"
#include "sim/studies/inputs.h"
#include "sim/studies/row_text.h"

/// The row type of the studies of the design space (sweep, accuracy, advise, explore). Each study selects the columns
/// of its table.
namespace csgsim::studies {

/// A way to draw a model. A study sets the members that it varies (axes.h).
struct DesignPoint {
  std::string model{};
  std::string machine{};  ///< including changed parameters
  std::string process{};  ///< semiconductor process; empty: the machine keeps the clock of its description
  std::optional<std::uint32_t> memory_bits{};  ///< per pixel; empty: as many as the Program uses
  std::uint32_t width = 0;                     ///< pixels
  std::uint32_t height = 0;                    ///< pixels
  unsigned z_bits = 0;
  unsigned fraction_bits = 0;
  unsigned colour_bits = 0;
  std::string pruning{};
  std::string colouring{};
  std::string strategy{};
  unsigned stack_bits = 0;  ///< m, for strategies with a stack; otherwise 0
  std::string curves{};     ///< how curved surfaces are drawn: host/emit/curves.h
  unsigned alu_bits = 0;    ///< ALU width of the machine in bits; 0 if its kind has no such parameter

  auto operator<=>(const DesignPoint&) const = default;  // NOLINT(modernize-use-nullptr): clang-tidy 14 sees a 0
};

/// Results of a point. If it cannot be drawn, `reason` says why and the counts are 0. Accuracy sums counts over its
/// views; depth errors are those of the worst view.
struct DesignRow {
  DesignPoint point{};
  std::string knob{};  ///< the varied setting; accuracy uses this in place of a point
  std::string value{};
  Inputs inputs{};
  std::string reason{};
  std::string strategy_used{};
  std::string colouring_used{};
  std::uint64_t primitives = 0;  ///< primitives of the model
  std::uint64_t halfspaces = 0;  ///< half-spaces of the model
  std::uint64_t instructions = 0;
  std::uint64_t rendered = 0;             ///< scan conversions of primitives whose surface is written into Z1
  std::uint64_t classified = 0;           ///< scan conversions of primitives of active trees that are compared with Z1
  std::uint64_t depth_tests = 0;          ///< comparisons of Z1 with Z2
  std::uint32_t tree_depth = 0;           ///< levels of the deepest active tree
  std::uint32_t classification_bits = 0;  ///< memory bits per pixel used for classification
  std::uint32_t used_bits = 0;            ///< memory bits per pixel used by the Program
  MemoryMap memory_map{};
  std::uint64_t processors = 0;           ///< processors of the machine
  std::uint64_t machine_memory_bits = 0;  ///< memory bits of all processors and of a separate frame buffer
  std::optional<std::uint64_t>
      pixel_transistors{};  ///< transistors of one processor with its memory: hw/machines/area.h
  std::optional<std::uint64_t> machine_transistors{};  ///< transistors of all processors
  std::optional<double> machine_mm2{};                 ///< area of the machine in the process: hw/process/price.h
  std::optional<double> frame_joules{};                ///< energy per frame in the process
  std::uint64_t clock_hz = 0;           ///< clock rate that the process allows, or that of the description
  std::string clock_path{};             ///< critical path in the process; empty without a process or price
  std::uint64_t clocks = 0;             ///< until the picture is drawn, including latency
  std::uint64_t interval_clocks = 0;    ///< between frames if the host keeps up
  std::uint64_t host_clocks = 0;        ///< for the host to compile a frame
  double simulated_seconds = 0;         ///< drawing time, from `clocks`
  double frames_per_second = 0;         ///< if the host keeps up
  double hosted_frames_per_second = 0;  ///< limited by the host too
  std::string picture{};      ///< hash of depth, owner and colour of every pixel, or `overflow`; empty if not drawn
  std::uint64_t covered = 0;  ///< pixels that show a surface
  std::uint64_t wrong = 0;    ///< pixels that differ from the exact picture of the same half-spaces
  std::uint64_t wrong_silhouette = 0;  ///< wrong pixels covered in only one of the pictures
  std::uint64_t wrong_owner = 0;       ///< wrong pixels that show another primitive
  std::uint64_t unexplained = 0;       ///< wrong pixels beyond the bounds stated in docs/numbers.md
  /// Maximum channel difference (of 255) from the picture with 24 colour bits and otherwise equal settings.
  unsigned colour_error = 0;
  double depth_max = 0;           ///< model units
  double depth_p999 = 0;          ///< model units, 99.9th percentile over pixels
  double depth_max_steps = 0;     ///< depth steps
  double depth_p999_steps = 0;    ///< depth steps
  std::uint64_t facet_wrong = 0;  ///< pixels that differ from the picture of the true curved surfaces
  double facet_depth_p999 = 0;    ///< model units, relative to the true curved surfaces
  double picture_difference = 0;  ///< mean colour difference (of 255) from the picture drawn with the finest arithmetic

  [[nodiscard]] bool is_compiled() const { return reason.empty(); }
  bool operator==(const DesignRow&) const = default;

  /// Calls visit(name, member) for every column that a study may have.
  static void all_columns(auto& row, const auto& visit) {
    visit("model", row.point.model);
    visit("machine", row.point.machine);
    visit("process", row.point.process);
    visit("memory_bits", row.point.memory_bits);
    visit("width", row.point.width);
    visit("height", row.point.height);
    visit("z_bits", row.point.z_bits);
    visit("fraction_bits", row.point.fraction_bits);
    visit("colour_bits", row.point.colour_bits);
    visit("pruning", row.point.pruning);
    visit("colouring", row.point.colouring);
    visit("strategy", row.point.strategy);
    visit("stack_bits", row.point.stack_bits);
    visit("curves", row.point.curves);
    visit("alu_bits", row.point.alu_bits);
    visit("knob", row.knob);
    visit("value", row.value);
    Inputs::columns(row.inputs, visit);
    visit("reason", row.reason);
    visit("strategy_used", row.strategy_used);
    visit("colouring_used", row.colouring_used);
    visit("primitives", row.primitives);
    visit("halfspaces", row.halfspaces);
    visit("instructions", row.instructions);
    visit("rendered", row.rendered);
    visit("classified", row.classified);
    visit("depth_tests", row.depth_tests);
    visit("tree_depth", row.tree_depth);
    visit("classification_bits", row.classification_bits);
    visit("used_bits", row.used_bits);
    visit("memory_map", row.memory_map);
    visit("processors", row.processors);
    visit("machine_memory_bits", row.machine_memory_bits);
    visit("pixel_transistors", row.pixel_transistors);
    visit("machine_transistors", row.machine_transistors);
    visit("machine_mm2", row.machine_mm2);
    visit("frame_joules", row.frame_joules);
    visit("clock_hz", row.clock_hz);
    visit("clock_path", row.clock_path);
    visit("clocks", row.clocks);
    visit("interval_clocks", row.interval_clocks);
    visit("host_clocks", row.host_clocks);
    visit("simulated_seconds", row.simulated_seconds);
    visit("frames_per_second", row.frames_per_second);
    visit("hosted_frames_per_second", row.hosted_frames_per_second);
    visit("picture", row.picture);
    visit("covered", row.covered);
    visit("wrong", row.wrong);
    visit("wrong_silhouette", row.wrong_silhouette);
    visit("wrong_owner", row.wrong_owner);
    visit("unexplained", row.unexplained);
    visit("colour_error", row.colour_error);
    visit("depth_max", row.depth_max);
    visit("depth_p999", row.depth_p999);
    visit("depth_max_steps", row.depth_max_steps);
    visit("depth_p999_steps", row.depth_p999_steps);
    visit("facet_wrong", row.facet_wrong);
    visit("facet_depth_p999", row.facet_depth_p999);
    visit("picture_difference", row.picture_difference);
  }
};

/// A row of a study whose table has the columns `names`, separated by commas. The columns before the inputs identify
/// the point.
template <const std::string_view& names>
struct RowWith : DesignRow {
  static constexpr std::size_t point_columns =
      static_cast<std::size_t>(std::ranges::count(names.substr(0, names.find(",model_hash,")), ',')) + 1;

  RowWith() = default;
  explicit RowWith(DesignRow row) : DesignRow(std::move(row)) {}

  static void columns(auto& row, const auto& visit) {
    for (std::size_t begin = 0; begin <= names.size();) {
      const std::string_view name = names.substr(begin, names.find(',', begin) - begin);
      all_columns(row, [&](const char* known, auto& member) {
        if (name == known) visit(known, member);
      });
      begin += name.size() + 1;
    }
  }
};

inline constexpr std::string_view sweep_columns =
    "model,machine,memory_bits,z_bits,pruning,colouring,strategy,stack_bits,curves,model_hash,machine_hash,csgsim,"
    "strategy_used,colouring_used,primitives,halfspaces,width,height,clocks,interval_clocks,host_clocks,"
    "simulated_seconds,frames_per_second,hosted_frames_per_second,instructions,rendered,classified,depth_tests,tree_"
    "depth,classification_bits,used_bits,pixel_transistors,memory_map,picture,reason";

inline constexpr std::string_view accuracy_columns =
    "knob,value,model_hash,machine_hash,csgsim,clocks,simulated_seconds,halfspaces,used_bits,covered,wrong,"
    "wrong_silhouette,wrong_owner,unexplained,depth_max,depth_p999,depth_max_steps,depth_p999_steps,facet_wrong,"
    "facet_depth_p999,picture_difference";

inline constexpr std::string_view advise_columns =
    "z_bits,fraction_bits,colour_bits,colouring,strategy,stack_bits,alu_bits,model_hash,machine_hash,csgsim,used_bits,"
    "classification_bits,clocks,interval_clocks,frames_per_second,wrong,unexplained,colour_error,reason";

inline constexpr std::string_view explore_columns =
    "model,machine,process,memory_bits,width,height,z_bits,fraction_bits,colour_bits,pruning,colouring,strategy,"
    "stack_bits,curves,model_hash,machine_hash,csgsim,halfspaces,instructions,clock_hz,clock_path,clocks,"
    "interval_clocks,frames_per_second,used_bits,processors,machine_memory_bits,pixel_transistors,machine_transistors,"
    "machine_mm2,frame_joules,wrong,unexplained,reason";

using SweepRow = RowWith<sweep_columns>;
using Measurement = RowWith<accuracy_columns>;
using AdviceRow = RowWith<advise_columns>;
using ExploreRow = RowWith<explore_columns>;

/// The leading cells of a row that identify the point.
template <class Row>
std::string point_cells(const DesignPoint& point) {
  Row row;
  row.point = point;
  return std::string(first_cells(to_line(row), Row::point_columns));
}

}  // namespace csgsim::studies
