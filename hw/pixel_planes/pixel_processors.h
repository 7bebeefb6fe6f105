#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <systemc>
#include <vector>

#include "hw/array/pixel_array.h"
#include "hw/pixel_planes/control_word.h"
#include "hw/systemc/clocked_module.h"
#include "hw/systemc/foretold.h"

namespace csgsim::pixel_planes {

/// The refresh port: one memory bit of one row of pixels, valid until the next is asked for.
class RefreshPort : virtual public sc_core::sc_interface {
 public:
  [[nodiscard]] virtual std::span<const std::uint64_t> memory_row(std::uint32_t address, std::uint32_t row) const = 0;
};

/// The enable bits, and the pixels for who watches the run.
class EnableLines : virtual public sc_core::sc_interface {
 public:
  [[nodiscard]] virtual bool any_enabled() const = 0;
  [[nodiscard]] virtual std::uint64_t count_enabled() const = 0;

  [[nodiscard]] virtual const array::PixelArray& pixels() const = 0;
};

/// The pixel processors and memories, which carry out one control word a clock.
class PixelProcessors final : public systemc::ClockedModule, public RefreshPort, public EnableLines {
 public:
  sc_core::sc_in<ControlWord> control{"control"};
  sc_core::sc_in<TreeWord> tree{"tree"};              ///< at the pixels
  sc_core::sc_out<std::uint64_t> retired{"retired"};  ///< commands whose last word has been carried out
  sc_core::sc_export<RefreshPort> refresh{"refresh"};
  sc_core::sc_export<EnableLines> enable_lines{"enable_lines"};

  /// `foretold`, unless null: its pixels alone, side by side, so that (i, 0) is the place of the i-th. What the refresh
  /// port delivers is foretold too.
  PixelProcessors(sc_core::sc_module_name name, const isa::ArrayShape& shape, unsigned alu_bits,
                  const systemc::Foretold* foretold = nullptr);

  [[nodiscard]] std::span<const std::uint64_t> memory_row(std::uint32_t address, std::uint32_t row) const override {
    if (foretold_) return foretold_->row(address, row);
    pixels_.read_row(address, row, row_);
    return row_;
  }
  [[nodiscard]] bool any_enabled() const override { return pixels_.any_enabled(); }
  [[nodiscard]] std::uint64_t count_enabled() const override { return pixels_.count_enabled(); }
  [[nodiscard]] const array::PixelArray& pixels() const override { return pixels_; }

  /// The control word before the one on the wires.
  [[nodiscard]] const ControlWord& carried_out() const { return carried_out_; }

  /// The pixels as they are when an instruction begins, and the field that the foretold picture is shown from.
  void resume(const array::PixelArray& pixels, isa::Field shown);

  /// Registers of one pixel.
  [[nodiscard]] array::PixelProbe probe(std::uint32_t x, std::uint32_t y) const;

 private:
  /// The picture that another run has left.
  class Picture {
   public:
    Picture(array::PlaneShape shape, std::span<const std::uint32_t> colours) : shape_(shape), colours_(colours) {}

    void show(isa::Field field) { field_ = field; }
    [[nodiscard]] std::span<const std::uint64_t> row(std::uint32_t address, std::uint32_t row) const;

   private:
    array::PlaneShape shape_;
    std::span<const std::uint32_t> colours_;
    isa::Field field_;
    mutable array::Words row_;  ///< that was asked for last
  };

  void on_clock() override;
  void step(const array::ArrayStep& step);

  array::PixelArray pixels_;
  mutable array::Words row_;  ///< that the refresh port was asked for last
  std::optional<Picture> foretold_;
  ControlWord carried_out_;
  std::uint64_t retired_count_ = 0;
};

}  // namespace csgsim::pixel_planes
