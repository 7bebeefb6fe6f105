#pragma once

#include <cstdint>

#include "host/emit/evaluation.h"

namespace csgsim::emit {

/// What a strategy does, `extern const StrategyRow NAME_strategy` of its file; its name is in CSGSIM_STRATEGIES.
struct StrategyRow {
  /// Memory bits for working out one active tree.
  ClassificationBits (*bits)(const csg::ActiveTree& active, const Options& options);
  /// A null pointer where `draw` draws each surface that has operands.
  decltype(Classification::classify) classify = nullptr;
  /// Draws a primitive's visible surface in its own way, and returns true; or returns false, and it is drawn by
  /// `surface` and `classify`.
  bool (*draw)(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides) = nullptr;
  /// Draws the surface into Z1; emit_surface, unless the strategy has its own.
  Surface (*surface)(const Context& context, Broadcast& out, const PlannedSurface& planned,
                     const Sides& sides) = emit_surface;
  /// Products that an active tree with operands is multiplied out to.
  std::uint64_t (*products)(const csg::ActiveTree& active, const Options& options) = nullptr;
  /// Bits in which depths are kept throughout a segment.
  unsigned (*stored_bits)(const SegmentPlan& segment, const view::View& view) = nullptr;
  bool has_stack_bits = false;  ///< Options::stack_bits counts
  bool takes_sets = true;       ///< primitives may be drawn as one (csg::Pruning::sets)
  bool is_tried = true;         ///< Strategy::automatic may choose it
  bool is_usual = true;         ///< one of usual_strategies
};

/// Throws std::logic_error for Strategy::automatic.
const StrategyRow& row_of(Strategy strategy);

/// The prunings that are done.
csg::Pruning pruning_of(const Options& options);

}  // namespace csgsim::emit
