#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/machines/run_outcome.h"
#include "hw/machines/timeline.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/list_form.h"
#include "hw/multi_processor/prices.h"
#include "hw/multi_processor/regions.h"

/// Clocks of a node, computed from the machine's parameters.
namespace csgsim::multi_processor {

/// Clocks of a whole instruction at one pixel if no branch is taken, without the surrounding loops and the work at the
/// start of a row.
std::uint64_t pixel_clocks(const isa::Instruction& instruction, const machines::Machine& machine);

/// Clocks that an instruction takes at all pixels of its subsegment, summed over the nodes. `pixel_activity`: measured
/// activity, or null without a run.
machines::PixelClocks subsegment_pixel_clocks(const isa::Segment& segment, std::size_t index,
                                              const machines::Machine& machine,
                                              const machines::PixelActivity* pixel_activity);

/// The list of a subsegment, or the part of it that is rendered at once.
struct ListPart {
  std::span<const isa::Instruction> instructions;
  bool begins = true;  ///< no earlier part of the list has been executed
  bool ends = true;    ///< no part of the list follows
  /// Measured activity of the subsegment's pixels at each instruction of the whole list; null without a run, in which
  /// case each instruction is charged its maximum at each pixel.
  const machines::PixelActivity* pixel_activity = nullptr;
  std::size_t first = 0;  ///< number of instructions of the list before this part
  ListForm form{};
};

/// Clocks that a node takes for a list part, for any set of the subsegment's pixels. The constructor computes the costs
/// of the instructions.
class RenderingClocks {
 public:
  /// The machine, and the data that `part` refers to, must outlive this object.
  RenderingClocks(const ListPart& part, const machines::Machine& machine);

  /// Clocks at all of the node's pixels: clearing of memory if the part begins the list, execution, and storing of the
  /// colours if the part ends the list. A list without instructions stores the background. `colour`: field of pixel
  /// memory; width 0 if there is none.
  [[nodiscard]] std::uint64_t all(const NodePixels& node_pixels, isa::Field colour) const;

  /// For each instruction, the clocks, counted from the start of the rendering, in which the node executes it at its
  /// pixel in the given column and row of `node_pixels`.
  [[nodiscard]] std::vector<machines::ClockSpan> spans_at(const NodePixels& node_pixels, std::uint32_t column,
                                                          std::uint32_t row) const;

 private:
  /// Clocks for each pixel that is set in a plane, modulo 2^64.
  struct Weight {
    std::uint32_t plane = 0;
    std::uint64_t clocks = 0;
  };

  void compute_weights();
  [[nodiscard]] std::uint64_t list_clocks(const NodePixels& node_pixels) const;

  const ListPart part_;
  const machines::Machine& machine_;
  const Figures& figures_;
  std::vector<InstructionCosts> costs_;
  std::uint64_t chain_ = 0;  ///< total of all instructions, like the following members
  std::uint64_t once_ = 0;
  std::uint64_t row_ = 0;
  std::uint64_t pixel_ = 0;  ///< clocks of a pixel with E = 0 if planes give the enabled pixels, otherwise the maximum
  std::vector<Weight> weights_;  ///< corrections for the pixels of planes
};

/// Clocks at the start of a rendering in which the node clears memory and enable of all its pixels.
std::uint64_t clearing_clocks(const NodePixels& node_pixels, const machines::Machine& machine);

/// Upper bound of the clocks that any node takes for a list at all pixels of a region; may be rounded.
double max_rendering_clocks(std::span<const isa::Instruction> list, const isa::Region& region, const ListForm& form,
                            const machines::Machine& machine);

}  // namespace csgsim::multi_processor
