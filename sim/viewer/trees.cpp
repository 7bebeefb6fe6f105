#include "sim/viewer/trees.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/emit/divided.h"
#include "host/emit/strategy.h"
#include "host/view/projection.h"
#include "hw/isa/facts.h"
#include "hw/isa/pieces.h"
#include "hw/machines/kind.h"

namespace csgsim::viewer {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t max_rows = 4000;

/// A node that has not been shown yet.
struct Waiting {
  std::uint32_t node = 0;
  std::size_t depth = 0;
};

std::string_view name_of(model::Operator op) {
  switch (op) {
    case model::Operator::unite: return "union";
    case model::Operator::subtract: return "difference";
    case model::Operator::intersect: return "intersection";
  }
  return "";
}

/// The first leaf below the node.
std::uint32_t first_piece(const model::Tree& tree, std::uint32_t node) {
  while (!tree.nodes[node].is_leaf) node = tree.nodes[node].children.front();
  return tree.nodes[node].primitive;
}

Json primitive_row(std::size_t depth, std::uint32_t piece, const isa::Facts& facts) {
  const std::uint32_t primitive = isa::primitive_of(facts, piece);
  const std::string name = primitive < facts.primitives.size() ? " " + facts.primitives[primitive] : "";
  return {{"depth", depth}, {"text", "p" + std::to_string(primitive) + name}, {"primitive", primitive}};
}

/// Pushes the operands in reverse, so that the first is shown next.
void put_operands(const std::vector<std::uint32_t>& operands, std::size_t depth, std::vector<Waiting>& waiting) {
  std::transform(operands.rbegin(), operands.rend(), std::back_inserter(waiting), [depth](std::uint32_t operand) {
    return Waiting{operand, depth};
  });
}

Json leaf_row(const csg::ActiveNode& leaf, std::size_t depth, const isa::Facts& facts) {
  Json row = primitive_row(depth, leaf.primitive, facts);
  row["complemented"] = leaf.complemented;
  for (const std::uint32_t other : leaf.others) row["others"].push_back(isa::primitive_of(facts, other));
  return row;
}

Json rows_of(const csg::ActiveTree& active, const isa::Facts& facts) {
  Json rows = Json::array();
  std::vector<Waiting> waiting;
  put_operands(active.operands, 0, waiting);
  while (!waiting.empty() && rows.size() < max_rows) {
    const Waiting at = waiting.back();
    waiting.pop_back();
    const csg::ActiveNode& node = active.nodes[at.node];
    if (node.is_leaf) {
      rows.push_back(leaf_row(node, at.depth, facts));
      continue;
    }
    const bool is_union = node.op == csg::PositiveOperator::unite;
    rows.push_back({{"depth", at.depth}, {"text", is_union ? "union" : "intersection"}});
    put_operands(node.children, at.depth + 1, waiting);
  }
  return rows;
}

}  // namespace

Json tree_json(const model::Tree& tree, const isa::Facts& facts) {
  Json rows = Json::array();
  std::vector<Waiting> waiting;
  if (tree.root != model::no_index) waiting.push_back({tree.root, 0});
  while (!waiting.empty() && rows.size() < max_rows) {
    const Waiting at = waiting.back();
    waiting.pop_back();
    const model::Node& node = tree.nodes[at.node];
    if (node.is_leaf || node.of_pieces) {
      rows.push_back(primitive_row(at.depth, first_piece(tree, at.node), facts));
      continue;
    }
    rows.push_back({{"depth", at.depth}, {"text", name_of(node.op)}});
    put_operands(node.children, at.depth + 1, waiting);
  }
  return rows;
}

std::optional<Json> ActiveTrees::of(std::uint32_t piece, std::uint32_t segment) {
  if (!plan_ || segment_ != segment) {
    const view::View view = session::view_of(model_);
    emit::Options options = model_.choices.options;
    if (const auto division = machine_.kind->division(machine_))
      options = emit::options_for_division(*division, options);
    options = emit::with_prices(std::move(options), machine_);
    emit::Plan plan = emit::make_plan(model_.tree, model_.scene, view, {model_.program.segments[segment].region},
                                      {emit::pruning_of(options), options.prices}, {}, options.work);
    plan_ = std::move(plan.segments.front());
    segment_ = segment;
  }
  const auto draws = [&](const emit::PlannedSurface& one) {
    return std::ranges::find(one.set, piece) != one.set.end();
  };
  const auto found = std::ranges::find_if(plan_->surfaces, draws);
  if (found == plan_->surfaces.end()) return std::nullopt;
  return rows_of(found->active, *model_.program.facts);
}

}  // namespace csgsim::viewer
