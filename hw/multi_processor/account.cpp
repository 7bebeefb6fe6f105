#include "hw/multi_processor/account.h"

#include <algorithm>
#include <string>

namespace csgsim::multi_processor {

namespace {

std::uint64_t working(const NodeClocks& node) { return node.total() - node.of(NodeActivity::waiting); }

machines::Share mean_share(const FrameAccount& counts) {
  machines::Share share{.name = "node_utilisation"};
  for (const NodeClocks& node : counts.nodes) {
    share.part += working(node);
    share.whole += node.total();
  }
  return share;
}

/// Share of the clocks in which the busiest node works.
machines::Share busiest_share(const FrameAccount& counts) {
  machines::Share share{.name = "busiest_node_utilisation"};
  for (const NodeClocks& node : counts.nodes) {
    share.part = std::max(share.part, working(node));
    share.whole = node.total();
  }
  return share;
}

}  // namespace

machines::Account account(const FrameAccount& counts, const isa::ArrayShape& nodes) {
  const StageClocks& stages = counts.stages;
  machines::Account result{
      .counts = {{"segments", counts.segment_count},
                 {"active_segments", counts.active_segments},
                 {"first_box_tests", counts.first_box_tests},
                 {"first_halfspace_tests", counts.first_halfspace_tests},
                 {"first_cell_tests", counts.first_cell_tests},
                 {"second_box_tests", counts.second_box_tests},
                 {"second_halfspace_tests", counts.second_halfspace_tests},
                 {"second_cell_tests", counts.second_cell_tests},
                 {"second_tree_nodes", counts.second_tree_nodes},
                 {"model_words", counts.model_words},
                 {"broadcast_primitives", counts.broadcast_primitives},
                 {"broadcast_halfspaces", counts.broadcast_halfspaces},
                 {"broadcast_words", counts.broadcast_words},
                 {"shared_words", counts.shared_words},
                 {"list_passes", counts.list_passes},
                 {"reception_clocks", stages.reception},
                 {"transformation_clocks", stages.transformation},
                 {"first_pruning_clocks", stages.first_pruning},
                 {"broadcasting_clocks", stages.broadcasting},
                 {"second_pruning_clocks", stages.second_pruning},
                 {"sharing_clocks", stages.sharing},
                 {"rendering_clocks", stages.rendering},
                 {"barrier_clocks", stages.barriers}},
      .shares = {mean_share(counts), busiest_share(counts)},
      .parts = {machines::part_account("display processor", counts.display, display_activity_names),
                machines::part_account("control bus", counts.bus, bus_activity_names)}};
  for (std::size_t i = 0; i < counts.nodes.size(); ++i) {
    const std::string name = "node " + std::to_string(i / nodes.width) + "," + std::to_string(i % nodes.width);
    result.parts.push_back(machines::part_account(name, counts.nodes[i], node_activity_names));
  }
  return result;
}

}  // namespace csgsim::multi_processor
