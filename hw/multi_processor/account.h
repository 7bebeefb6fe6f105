#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "hw/machines/accounts.h"
#include "hw/machines/clock_tally.h"
#include "hw/machines/machine.h"

namespace csgsim::multi_processor {

/// Activities of the machine's units. Every clock of the frame is counted under exactly one activity per unit.
enum class DisplayActivity : std::uint8_t { receiving, transforming, dividing, broadcasting, waiting_for_nodes };
enum class BusActivity : std::uint8_t { busy, granting, idle };
enum class NodeActivity : std::uint8_t { receiving, pruning, sharing, rendering, waiting };

inline constexpr auto display_activity_names =
    std::to_array<std::string_view>({"receiving", "transforming", "dividing", "broadcasting", "waiting_for_nodes"});
inline constexpr auto bus_activity_names = std::to_array<std::string_view>({"busy", "granting", "idle"});
inline constexpr auto node_activity_names =
    std::to_array<std::string_view>({"receiving", "pruning", "sharing", "rendering", "waiting"});

constexpr std::string_view name_of(DisplayActivity activity) { return display_activity_names[std::size_t(activity)]; }
constexpr std::string_view name_of(BusActivity activity) { return bus_activity_names[std::size_t(activity)]; }
constexpr std::string_view name_of(NodeActivity activity) { return node_activity_names[std::size_t(activity)]; }

/// Clocks by activity.
using DisplayClocks = machines::ClockTally<DisplayActivity, display_activity_names.size()>;
using BusClocks = machines::ClockTally<BusActivity, bus_activity_names.size()>;
using NodeClocks = machines::ClockTally<NodeActivity, node_activity_names.size()>;

/// Clocks of the frame by stage. The stages are sequential unless the display processor divides ahead.
struct StageClocks {
  std::uint64_t reception = 0;  ///< reception of the model
  std::uint64_t transformation = 0;
  std::uint64_t first_pruning = 0;
  std::uint64_t broadcasting = 0;    ///< broadcast of the tree and of half-spaces
  std::uint64_t second_pruning = 0;  ///< pruning by the slowest node of each segment
  std::uint64_t sharing = 0;         ///< exchange of lists
  std::uint64_t rendering = 0;       ///< rendering by the slowest node of each subsegment
  std::uint64_t barriers = 0;

  bool operator==(const StageClocks&) const = default;
};

/// Counts of one frame.
struct FrameAccount {
  std::uint64_t segment_count = 0;
  std::uint64_t active_segments = 0;  ///< segments with at least one primitive left
  std::uint64_t first_box_tests = 0;  ///< tests by the display processor
  std::uint64_t first_halfspace_tests = 0;
  std::uint64_t first_cell_tests = 0;
  std::uint64_t second_box_tests = 0;  ///< tests by the nodes
  std::uint64_t second_halfspace_tests = 0;
  std::uint64_t second_cell_tests = 0;
  std::uint64_t second_tree_nodes = 0;     ///< tree nodes visited
  std::uint64_t model_words = 0;           ///< words from the host
  std::uint64_t broadcast_primitives = 0;  ///< sent by the display processor
  std::uint64_t broadcast_halfspaces = 0;
  std::uint64_t broadcast_words = 0;
  std::uint64_t shared_words = 0;  ///< sent by the nodes
  std::uint64_t list_passes = 0;   ///< number of times the nodes rendered the received lists
  StageClocks stages;
  DisplayClocks display{};
  BusClocks bus{};
  std::vector<NodeClocks> nodes;  ///< row by row

  bool operator==(const FrameAccount&) const = default;
};

/// Converts the counts to the account that statistics and reports show.
machines::Account account(const FrameAccount& counts, const isa::ArrayShape& nodes);

}  // namespace csgsim::multi_processor
