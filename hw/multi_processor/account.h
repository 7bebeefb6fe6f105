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

/// Where a part of the machine spends its clocks. Every clock of the frame is in one activity of each part.
enum class DisplayActivity : std::uint8_t { receiving, transforming, dividing, broadcasting, waiting_for_nodes };
enum class BusActivity : std::uint8_t { busy, granting, idle };
enum class NodeActivity : std::uint8_t { receiving, pruning, sharing, rendering, waiting };

inline constexpr auto display_activity_names =
    std::to_array<std::string_view>({"receiving", "transforming", "dividing", "broadcasting", "waiting_for_nodes"});
inline constexpr auto bus_activity_names = std::to_array<std::string_view>({"busy", "granting", "idle"});
inline constexpr auto node_activity_names =
    std::to_array<std::string_view>({"receiving", "pruning", "sharing", "rendering", "waiting"});

constexpr std::string_view name_of(DisplayActivity one) { return display_activity_names[std::size_t(one)]; }
constexpr std::string_view name_of(BusActivity one) { return bus_activity_names[std::size_t(one)]; }
constexpr std::string_view name_of(NodeActivity one) { return node_activity_names[std::size_t(one)]; }

/// Clocks by activity.
using DisplayClocks = machines::ClockTally<DisplayActivity, display_activity_names.size()>;
using BusClocks = machines::ClockTally<BusActivity, bus_activity_names.size()>;
using NodeClocks = machines::ClockTally<NodeActivity, node_activity_names.size()>;

/// Clocks of the frame by its stages, which come one after the other unless the display processor divides ahead.
struct StageClocks {
  std::uint64_t reception = 0;  ///< of the model
  std::uint64_t transformation = 0;
  std::uint64_t first_pruning = 0;
  std::uint64_t broadcasting = 0;    ///< of the tree, and of half-spaces
  std::uint64_t second_pruning = 0;  ///< by the slowest node of each segment
  std::uint64_t sharing = 0;         ///< of lists
  std::uint64_t rendering = 0;       ///< by the slowest node of each subsegment
  std::uint64_t barriers = 0;

  bool operator==(const StageClocks&) const = default;
};

/// How the frame went by.
struct FrameAccount {
  std::uint64_t segment_count = 0;
  std::uint64_t active_segments = 0;  ///< of which something is left to be divided
  std::uint64_t first_box_tests = 0;  ///< by the display processor
  std::uint64_t first_halfspace_tests = 0;
  std::uint64_t first_cell_tests = 0;
  std::uint64_t second_box_tests = 0;  ///< by the nodes
  std::uint64_t second_halfspace_tests = 0;
  std::uint64_t second_cell_tests = 0;
  std::uint64_t second_tree_nodes = 0;     ///< looked at
  std::uint64_t model_words = 0;           ///< from the host
  std::uint64_t broadcast_primitives = 0;  ///< by the display processor
  std::uint64_t broadcast_halfspaces = 0;
  std::uint64_t broadcast_words = 0;
  std::uint64_t shared_words = 0;  ///< by the nodes
  std::uint64_t list_passes = 0;   ///< times that the nodes rendered what had come of lists
  StageClocks stages;
  DisplayClocks display{};
  BusClocks bus{};
  std::vector<NodeClocks> nodes;  ///< row by row

  bool operator==(const FrameAccount&) const = default;
};

/// As it is told.
machines::Account account(const FrameAccount& counted, const isa::ArrayShape& nodes);

}  // namespace csgsim::multi_processor
