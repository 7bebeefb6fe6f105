#pragma once

#include <cstdint>
#include <span>
#include <systemc>
#include <utility>

#include "hw/array/plane.h"

namespace csgsim::pixel_planes {

/// The end of a plane channel that reads: one bit of every pixel.
class PlaneIn : virtual public sc_core::sc_interface {
 public:
  [[nodiscard]] virtual std::span<const std::uint64_t> current() const = 0;
};

/// The end that writes. Fill next(), then pass() it: it is current from the next delta cycle on.
class PlaneOut : virtual public sc_core::sc_interface {
 public:
  [[nodiscard]] virtual std::span<std::uint64_t> next() = 0;
  virtual void pass() = 0;
};

/// Registers of one bit a pixel between two modules. Double buffered: passing a plane on swaps, and copies nothing.
class PlaneChannel final : public sc_core::sc_prim_channel, public PlaneIn, public PlaneOut {
 public:
  PlaneChannel(const char* name, array::PlaneShape shape)
      : sc_core::sc_prim_channel(name), current_(shape.padded_words()), next_(shape.padded_words()) {}

  [[nodiscard]] std::span<const std::uint64_t> current() const override { return current_; }
  [[nodiscard]] std::span<std::uint64_t> next() override { return next_; }
  void pass() override { request_update(); }

 private:
  void update() override { std::swap(current_, next_); }

  array::Words current_;
  array::Words next_;
};

}  // namespace csgsim::pixel_planes
