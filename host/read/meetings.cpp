#include "host/read/meetings.h"

#include "host/read/nodes.h"

namespace csgsim::read {

void MeetingFinder::begin(const Statement& statement) {
  const NodeType* const node = find_node_type(statement.name);
  const bool is_shape =
      node != nullptr && (node->kind == NodeKind::solid || (node->kind == NodeKind::made && !node->has_children));
  open_.push_back({statement.offset, is_shape, 0});
}

void MeetingFinder::end() {
  const Open ended = open_.back();
  open_.pop_back();
  if (ended.shapes > 1) meetings_.statements.insert(ended.offset);
  if (!ended.is_shape && ended.shapes == 0) return;
  if (open_.empty()) {
    meetings_.at_top_level = ++top_shapes_ > 1;
  } else {
    ++open_.back().shapes;
  }
}

}  // namespace csgsim::read
