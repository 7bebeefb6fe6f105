#pragma once

#include <cstdint>
#include <systemc>

#include "hw/array/pixel_array.h"
#include "hw/pixel_planes/control_word.h"
#include "hw/pixel_planes/plane_channel.h"

namespace csgsim::pixel_planes {

/// The refresh port: one memory bit of one row of pixels.
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
class PixelProcessors final : public sc_core::sc_module, public RefreshPort, public EnableLines {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_in<ControlWord> control{"control"};
  sc_core::sc_port<PlaneIn> tree{"tree"};
  sc_core::sc_out<std::uint64_t> retired{"retired"};  ///< commands whose last word has been carried out
  sc_core::sc_export<RefreshPort> refresh{"refresh"};
  sc_core::sc_export<EnableLines> enable_lines{"enable_lines"};

  PixelProcessors(sc_core::sc_module_name name, const isa::ArrayShape& shape, unsigned alu_bits);

  [[nodiscard]] std::span<const std::uint64_t> memory_row(std::uint32_t address, std::uint32_t row) const override {
    return pixels_.memory_row(address, row);
  }
  [[nodiscard]] bool any_enabled() const override { return pixels_.any_enabled(); }
  [[nodiscard]] std::uint64_t count_enabled() const override { return pixels_.count_enabled(); }
  [[nodiscard]] const array::PixelArray& pixels() const override { return pixels_; }

  /// Registers of one pixel.
  [[nodiscard]] array::PixelProbe probe(std::uint32_t x, std::uint32_t y) const {
    return pixels_.probe(x, y, tree->current());
  }

 private:
  void step();

  array::PixelArray pixels_;
  std::uint64_t retired_count_ = 0;
};

}  // namespace csgsim::pixel_planes
