#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "host/emit/plan.h"
#include "host/model/tree.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/model_request.h"

namespace csgsim::viewer {

/// A model's tree, each node before its operands: an array of `depth`, 0 for the root, `text`, what the node is, and of
/// a primitive its number, `primitive`. Pieces of one node of the file are that node. Of a large tree, the first few
/// thousand.
nlohmann::ordered_json tree_of(const model::Tree& tree, const isa::Facts& facts);

/// Active trees, region by region, as the host prunes them for a Program.
class ActiveTrees {
 public:
  /// Nothing is done before one is asked for. The arguments have to outlive it.
  ActiveTrees(const session::CompiledModel& model, const session::ModelRequest& options,
              const machines::Machine& machine)
      : model_(model), options_(options), machine_(machine) {}

  /// What the surface of that piece is compared with in the segment, in the form of tree_of: at depth 0 operands, all
  /// of which it has to be in, or, of a primitive that is `complemented`, outside. Several primitives that are compared
  /// as one convex solid are one row, of the first. Empty where the surface is seen wherever it is drawn; none if it is
  /// not drawn there.
  [[nodiscard]] std::optional<nlohmann::ordered_json> of(std::uint32_t piece, std::uint32_t segment);

 private:
  const session::CompiledModel& model_;
  const session::ModelRequest& options_;
  const machines::Machine& machine_;
  std::optional<emit::SegmentPlan> plan_;  ///< of the last segment
  std::uint32_t segment_ = 0;
};

}  // namespace csgsim::viewer
