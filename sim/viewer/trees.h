// Model trees and active trees as rows.
// Used by drawings.h.
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

/// A model's tree, each node before its operands, as an array of `depth` (0 for the root), `text`, and, for a
/// primitive, its number `primitive`. The pieces of one node of the file appear as that node. A large tree is cut after
/// the first few thousand rows.
nlohmann::ordered_json tree_json(const model::Tree& tree, const isa::Facts& facts);

/// Active trees by region, as the host prunes them for a Program.
class ActiveTrees {
 public:
  /// Computes nothing before the first request. The arguments must outlive this object.
  ActiveTrees(const session::CompiledModel& model, const machines::Machine& machine)
      : model_(model), machine_(machine) {}

  /// The active tree of the surface of that piece in the segment, in the form of tree_json. The surface must be inside
  /// every operand at depth 0, or outside if it is `complemented`. Several primitives that are compared as one convex
  /// solid share one row, that of the first. The array is empty if no other primitive removes any of the surface; the
  /// result is std::nullopt if it is not drawn in the segment.
  [[nodiscard]] std::optional<nlohmann::ordered_json> of(std::uint32_t piece, std::uint32_t segment);

 private:
  const session::CompiledModel& model_;
  const machines::Machine& machine_;
  std::optional<emit::SegmentPlan> plan_;  ///< plan of the segment requested last
  std::uint32_t segment_ = 0;
};

}  // namespace csgsim::viewer
