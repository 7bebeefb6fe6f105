#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/machines/timeline.h"
#include "hw/machines/told.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/list_form.h"
#include "hw/multi_processor/prices.h"
#include "hw/multi_processor/regions.h"

/// Clocks of a node, worked out from the figures.
namespace csgsim::multi_processor {

/// Of all of an instruction at one pixel, if no branch is taken, without the loops around it and what begins a row.
std::uint64_t pixel_clocks(const isa::Instruction& instruction, const machines::Machine& machine);

/// Of an instruction of a subsegment at all its pixels, of all nodes together. `met`: as in ListPart.
machines::PixelClocks all_pixel_clocks(const isa::Segment& segment, std::size_t index, const machines::Machine& machine,
                                       const machines::MetPixels* met);

/// What is rendered at once: the list of a subsegment, or as much of it as has come.
struct ListPart {
  std::span<const isa::Instruction> instructions;
  bool begins = true;  ///< nothing of the list has been carried out before
  bool ends = true;    ///< nothing of it comes after
  /// Which pixels of the subsegment a run of its whole list meets; null where no run told: then each instruction takes
  /// as long at each pixel as it may.
  const machines::MetPixels* met = nullptr;
  std::size_t first = 0;  ///< instructions of the list that come before
  ListForm form{};
};

/// What a part takes of a node's clocks, at whichever of the subsegment's pixels; its prices are worked out once.
class RenderingClocks {
 public:
  /// What `part` points to, and the machine, outlive this.
  RenderingClocks(const ListPart& part, const machines::Machine& machine);

  /// At all of the node's pixels: where the list begins, memory is cleared; it is carried out; where it ends, the
  /// colours are stored. Without any instruction they are set to the background. `colour`: of pixel memory; of width 0
  /// where there is none.
  [[nodiscard]] std::uint64_t all(const NodePixels& own, isa::Field colour) const;

  /// For each instruction, the clocks, counted from the rendering's first, in which it is carried out at one of the
  /// node's pixels.
  [[nodiscard]] std::vector<machines::ClockSpan> spans_at(const NodePixels& own, std::uint32_t column,
                                                          std::uint32_t row) const;

 private:
  /// Clocks for each pixel of a plane, modulo 2^64.
  struct Weight {
    std::uint32_t plane = 0;
    std::uint64_t clocks = 0;
  };

  void weigh_planes();
  [[nodiscard]] std::uint64_t of_list(const NodePixels& own) const;

  const ListPart part_;
  const machines::Machine& machine_;
  const Figures& figures_;
  std::vector<InstructionPrices> prices_;
  std::uint64_t chain_ = 0;  ///< of all instructions together; so are these
  std::uint64_t once_ = 0;
  std::uint64_t row_ = 0;
  std::uint64_t pixel_ = 0;      ///< where E is 0, if planes tell where it is not
  std::vector<Weight> weights_;  ///< what that changes
};

/// Of a rendering, the first clocks, in which memory and enable of all of the node's pixels become 0.
std::uint64_t clearing_clocks(const NodePixels& own, const machines::Machine& machine);

/// No node takes more for a list at all pixels of a region; may be rounded.
double most_rendering_clocks(std::span<const isa::Instruction> list, const isa::Region& region, const ListForm& form,
                             const machines::Machine& machine);

}  // namespace csgsim::multi_processor
