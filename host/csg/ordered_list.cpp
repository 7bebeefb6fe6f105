#include "host/csg/ordered_list.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace csgsim::csg {

namespace {

/// Whether a target's label is in use before the first leaf of a subtree.
enum class Label : std::uint8_t { not_yet, alive, never };

/// The label states of the two targets of a subtree.
struct Context {
  Label in;
  Label out;
};

/// Numbers of labels, indexed by context.
class Table {
 public:
  std::uint32_t& operator[](Context c) { return at_[index(c)]; }
  std::uint32_t operator[](Context c) const { return at_[index(c)]; }

 private:
  static std::size_t index(Context c) { return static_cast<std::size_t>(c.in) * 3 + static_cast<std::size_t>(c.out); }
  std::array<std::uint32_t, 6> at_{};
};

/// A leaf, or an operator over at least two children with other operators.
struct Node {
  std::uint32_t source = model::no_index;  ///< index of the active tree's node
  PositiveOperator op = PositiveOperator::intersect;
  std::uint32_t first_child = 0;
  std::uint32_t child_count = 0;  ///< 0 for a leaf
  std::uint32_t leaves = 0;
  /// Maximum number of labels in use between two leaves of this subtree, for the best order of operands. It counts the
  /// leaves of this subtree that pixels wait for, and its two targets.
  Table labels{};
};

/// Parents precede their children, which are consecutive; the root is first.
using Nodes = std::vector<Node>;

/// Appends the nodes in `sources`, operands of `op`; nested operators of the same kind are replaced by their operands.
void append_operands(const ActiveTree& active, PositiveOperator op, std::span<const std::uint32_t> sources,
                     Nodes& into) {
  std::vector<std::uint32_t> open(sources.rbegin(), sources.rend());
  while (!open.empty()) {
    const std::uint32_t source = open.back();
    open.pop_back();
    const ActiveNode& node = active.nodes[source];
    if (!node.is_leaf && (node.op == op || node.children.size() == 1)) {
      open.insert(open.end(), node.children.rbegin(), node.children.rend());
    } else {
      into.push_back({.source = source, .op = node.op});
    }
  }
}

Nodes flatten(const ActiveTree& active) {
  Nodes nodes;
  append_operands(active, PositiveOperator::intersect, active.operands, nodes);
  if (nodes.size() > 1) {
    const auto operands = static_cast<std::uint32_t>(nodes.size());
    nodes.insert(nodes.begin(), {.first_child = 1, .child_count = operands});
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::uint32_t source = nodes[i].source;
    if (source == model::no_index || active.nodes[source].is_leaf) continue;
    const auto first = static_cast<std::uint32_t>(nodes.size());
    append_operands(active, nodes[i].op, active.nodes[source].children, nodes);
    nodes[i].first_child = first;
    nodes[i].child_count = static_cast<std::uint32_t>(nodes.size()) - first;
  }
  return nodes;
}

/// The states of an operator's targets: `through` for the target reached past all operands (for an intersection, that
/// of "in"), and `exit` for the target reached from each operand.
struct Directed {
  Label through;
  Label exit;
};

Directed directed(PositiveOperator op, Context c) {
  return op == PositiveOperator::intersect ? Directed{c.in, c.out} : Directed{c.out, c.in};
}

Context context(PositiveOperator op, Directed d) {
  return op == PositiveOperator::intersect ? Context{d.through, d.exit} : Context{d.exit, d.through};
}

Label after_jump(Label label) { return label == Label::never ? Label::never : Label::alive; }

std::uint32_t count(Label label) { return label == Label::alive ? 1 : 0; }

/// A child other than the last passes through to its next sibling, whose label only the child's own leaves can have
/// allocated.
Context child_context(const Node& parent, Context c, bool first, bool last) {
  const auto [through, exit] = directed(parent.op, c);
  return context(parent.op, {last ? through : Label::not_yet, first ? exit : after_jump(exit)});
}

struct Order {
  std::uint32_t first;
  std::uint32_t last;
};

/// Chooses the order of a node's children in one context. Only the first and the last child matter.
class Orderer {
 public:
  Orderer(const Nodes& nodes, const Node& parent, Context c)
      : nodes_(nodes),
        first_(child_context(parent, c, true, false)),
        middle_(child_context(parent, c, false, false)),
        last_(child_context(parent, c, false, true)),
        passing_(count(directed(parent.op, c).through)),
        between_(1 + count(after_jump(directed(parent.op, c).exit)) + passing_),
        natural_{parent.first_child, parent.first_child + parent.child_count - 1} {
    for (std::uint32_t child = natural_.first; child <= natural_.last; ++child) keep_if_costly(child);
  }

