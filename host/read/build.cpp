#include "host/read/build.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "host/flat/combine.h"
#include "host/flat/place.h"
#include "host/model/subtree.h"
#include "host/read/limits.h"
#include "host/read/placement.h"
#include "host/solids/extrusion.h"
#include "hw/base/error.h"
#include "hw/base/messages.h"

namespace csgsim::read {

namespace {

const NodeType& usable_node(Source& source, const Statement& statement) {
  const NodeType* node = find_node_type(statement.name);
  if (node == nullptr) source.fail(statement.offset, unknown_node_text(statement.name));
  if (node->kind == NodeKind::unsupported || node->kind == NodeKind::source) {
    source.fail(statement.offset, unusable_node_text(*node));
  }
  return *node;
}

}  // namespace

TreeBuilder::TreeBuilder(Source& source, const Options& options, Meetings meetings)
    : source_(source), options_(options), meetings_(std::move(meetings)), open_(1) {
  tree_.file = source.name();
  open_.back().mesh_placement.meets_others = meetings_.at_top_level;
}

TreeBuilder::OpenNode TreeBuilder::make_open_node(const Statement& statement) const {
  OpenNode open;
  open.offset = statement.offset;
  open.location = source_.locate(statement.offset);
  open.transform = open_.back().transform;
  open.mesh_placement = open_.back().mesh_placement;
  open.colour = open_.back().colour;
  open.first_child = children_.size();
  open.first_node = tree_.nodes.size();
  open.first_primitive = tree_.primitives.size();
  return open;
}

void TreeBuilder::charge_statement(const Statement& statement) {
  constexpr std::uint64_t statement_steps = 2'000;
  try {
    options_.work.charge(statement_steps, "reading statements");
  } catch (const InputError& error) {
    source_.fail(statement.offset, error.what());
  }
}

void TreeBuilder::begin(const Statement& statement) {
  charge_statement(statement);
  const NodeType& node = usable_node(source_, statement);
  if (!open_.back().takes_children) {
    source_.fail(statement.offset,
                 fmt::format("{0}() cannot have children; put {1}() next to it, in a union() or difference()",
                             open_.back().name, node.name));
  }
  const Arguments arguments(source_, statement, node, open_.back().mesh_placement);
  open_.push_back(make_open_node(statement));
  OpenNode& open = open_.back();
  open.name = node.name;
  switch (node.kind) {
    case NodeKind::unite: break;
    case NodeKind::subtract: open.op = model::Operator::subtract; break;
    case NodeKind::intersect: open.op = model::Operator::intersect; break;
    case NodeKind::transform: {
      const glm::dmat4 matrix = placement(arguments);
      open.is_removed = std::isnan(matrix[0][0]);
      open.transform = open.transform * matrix;
      open.mesh_placement.transform = open.mesh_placement.transform * matrix;
      break;
    }
    case NodeKind::colour: {
      const Colour colour = read_colour(arguments);
      if (!open.colour || !open.colour->is_whole) open.colour = colour;
      break;
    }
    case NodeKind::solid: add_solid(node, arguments); break;
    case NodeKind::made:
      open.maker = node.maker(arguments);
      open.takes_children = node.has_children;
      open.dimensions = node.dimensions;
      open.outer = std::exchange(open.transform, glm::dmat4(1));
      open.mesh_placement.transform = glm::dmat4(1);
      break;
    case NodeKind::unsupported:
    case NodeKind::source: break;
  }
  if (meetings_.statements.contains(statement.offset)) open.mesh_placement = {.meets_others = true};
}

/// The matrix of the innermost statement.
glm::dmat4 TreeBuilder::placement(const Arguments& arguments) {
  const glm::dmat4 written = read_matrix(arguments);
  if (!options_.restores_rotations || is_degenerate(written) || is_along_axes(written)) return written;
  const std::optional<glm::dmat4> found = restored(written);
  if (!found && restored_.as_written++ == 0) restored_.first_as_written = open_.back().location;
  if (found) ++restored_.restored;
  return found.value_or(written);
}

void TreeBuilder::report_restored() const {
  if (!options_.restores_rotations) return;
  std::string line = fmt::format("{}: {} of {} rotated matrices restored", source_.name(), restored_.restored,
                                 restored_.restored + restored_.as_written);
  if (restored_.as_written > 0)
    line += fmt::format("; the first one left as written is at {}:{}", restored_.first_as_written.line,
                        restored_.first_as_written.column);
  report_line(line);
}

void TreeBuilder::add_solid(const NodeType& node, const Arguments& arguments) {
  OpenNode& open = open_.back();
  open.takes_children = false;
  open.made = 3;
  std::optional<model::Shape> shape = node.solid(arguments);
  if (shape && !is_degenerate(open.transform)) add_leaf(open, *std::move(shape), open.transform);
}

void TreeBuilder::add_leaf(const OpenNode& open, model::Shape shape, const glm::dmat4& transform) {
  if (tree_.primitives.size() >= max_primitives)
    source_.fail(open.offset, fmt::format("more than {} solids; split the model", max_primitives));
  children_.push_back(model::add_leaf(tree_, {}));
  model::Primitive& primitive = tree_.primitives.back();
  primitive.shape = std::move(shape);
  primitive.transform = transform;
  primitive.location = open.location;
  if (!open.colour) return;
  primitive.colour = open.colour->rgb;
  primitive.opacity = open.colour->opacity;
}

/// Takes the operands of a node, each as a separate tree.
Operands TreeBuilder::take_operands(OpenNode& open) {
  Operands operands{std::exchange(open.areas, {}), {}, open.dimensions};
  auto node = static_cast<std::uint32_t>(open.first_node);
  auto primitive = static_cast<std::uint32_t>(open.first_primitive);
  for (std::size_t child = open.first_child; child < children_.size(); ++child) {
    operands.solids.push_back(model::subtree(tree_, children_[child], node, primitive));
    node = children_[child] + 1;
    primitive += static_cast<std::uint32_t>(operands.solids.back().primitives.size());
  }
  operands.work = options_.work;
  drop_operands(open);
  return operands;
}

void TreeBuilder::drop_operands(const OpenNode& open) {
  tree_.nodes.resize(open.first_node);
  tree_.primitives.resize(open.first_primitive);
  children_.resize(open.first_child);
}

/// Replaces the operands of a node by its result.
void TreeBuilder::make_node(OpenNode& open) {
  NodeResult made;
  try {
    made = open.maker(take_operands(open));
  } catch (const InputError& error) {
    source_.fail(open.offset, fmt::format("{}(): {}", open.name, error.what()));
  }
  for (const std::string& warning : made.warnings)
    source_.print_message(open.offset, fmt::format("warning: {}(): {}", open.name, warning));
  open.made = made.dimensions;
  if (is_degenerate(open.outer)) return;
  add_pieces(open, std::move(made.pieces));
  if (!made.holes.empty()) open.op = model::Operator::subtract;
  add_pieces(open, std::move(made.holes));
  if (!made.area.empty()) open.areas.push_back(flat::transformed(made.area, open.outer));
}

void TreeBuilder::add_pieces(const OpenNode& open, std::vector<model::Polyhedron> pieces) {
  for (model::Polyhedron& piece : pieces) {
    add_leaf(open, std::move(piece), open.outer);
    model::Primitive& primitive = tree_.primitives.back();
    primitive.node = open.name;
    primitive.continues = tree_.primitives.size() - 1 > open.first_primitive;
  }
}

/// The combination of areas by the node's operator.
flat::Area TreeBuilder::combine_areas(OpenNode& open) const {
  if (open.areas.empty()) return {};
  if (open.areas.size() == 1) return std::move(open.areas.front());
  try {
    switch (open.op) {
      case model::Operator::unite: return flat::unite(open.areas, options_.work);
      case model::Operator::subtract: return flat::subtract(open.areas, options_.work);
      case model::Operator::intersect: return flat::intersect(open.areas, options_.work);
    }
  } catch (const InputError& error) {
    source_.fail(open.offset, fmt::format("{}(): {}", open.name, error.what()));
  }
  return {};
}

void TreeBuilder::close_innermost() {
  if (open_.back().maker) make_node(open_.back());
  OpenNode open = std::move(open_.back());
  open_.pop_back();
  if (open.is_empty) {
    drop_operands(open);
  } else {
    join_operands(open, static_cast<bool>(open.maker));
  }
  if (!open_.empty()) add_to_enclosing(open, make_result(open));
}

TreeBuilder::Result TreeBuilder::make_result(OpenNode& open) const {
  Result result;
  result.dimensions = result_dimensions(open);
  result.area = combine_areas(open);
  result.is_empty = result.area.empty() && children_.size() == open.first_child;
  return result;
}

/// The dimensions of a statement's result, as in OpenSCAD: a single operand is passed on unchanged; several areas give
/// an area, possibly empty; solids that are all empty give no result.
std::uint32_t TreeBuilder::result_dimensions(const OpenNode& open) const {
  if (open.is_removed) return 0;
  if (children_.size() > open.first_child) return 3;
  if (open.maker || !open.takes_children) return !open.areas.empty() ? 2 : open.made;
  if (open.dimensions == 2) return open.areas.size() == 1 && open.areas.front().empty() ? 0 : 2;
  if (open.dimensions == 0 || open.is_nothing) return 0;
  return open.op == model::Operator::unite && open.operands > 1 ? 0 : open.dimensions;
}

/// Joins several trees into one.
void TreeBuilder::join_operands(const OpenNode& open, bool of_pieces) {
  const auto first = children_.begin() + static_cast<std::ptrdiff_t>(open.first_child);
  if (children_.end() - first < 2) return;
  model::Node& node = tree_.nodes.emplace_back();
  node.op = open.op;
  node.of_pieces = of_pieces;
  node.children.assign(first, children_.end());
  children_.erase(first, children_.end());
  children_.push_back(static_cast<std::uint32_t>(tree_.nodes.size() - 1));
}

/// Passes the result to the enclosing statement. Areas at the top level become plates, as OpenSCAD shows them.
void TreeBuilder::add_to_enclosing(OpenNode& open, Result result) {
  if (result.dimensions != 0 && !accepts(open, result)) {
    drop_operands(open);
    result = {};
  }
  OpenNode& parent = open_.back();
  count_operand(parent, result);
  const bool is_file = open_.size() == 1;
  if (is_file && !result.area.empty()) {
    open.outer = glm::dmat4(1);
    add_pieces(open, solids::linear_extrude(result.area, {.height = 1, .center = true}, options_.work));
    open.op = model::Operator::unite;
    join_operands(open, true);
    tree_.is_flat = true;
  } else if (!is_file && parent.dimensions != 3) {
    parent.areas.push_back(std::move(result.area));
  }
}

/// Counts an operand. An empty operand makes an intersection empty, and an empty first operand makes a difference
/// empty.
void TreeBuilder::count_operand(OpenNode& parent, const Result& result) {
  const bool is_first = parent.operands++ == 0;
  if (!result.is_empty) return;
  const bool intersects = parent.op == model::Operator::intersect;
  if (!intersects && !(is_first && parent.op == model::Operator::subtract)) return;
  parent.is_empty = true;
  parent.is_nothing |= result.dimensions == 0 || !is_first;
}

/// Whether a result can be an operand of the enclosing statement. As in OpenSCAD, the first operand with dimensions,
/// even if it is empty, determines which operands are accepted.
bool TreeBuilder::accepts(const OpenNode& open, const Result& result) {
  OpenNode& parent = open_.back();
  if (parent.dimensions == 0) {
    parent.dimensions = result.dimensions;
    if (result.dimensions == 3) parent.areas.clear();
  }
  if (parent.dimensions == result.dimensions) return true;
  if (result.is_empty) return false;
  source_.print_message(
      open.offset,
      fmt::format("{}() is {} and is dropped, as in OpenSCAD, because {} shapes are expected here", open.name,
                  result.dimensions == 2 ? "flat" : "solid", result.dimensions == 2 ? "solid" : "flat"));
  return false;
}

model::Tree TreeBuilder::finish() {
  close_innermost();
  report_restored();
  if (!children_.empty()) tree_.root = children_.back();
  tree_.imports = source_.files();
  return std::move(tree_);
}

}  // namespace csgsim::read
