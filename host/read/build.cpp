#include "host/read/build.h"

#include <fmt/format.h>

#include <utility>

#include "host/read/limits.h"
#include "host/read/placement.h"
#include "host/read/solids.h"
#include "hw/base/error.h"

namespace csgsim::read {

namespace {

const NodeType& usable_node(Source& source, const Statement& statement) {
  const NodeType* node = find_node(statement.name);
  if (node == nullptr) source.fail(statement.offset, unknown_node(statement.name));
  if (node->kind == NodeKind::unsupported || node->kind == NodeKind::source) {
    source.fail(statement.offset, unusable_node(*node));
  }
  return *node;
}

}  // namespace

TreeBuilder::TreeBuilder(Source& source) : source_(source), frames_(1) { tree_.file = source.name(); }

TreeBuilder::Frame TreeBuilder::make_frame(std::string_view name) const {
  Frame frame;
  frame.name = name;
  frame.transform = frames_.back().transform;
  frame.colour = frames_.back().colour;
  frame.first_child = children_.size();
  frame.first_node = tree_.nodes.size();
  frame.first_primitive = tree_.primitives.size();
  return frame;
}

void TreeBuilder::begin(const Statement& statement) {
  has_statements_ = true;
  if (left_out_ > 0 || statement.modifiers.disable || statement.modifiers.background) {
    ++left_out_;
    return;
  }
  const NodeType& node = usable_node(source_, statement);
  if (frames_.back().is_solid) {
    source_.fail(statement.offset,
                 fmt::format("{0}() has no children; put {1}() beside it, in a union() or difference()",
                             frames_.back().name, node.name));
  }
  const Arguments arguments(source_, statement, node);
  frames_.push_back(make_frame(node.name));
  Frame& frame = frames_.back();
  switch (node.kind) {
    case NodeKind::unite: break;
    case NodeKind::subtract: frame.op = model::Operator::subtract; break;
    case NodeKind::intersect: frame.op = model::Operator::intersect; break;
    case NodeKind::transform: frame.transform = frame.transform * read_matrix(arguments); break;
    case NodeKind::colour: {
      const std::optional<glm::dvec3> colour = read_colour(arguments);
      if (!frame.colour) frame.colour = colour;
      break;
    }
    case NodeKind::cube:
    case NodeKind::sphere:
    case NodeKind::cylinder:
    case NodeKind::polyhedron: add_solid(node, statement, arguments); break;
    case NodeKind::unsupported:
    case NodeKind::source: break;
  }
}

void TreeBuilder::add_solid(const NodeType& node, const Statement& statement, const Arguments& arguments) {
  Frame& frame = frames_.back();
  frame.is_solid = true;
  std::optional<model::Shape> shape = read_solid(node.kind, arguments);
  if (!shape || empties(frame.transform)) return;
  if (tree_.primitives.size() >= max_primitives) {
    arguments.fail("more than {} solids; split the model", max_primitives);
  }
  children_.push_back(static_cast<std::uint32_t>(tree_.nodes.size()));
  model::Node& leaf = tree_.nodes.emplace_back();
  leaf.is_leaf = true;
  leaf.primitive = static_cast<std::uint32_t>(tree_.primitives.size());
  tree_.primitives.push_back({std::move(*shape), frame.transform, frame.colour, source_.locate(statement.offset)});
}

void TreeBuilder::end() {
  if (left_out_ > 0) {
    --left_out_;
  } else {
    close_frame();
  }
}

void TreeBuilder::close_frame() {
  const Frame frame = frames_.back();
  frames_.pop_back();
  const auto first = children_.begin() + static_cast<std::ptrdiff_t>(frame.first_child);
  const bool is_empty = frame.is_empty || first == children_.end();
  if (is_empty) {
    tree_.nodes.resize(frame.first_node);
    tree_.primitives.resize(frame.first_primitive);
    children_.erase(first, children_.end());
  } else if (children_.end() - first > 1) {
    model::Node& node = tree_.nodes.emplace_back();
    node.op = frame.op;
    node.children.assign(first, children_.end());
    children_.erase(first, children_.end());
    children_.push_back(static_cast<std::uint32_t>(tree_.nodes.size() - 1));
  }
  if (frames_.empty()) return;
  Frame& parent = frames_.back();
  if (is_empty) {
    parent.is_empty |= parent.op == model::Operator::intersect;
    parent.is_empty |= parent.op == model::Operator::subtract && !parent.has_operands;
  }
  parent.has_operands = true;
}

model::Tree TreeBuilder::finish() {
  if (!has_statements_) {
    throw InputError(fmt::format("{}: there is no model in it; export one from OpenSCAD", source_.name()));
  }
  close_frame();
  if (!children_.empty()) tree_.root = children_.back();
  return std::move(tree_);
}

}  // namespace csgsim::read