  /// No child needs more labels at an end than in the middle, so the two costliest belong at the ends.
  [[nodiscard]] Order best() const {
    const std::array orders{natural_, Order{costliest_[0], costliest_[1]}, Order{costliest_[1], costliest_[0]}};
    return *std::ranges::min_element(orders, {}, [&](Order order) { return labels(order); });
  }

  [[nodiscard]] std::uint32_t labels(Order order) const {
    std::uint32_t most = std::max({between_, nodes_[order.first].labels[first_] + passing_,  //
                                   nodes_[order.last].labels[last_]});
    for (const std::uint32_t child : costliest_) {
      if (child == model::no_index || child == order.first || child == order.last) continue;
      most = std::max(most, nodes_[child].labels[middle_] + passing_);
    }
    return most;
  }

 private:
  void keep_if_costly(std::uint32_t child) {
    for (std::uint32_t& kept : costliest_) {
      if (child == model::no_index) return;
      if (kept == model::no_index || nodes_[child].labels[middle_] > nodes_[kept].labels[middle_]) {
        std::swap(kept, child);
      }
    }
  }

  const Nodes& nodes_;
  Context first_;
  Context middle_;
  Context last_;
  std::uint32_t passing_;  ///< labels in use across all children but the last, to which none of them jumps
  std::uint32_t between_;  ///< labels in use between two children
  Order natural_;
  /// The children that need the most labels in the middle, the costliest first.
  std::array<std::uint32_t, 3> costliest_{model::no_index, model::no_index, model::no_index};
};

void count_labels(Nodes& nodes) {
  for (std::size_t i = nodes.size(); i-- > 0;) {
    Node& node = nodes[i];
    if (node.child_count == 0) {
      node.leaves = 1;
      continue;
    }
    for (std::uint32_t c = 0; c < node.child_count; ++c) node.leaves += nodes[node.first_child + c].leaves;
    // Only FALSE needs no label, and FALSE is never the target of "in".
    for (const Label in : {Label::not_yet, Label::alive}) {
      for (const Label out : {Label::not_yet, Label::alive, Label::never}) {
        const Orderer orderer(nodes, node, {in, out});
        node.labels[{in, out}] = orderer.labels(orderer.best());
      }
    }
  }
}

Nodes prepare(const ActiveTree& active) {
  Nodes nodes = flatten(active);
  count_labels(nodes);
  return nodes;
}

/// A position in the list: that of a leaf, or one of the results.
using Position = std::uint32_t;

/// A leaf of the list before labels are assigned. Its targets apply to the leaf as it is in the tree, complemented or
/// not.
struct WiredLeaf {
  std::uint32_t source = model::no_index;
  Position if_true = 0;
  Position if_false = 0;
};

struct Wiring {
  std::vector<WiredLeaf> leaves;
  Position visible = 0;
  Position hidden = 0;
};

/// A subtree with its position in the list.
struct Placed {
  std::uint32_t node;
  Context context;
  Position begin;
  Position if_true;
  Position if_false;
};

/// Appends the children of a placed operator in the best order.
void place_children(const Nodes& nodes, const Placed& parent, std::vector<Placed>& into) {
  const Node& node = nodes[parent.node];
  const Order order = Orderer(nodes, node, parent.context).best();
  Position begin = parent.begin;
  const auto place = [&](std::uint32_t child, bool first, bool last) {
    Placed placed{child, child_context(node, parent.context, first, last), begin, parent.if_true, parent.if_false};
    begin += nodes[child].leaves;
    if (!last) (node.op == PositiveOperator::intersect ? placed.if_true : placed.if_false) = begin;
    into.push_back(placed);
  };
  place(order.first, true, false);
  for (std::uint32_t child = node.first_child; child < node.first_child + node.child_count; ++child) {
    if (child != order.first && child != order.last) place(child, false, false);
  }
  place(order.last, false, true);
}

Wiring wire(const Nodes& nodes, Context root) {
  const Position leaves = nodes.empty() ? 0 : nodes.front().leaves;
  Wiring wiring{std::vector<WiredLeaf>(leaves), leaves, leaves + 1};
  std::vector<Placed> open;
  if (leaves > 0) open.push_back({0, root, 0, wiring.visible, wiring.hidden});
  while (!open.empty()) {
    const Placed placed = open.back();
    open.pop_back();
    const Node& node = nodes[placed.node];
    if (node.child_count > 0) {
      place_children(nodes, placed, open);
    } else {
      wiring.leaves[placed.begin] = {node.source, placed.if_true, placed.if_false};
    }
  }
  return wiring;
}

/// Assigns labels to positions, from the first leaf to the last.
class Labeller {
 public:
  explicit Labeller(const Wiring& wiring) : wiring_(wiring), label_(wiring.leaves.size() + 1, no_label) {
    label_.front() = 0;
  }

