#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/studies/inputs.h"
#include "sim/studies/sweep/memory_map.h"

namespace csgsim::studies {

/// One way to draw one model: what a sweep varies.
struct SweepPoint {
  std::string model;
  std::string machine;
  std::uint32_t memory_bits = 0;  ///< that the machine has
  unsigned z_bits = 0;
  std::string pruning;
  std::string colouring;
  std::string strategy;
  unsigned stack_bits = 0;      ///< of strategy bits: m; 0 for the others
  std::string curves = "auto";  ///< how curved surfaces are drawn: host/emit/curves.h

  bool operator==(const SweepPoint&) const = default;

  static void columns(auto& point, const auto& visit) {
    visit("model", point.model);
    visit("machine", point.machine);
    visit("memory_bits", point.memory_bits);
    visit("z_bits", point.z_bits);
    visit("pruning", point.pruning);
    visit("colouring", point.colouring);
    visit("strategy", point.strategy);
    visit("stack_bits", point.stack_bits);
    visit("curves", point.curves);
  }
};

/// The values of each dimension, in the order in which they are to be reported.
struct SweepRanges {
  std::vector<std::string> models;
  std::vector<std::string> machines;
  std::map<std::string, std::vector<std::uint32_t>> memory_bits;  ///< of each machine
  std::vector<unsigned> z_bits;
  std::vector<std::string> prunings;
  std::vector<std::string> colourings;
  std::vector<std::string> curves{"auto"};
  std::vector<std::string> strategies;
  std::vector<unsigned> stack_bits;
};

/// The product of the ranges; a strategy other than bits is one point for all stack bits.
std::vector<SweepPoint> points_of(const SweepRanges& ranges);

/// Stands for the hash of a picture where a linear expression did not fit its width: a fault of the Program.
inline constexpr std::string_view overflow = "overflow";

/// What a point takes. Where `reason` says why there is no such Program, the counts are 0.
struct SweepRow {
  static constexpr std::size_t point_columns = 9;

  SweepPoint point;
  Inputs inputs;
  std::string reason;
  std::string strategy_used;
  std::string colouring_used;
  std::uint64_t primitives = 0;  ///< of the model
  std::uint64_t halfspaces = 0;  ///< of the model
  std::uint32_t width = 0;       ///< pixels
  std::uint32_t height = 0;      ///< pixels
  std::uint64_t clocks = 0;      ///< latency included
  double simulated_seconds = 0;
  std::uint64_t instructions = 0;
  std::uint64_t rendered = 0;             ///< scan-conversions: primitives whose surface goes into Z1
  std::uint64_t classified = 0;           ///< scan-conversions: primitives of active trees compared with Z1
  std::uint64_t depth_tests = 0;          ///< comparisons of Z1 with Z2
  std::uint32_t tree_depth = 0;           ///< levels of the deepest active tree
  std::uint32_t classification_bits = 0;  ///< memory bits a pixel that the classification uses
  std::uint32_t used_bits = 0;            ///< memory bits a pixel in all
  /// Of a pixel with as much memory as that, and for a picture shown beside it: hw/machines/area.h.
  std::optional<std::uint64_t> pixel_transistors{};
  MemoryMap memory_map;
  std::string picture;  ///< hash of depth, owner and colour of every pixel, or `overflow`; empty where it was not drawn

  [[nodiscard]] bool compiled() const { return reason.empty(); }
  bool operator==(const SweepRow&) const = default;

  static void columns(auto& row, const auto& visit) {
    SweepPoint::columns(row.point, visit);
    Inputs::columns(row.inputs, visit);
    visit("strategy_used", row.strategy_used);
    visit("colouring_used", row.colouring_used);
    visit("primitives", row.primitives);
    visit("halfspaces", row.halfspaces);
    visit("width", row.width);
    visit("height", row.height);
    visit("clocks", row.clocks);
    visit("simulated_seconds", row.simulated_seconds);
    visit("instructions", row.instructions);
    visit("rendered", row.rendered);
    visit("classified", row.classified);
    visit("depth_tests", row.depth_tests);
    visit("tree_depth", row.tree_depth);
    visit("classification_bits", row.classification_bits);
    visit("used_bits", row.used_bits);
    visit("pixel_transistors", row.pixel_transistors);
    visit("memory_map", row.memory_map);
    visit("picture", row.picture);
    visit("reason", row.reason);
  }
};

std::string strategy_name(const SweepPoint& point);

/// Rows that differ in strategy and stack bits only, in the order of the rows.
std::vector<std::vector<SweepRow>> by_conditions(std::span<const SweepRow> rows);

/// A point whose picture is not what it has to be.
struct WrongPicture {
  SweepPoint point;
  std::optional<SweepPoint> reference;  ///< the point whose picture it should have; none where the Program overflows
};

/// Points whose picture differs from the first of the same model, size, z bits and surfaces, and those that overflow.
std::vector<WrongPicture> wrong_pictures(std::span<const SweepRow> rows);

}  // namespace csgsim::studies
