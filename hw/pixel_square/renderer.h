#pragma once

#include <cstdint>
#include <systemc>

#include "hw/isa/link_word.h"
#include "hw/machines/machine.h"
#include "hw/pixel_planes/global_or.h"
#include "hw/pixel_planes/pixel_pipeline.h"
#include "hw/pixel_square/account.h"
#include "hw/pixel_square/output_port.h"
#include "hw/pixel_square/port_word.h"
#include "hw/pixel_square/square_completion.h"
#include "hw/pixel_square/square_controller.h"
#include "hw/systemc/evaluator_form.h"
#include "hw/systemc/retirement.h"
#include "hw/systemc/segment_names.h"

namespace csgsim::pixel_square {

/// References for waves, valid as long as the renderer.
struct RendererParts {
  const SquareController& controller;
  const pixel_planes::PixelPipeline& pipeline;
  const SquareCompletion& completion;
  array::TreeForm trees;
};

/// Draws one square after another, with the modules of Pixel-planes between a controller and its output port:
///
///     link ─▶ controller ─┬─▶ pixel pipeline ─▶ output port ─▶ colours
///               ▲         │    │                 ▲     │
///               ├─────────┼─ global OR           │     │
///               │         └─▶ a square begins to move  │
///               └──────────── squares that have left ──┘
///
/// A control word put on the wires at an edge reaches the pixels after one edge plus one edge per level of the
/// multiplier trees.
class Renderer final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_fifo_in<isa::LinkWord> link{"link"};
  sc_core::sc_fifo_out<PortWord> colours{"colours"};
  /// Number of squares that have left, or are complete in the output buffer.
  sc_core::sc_out<std::uint64_t> finished{"finished"};
  sc_core::sc_port<systemc::RetirementPort> retirement{"retirement"};

  Renderer(sc_core::sc_module_name name, const machines::Machine& machine,
           systemc::EvaluatorForm form = systemc::EvaluatorForm::computed);

  /// `colour`: field of a pixel's memory that goes to the frame buffer. The names must outlive the frame.
  void begin(isa::Field colour, const systemc::SegmentNames& names);

  /// Clocks by activity of the pixel processors in a frame of `clocks` clocks. Clocks after the last square are `done`.
  [[nodiscard]] SquareClocks account(std::uint64_t clocks) const { return controller_.account(clocks); }
  [[nodiscard]] std::uint64_t squares() const { return controller_.squares(); }
  /// Number of skipped instructions in the frame.
  [[nodiscard]] std::uint64_t skipped() const { return completion_.skipped(); }
  [[nodiscard]] const array::PixelArray& pixels() const { return pipeline_.pixels(); }

  [[nodiscard]] RendererParts parts() const { return {controller_, pipeline_, completion_, trees_}; }

 private:
  const array::TreeForm trees_;
  sc_core::sc_signal<bool> question_{"question"};
  sc_core::sc_signal<pixel_planes::Answer> answer_{"answer"};
  sc_core::sc_signal<std::uint64_t> retired_{"retired"};
  sc_core::sc_fifo<CommandAccount> accounts_;
  sc_core::sc_signal<std::uint64_t> begun_{"begun"};
  sc_core::sc_signal<std::uint64_t> header_{"header"};
  sc_core::sc_signal<bool> moving_{"moving"};
  sc_core::sc_signal<std::uint64_t> left_{"left"};

  SquareController controller_;
  pixel_planes::PixelPipeline pipeline_;
  pixel_planes::GlobalOr global_or_;
  OutputPort output_;
  SquareCompletion completion_{"completion"};
};

}  // namespace csgsim::pixel_square