  /// Assigns labels to the leaf's targets that have none: the first gets the leaf's own label, a second one a free
  /// label. Frees the leaf's label if no target got it. Leaves are passed in order.
  void pass(Position at) {
    const WiredLeaf& leaf = wiring_.leaves[at];
    const std::uint32_t own = label_[at];
    bool own_taken = false;
    for (const Position target : {std::min(leaf.if_true, leaf.if_false), std::max(leaf.if_true, leaf.if_false)}) {
      if (target == wiring_.hidden || label_[target] != no_label) continue;
      label_[target] = own_taken ? take_near(own) : own;
      own_taken = true;
    }
    if (!own_taken) free_.push_back(own);
  }

  [[nodiscard]] std::uint32_t label(Position at) const { return label_[at]; }
  [[nodiscard]] std::uint32_t labels() const { return labels_; }

  [[nodiscard]] Target target(Position at) const {
    if (at == wiring_.hidden) return {};
    return {at == wiring_.visible ? Destination::visible : Destination::leaf, label_[at]};
  }

 private:
  std::uint32_t take_near(std::uint32_t name) {
    if (free_.empty()) return labels_++;
    const auto distance = [&](std::uint32_t label) { return std::pair(std::popcount(label ^ name), label); };
    const auto nearest = std::ranges::min_element(free_, {}, distance);
    const std::uint32_t label = *nearest;
    free_.erase(nearest);
    return label;
  }

  const Wiring& wiring_;
  std::vector<std::uint32_t> label_;
  std::vector<std::uint32_t> free_;
  std::uint32_t labels_ = 1;
};

}  // namespace

OrderedList make_ordered_list(const ActiveTree& active) {
  const Wiring wiring = wire(prepare(active), {Label::not_yet, Label::never});
  Labeller labeller(wiring);
  OrderedList list;
  list.leaves.reserve(wiring.leaves.size());
  for (Position at = 0; at < wiring.leaves.size(); ++at) {
    labeller.pass(at);
    const WiredLeaf& leaf = wiring.leaves[at];
    const ActiveNode& source = active.nodes[leaf.source];
    Target if_in = labeller.target(leaf.if_true);
    Target if_out = labeller.target(leaf.if_false);
    if (source.complemented) std::swap(if_in, if_out);
    list.leaves.push_back({source.primitive, labeller.label(at), if_in, if_out, leaf.source});
  }
  list.true_label = labeller.label(wiring.visible);
  list.labels = labeller.labels();
  list.label_bits = static_cast<std::uint32_t>(std::bit_width(list.labels - 1));
  return list;
}

std::uint32_t footprint(const ActiveTree& active) {
  const Nodes nodes = prepare(active);
  if (nodes.empty()) return 1;
  constexpr std::uint32_t after_last_leaf = 2;
  return std::max(after_last_leaf, nodes.front().labels[{Label::not_yet, Label::not_yet}]);
}

}  // namespace csgsim::csg
