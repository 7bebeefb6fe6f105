// SystemC module of the datapath, simulated on demand.
// Used by hw/pixel_planes and hw/pixel_square.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <systemc>
#include <vector>

#include "hw/array/linear_evaluator.h"
#include "hw/array/pixel_array.h"
#include "hw/array/stepped_evaluator.h"
#include "hw/machines/machine.h"
#include "hw/pixel_planes/control_word.h"
#include "hw/pixel_planes/datapath.h"
#include "hw/pixel_planes/earlier_picture.h"
#include "hw/pixel_planes/pixel_ports.h"
#include "hw/systemc/earlier_run.h"
#include "hw/systemc/evaluator_form.h"

namespace csgsim::pixel_planes {

/// The clocked datapath from a controller to the pixel memories. Its only input is the controller's wires, so its
/// clocks are deferred: reads force pending edges to complete. The module wakes only at edges with an output: when the
/// last word of a command has been executed, or when the word of a global-OR test is at the pixels.
class PixelPipeline final : public sc_core::sc_module, public PixelWires, public RefreshPort, public EnableLines {
 public:
  sc_core::sc_out<std::uint64_t> retired{"retired"};  ///< number of commands whose last word has been executed
  /// Whether the word at the pixels belongs to a global-OR test.
  sc_core::sc_out<bool> question{"question"};

  /// If `earlier` is not null, only the pixels of that run are simulated, side by side: pixel i is at (i, 0). The
  /// refresh port then delivers the picture of that run.
  PixelPipeline(sc_core::sc_module_name name, const machines::Machine& machine, systemc::EvaluatorForm form,
                const systemc::EarlierRun* earlier = nullptr);

  void put(std::uint64_t edge, const ControlWord& word, const array::RootBits& bits) override;

  [[nodiscard]] std::span<const std::uint64_t> memory_row(std::uint32_t address, std::uint32_t row) const override;
  [[nodiscard]] std::optional<RefreshStep> refreshed() const override;
  [[nodiscard]] bool any_enabled() const override { return now().pixels().any_enabled(); }
  [[nodiscard]] std::uint64_t count_enabled() const override { return now().pixels().count_enabled(); }
  [[nodiscard]] const array::PixelArray& pixels() const override { return now().pixels(); }

  /// The datapath after the last edge.
  [[nodiscard]] const Datapath& now() const;
  /// Registers of one pixel.
  [[nodiscard]] array::PixelProbe probe(std::uint32_t x, std::uint32_t y) const { return now().probe(x, y); }

  /// Sets the pixels and the registers before them to their state at the beginning of an instruction.
  void resume(const array::PixelArray& pixels, const array::StreamBit& tree);
  /// Sets the field from which the picture of the earlier run is displayed; no effect without an earlier run.
  void show(isa::Field field);

 private:
  /// Values on the wires from `edge` on.
  struct Put {
    std::uint64_t edge = 0;
    ControlWord word;
    array::RootBits bits;
  };

  void wake();
  void wake_at(std::uint64_t edge);
  void schedule();
  void take_puts() const;

  const sc_core::sc_time period_;
  const unsigned latency_;
  bool requests_or_ = false;  ///< whether the last control word requests the global OR
  std::optional<EarlierPicture> earlier_picture_;
  std::vector<std::uint64_t> due_;  ///< edges at which to wake, the latest first
  sc_core::sc_event woken_{"woken"};

  // Deferred state, brought up to date by reads.
  mutable Datapath datapath_;
  mutable std::uint64_t edge_ = 0;    ///< last executed edge
  mutable std::vector<Put> puts_;     ///< pending values, preceded by values already applied
  mutable std::size_t next_put_ = 0;  ///< index of the first pending value
  mutable array::Words row_;          ///< row last read through the refresh port
};

}  // namespace csgsim::pixel_planes
