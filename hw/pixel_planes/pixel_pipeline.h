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
#include "hw/pixel_planes/foretold_picture.h"
#include "hw/pixel_planes/pixel_ports.h"
#include "hw/systemc/evaluator_form.h"
#include "hw/systemc/foretold.h"

namespace csgsim::pixel_planes {

/// The datapath between a controller and the memories of the pixels, clocked. Nothing comes into it but what the
/// controller puts on its wires, so that its clocks need not be carried out one by one: whoever looks sees it as the
/// edges so far leave it, and they are carried out only then. By itself it wakes at edges at which something leaves it:
/// the last word of a command has been carried out, or a question is at the pixels.
class PixelPipeline final : public sc_core::sc_module, public PixelWires, public RefreshPort, public EnableLines {
 public:
  sc_core::sc_out<std::uint64_t> retired{"retired"};  ///< commands whose last word has been carried out
  sc_core::sc_out<bool> question{"question"};         ///< the word at the pixels asks for the wired OR

  /// `foretold`, unless null: its pixels alone, side by side, so that (i, 0) is the place of the i-th. What the refresh
  /// port delivers is foretold too.
  PixelPipeline(sc_core::sc_module_name name, const machines::Machine& machine, systemc::EvaluatorForm form,
                const systemc::Foretold* foretold = nullptr);

  void put(std::uint64_t edge, const ControlWord& word, const array::RootBits& bits) override;

  [[nodiscard]] std::span<const std::uint64_t> memory_row(std::uint32_t address, std::uint32_t row) const override;
  [[nodiscard]] std::optional<RefreshStep> refreshed() const override;
  [[nodiscard]] bool any_enabled() const override { return now().pixels().any_enabled(); }
  [[nodiscard]] std::uint64_t count_enabled() const override { return now().pixels().count_enabled(); }
  [[nodiscard]] const array::PixelArray& pixels() const override { return now().pixels(); }

  /// The datapath as the last edge has left it.
  [[nodiscard]] const Datapath& now() const;
  /// Registers of one pixel.
  [[nodiscard]] array::PixelProbe probe(std::uint32_t x, std::uint32_t y) const { return now().probe(x, y); }

  /// Pixels, and the registers before them, as they are when an instruction begins.
  void resume(const array::PixelArray& pixels, const array::StreamBit& tree);
  /// The field that the foretold picture is shown from, if there is one.
  void show(isa::Field field);

 private:
  /// What the wires carry from an edge on.
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
  bool asks_ = false;  ///< the word that was put last
  std::optional<ForetoldPicture> foretold_;
  std::vector<std::uint64_t> due_;  ///< edges at which it wakes, the latest first
  sc_core::sc_event woken_{"woken"};

  // What who looks brings up to date.
  mutable Datapath datapath_;
  mutable std::uint64_t edge_ = 0;    ///< the last that has been carried out
  mutable std::vector<Put> puts_;     ///< that are to come, and before them some that have
  mutable std::size_t next_put_ = 0;  ///< of these
  mutable array::Words row_;          ///< that the refresh port was asked for last
};

}  // namespace csgsim::pixel_planes
