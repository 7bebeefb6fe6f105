#include "host/commands/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "host/commands/interpreter.h"
#include "host/read/limits.h"
#include "host/read/mesh_pieces.h"
#include "host/read/placement.h"
#include "host/read/source.h"
#include "host/solids/limits.h"
#include "host/swept/mesh.h"
#include "hw/base/error.h"

namespace csgsim::commands {

namespace {

/// Expands the solids to a tree. A solid that several others use is copied for each of them.
class TreeMaker {
 public:
  TreeMaker(read::Source& source, const Model& model) : source_(source), model_(model), pieces_(model.sweeps.size()) {}

  model::Tree make() {
    tree_.file = source_.name();
    waiting_.push_back({model_.drawn, glm::dmat4(1), std::nullopt});
    while (!waiting_.empty()) {
      const Waiting one = waiting_.back();
      waiting_.pop_back();
      source_.work().charge(1, "making the tree of a file of commands");
      if (one.closes) {
        join(*one.closes);
      } else {
        visit(one);
      }
    }
    tree_.root = children_.back();
    return std::move(tree_);
  }

 private:
  struct Waiting {
    std::uint32_t solid = nothing;
    glm::dmat4 matrix{1};
    std::optional<glm::dvec3> colour;
    std::optional<model::Operator> closes{};  ///< if set, this entry is an operator on the last two trees
  };

  void visit(const Waiting& one) {
    const Solid& solid = model_.solids[one.solid];
    if (const auto* const shape = std::get_if<model::Shape>(&solid.made)) {
      add_leaf(*shape, one, solid);
    } else if (const auto* const swept = std::get_if<Swept>(&solid.made)) {
      add_sweep(swept->number, one, solid);
    } else if (const auto* const moved = std::get_if<MovedSolid>(&solid.made)) {
      waiting_.push_back({moved->solid, one.matrix * moved->matrix, one.colour});
    } else if (const auto* const coloured = std::get_if<ColouredSolid>(&solid.made)) {
      waiting_.push_back({coloured->solid, one.matrix, one.colour ? one.colour : coloured->colour});
    } else if (const auto* const combined = std::get_if<CombinedSolid>(&solid.made)) {
      waiting_.push_back({nothing, glm::dmat4(1), std::nullopt, combined->op});
      waiting_.push_back({combined->right, one.matrix, one.colour});
      waiting_.push_back({combined->left, one.matrix, one.colour});
    }
  }

  [[noreturn]] void fail(const model::Location& at, std::string_view message) const {
    throw InputError(fmt::format("{}:{}:{}: {}", source_.name(), at.line, at.column, message));
  }

  model::Primitive& add_leaf(model::Shape shape, const Waiting& one, const Solid& solid) {
    if (tree_.primitives.size() >= read::max_primitives)
      fail(solid.location, fmt::format("more than {} solids; split the model", read::max_primitives));
    if (read::is_degenerate(one.matrix))
      fail(solid.location, "moving and scaling exceed the range of numbers; use smaller numbers");
    children_.push_back(model::add_leaf(tree_, {}));
    model::Primitive& primitive = tree_.primitives.back();
    primitive.shape = std::move(shape);
    primitive.transform = one.matrix;
    primitive.colour = one.colour;
    primitive.location = solid.location;
    return primitive;
  }

  void add_sweep(std::uint32_t number, const Waiting& one, const Solid& solid) {
    const std::vector<model::Polyhedron>& pieces = sweep_pieces(number, solid);
    const std::size_t first = children_.size();
    for (const model::Polyhedron& piece : pieces) {
      model::Primitive& primitive = add_leaf(piece, one, solid);
      primitive.node = "sweep";
      primitive.continues = children_.size() > first + 1;
    }
    if (pieces.size() < 2) return;
    model::Node& node = tree_.nodes.emplace_back();
    node.of_pieces = true;
    node.children.assign(children_.begin() + static_cast<std::ptrdiff_t>(first), children_.end());
    children_.resize(first);
    children_.push_back(static_cast<std::uint32_t>(tree_.nodes.size() - 1));
  }

  const std::vector<model::Polyhedron>& sweep_pieces(std::uint32_t number, const Solid& solid) {
    std::optional<std::vector<model::Polyhedron>>& pieces = pieces_[number];
    if (pieces) return *pieces;
    const SweptSolid& sweep = model_.sweeps[number];
    swept::Accuracy accuracy;
    accuracy.tolerance = sweep.tolerance;
    accuracy.work = source_.work();
    read::MeshPieces made;
    try {
      const swept::SweptSolid meshed = swept::make_swept_solid(sweep.sweep, accuracy);
      made = read::pieces_of(meshed.mesh, solids::double_precision_tolerance, {}, source_.work());
    } catch (const InputError& error) {
      fail(solid.location, fmt::format("sweep: {}", error.what()));
    }
    if (made.defect)
      fail(solid.location, fmt::format("sweep: its surface does not bound a solid: {}", made.defect->what));
    if (made.pieces.empty())
      fail(solid.location, "sweep: the solid has no volume; move the points of its contour apart");
    for (const read::Remark& remark : made.remarks)
      source_.print_message(sweep.offset, fmt::format("sweep: {}", remark.what));
    pieces = std::move(made.pieces);
    return *pieces;
  }

  void join(model::Operator op) {
    const std::uint32_t right = children_.back();
    children_.pop_back();
    model::Node& node = tree_.nodes.emplace_back();
    node.op = op;
    node.children = {children_.back(), right};
    children_.back() = static_cast<std::uint32_t>(tree_.nodes.size() - 1);
  }

  read::Source& source_;
  const Model& model_;
  model::Tree tree_;
  std::vector<Waiting> waiting_;
  std::vector<std::uint32_t> children_;  ///< trees that are not yet part of another tree
  std::vector<std::optional<std::vector<model::Polyhedron>>> pieces_;
};

}  // namespace

model::Tree read_text(std::string_view text, std::string_view name, const read::Options& options) {
  read::Source source(text, name, options);
  source.set_work_counter(options.work);
  const Model model = interpret(source);
  if (model.drawn == nothing)
    throw InputError(fmt::format("{}: the file defines no solid; add a line such as `Object = block 1 2 3`", name));
  return TreeMaker(source, model).make();
}

std::vector<NamedSurface> read_surfaces(std::string_view text, std::string_view name) {
  read::Source source(text, name);
  Model model = interpret(source);
  std::vector<std::pair<std::uint32_t, NamedSurface>> found;
  for (SweptSolid& one : model.sweeps)
    found.push_back({one.offset, {std::string(one.name), true, std::move(one.sweep), {}, one.tolerance, {}}});
  for (Patch& one : model.patches)
    found.push_back({one.offset, {std::string(one.name), false, {}, std::move(one.net), one.tolerance, {}}});
  std::ranges::sort(found, {}, [](const auto& one) { return one.first; });
  std::vector<NamedSurface> surfaces;
  for (auto& one : found) {
    one.second.location = source.locate(one.first);
    std::erase_if(surfaces, [&](const NamedSurface& other) { return other.name == one.second.name; });
    surfaces.push_back(std::move(one.second));
  }
  return surfaces;
}

}  // namespace csgsim::commands
