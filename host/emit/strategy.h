// The row that registers a classification strategy.
// Used by the strategies, evaluation.cpp, sim/studies and sim/viewer.
#pragma once

#include <cstdint>

#include "host/emit/evaluation.h"

namespace csgsim::emit {

/// A strategy. Each file defines `extern const StrategyRow NAME_strategy`; CSGSIM_STRATEGIES lists the names.
struct StrategyRow {
  /// Memory bits for evaluating one active tree.
  ClassificationBits (*bits)(const csg::ActiveTree& active, const Options& options);
  /// Null if `draw` draws every surface that has operands.
  decltype(Classification::classify) classify = nullptr;
  /// Draws a primitive's visible surface in a special way and returns true; or returns false, and the surface is drawn
  /// with `surface` and `classify`.
  bool (*draw)(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides) = nullptr;
  /// Draws the surface into Z1; emit_surface by default.
  Surface (*surface)(const Context& context, Broadcast& out, const PlannedSurface& planned,
                     const Sides& sides) = emit_surface;
  /// Number of products that an active tree with operands expands to.
  std::uint64_t (*products)(const csg::ActiveTree& active, const Options& options) = nullptr;
  /// Bits for depths that are stored throughout a segment.
  unsigned (*stored_bits)(const SegmentPlan& segment, const view::View& view) = nullptr;
  bool has_stack_bits = false;  ///< whether it depends on Options::stack_bits
  bool takes_sets = true;       ///< whether several primitives can be drawn as one (csg::Pruning::sets)
  bool is_tried = true;         ///< whether Strategy::automatic may choose it
  bool is_usual = true;         ///< whether it is one of default_strategies()
};

/// Throws std::logic_error for Strategy::automatic.
const StrategyRow& row_of(Strategy strategy);

/// The prunings of the options that apply to the strategy.
csg::Pruning pruning_of(const Options& options);

}  // namespace csgsim::emit
