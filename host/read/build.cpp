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

TreeBuilder::TreeBuilder(Source& source) : source_(source), open_(1) { tree_.file = source.name(); }

TreeBuilder::OpenNode TreeBuilder::make_open(std::string_view name) const {
  OpenNode open;
  open.name = name;
  open.transform = open_.back().transform;
  open.colour = open_.back().colour;
  open.first_child = children_.size();
  open.first_node = tree_.nodes.size();
  open.first_primitive = tree_.primitives.size();
  return open;
}

void TreeBuilder::begin(const Statement& statement) {
  has_statements_ = true;
  if (left_out_ > 0 || statement.modifiers.disable || statement.modifiers.background) {
    ++left_out_;
    return;
  }
  const NodeType& node = usable_node(source_, statement);
  if (open_.back().is_solid) {
    source_.fail(statement.offset,
                 fmt::format("{0}() has no children; put {1}() beside it, in a union() or difference()",
                             open_.back().name, node.name));
  }
  const Arguments arguments(source_, statement, node);
  open_.push_back(make_open(node.name));
  OpenNode& open = open_.back();
  switch (node.kind) {
    case NodeKind::unite: break;
    case NodeKind::subtract: open.op = model::Operator::subtract; break;
    case NodeKind::intersect: open.op = model::Operator::intersect; break;
    case NodeKind::transform: open.transform = open.transform * read_matrix(arguments); break;
    case NodeKind::colour: {
      const std::optional<Colour> colour = read_colour(arguments);
      if (!open.colour) open.colour = colour;
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
  OpenNode& open = open_.back();
  open.is_solid = true;
  std::optional<model::Shape> shape = read_solid(node.kind, arguments);
  if (!shape || empties(open.transform)) return;
  if (tree_.primitives.size() >= max_primitives) {
    arguments.fail("more than {} solids; split the model", max_primitives);
  }
  children_.push_back(static_cast<std::uint32_t>(tree_.nodes.size()));
  model::Node& leaf = tree_.nodes.emplace_back();
  leaf.is_leaf = true;
  leaf.primitive = static_cast<std::uint32_t>(tree_.primitives.size());
  model::Primitive& primitive = tree_.primitives.emplace_back();
  primitive = {std::move(*shape), open.transform, {}, source_.locate(statement.offset)};
  if (!open.colour) return;
  primitive.colour = open.colour->rgb;
  primitive.opacity = open.colour->opacity;
}

void TreeBuilder::end() {
  if (left_out_ > 0) {
    --left_out_;
  } else {
    close_innermost();
  }
}

void TreeBuilder::close_innermost() {
  const OpenNode open = open_.back();
  open_.pop_back();
  const auto first = children_.begin() + static_cast<std::ptrdiff_t>(open.first_child);
  const bool is_empty = open.is_empty || first == children_.end();
  if (is_empty) {
    tree_.nodes.resize(open.first_node);
    tree_.primitives.resize(open.first_primitive);
    children_.erase(first, children_.end());
  } else if (children_.end() - first > 1) {
    model::Node& node = tree_.nodes.emplace_back();
    node.op = open.op;
    node.children.assign(first, children_.end());
    children_.erase(first, children_.end());
    children_.push_back(static_cast<std::uint32_t>(tree_.nodes.size() - 1));
  }
  if (open_.empty()) return;
  OpenNode& parent = open_.back();
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
  close_innermost();
  if (!children_.empty()) tree_.root = children_.back();
  return std::move(tree_);
}

}  // namespace csgsim::read
