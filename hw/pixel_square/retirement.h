#pragma once

#include <cstdint>
#include <systemc>

#include "hw/array/pixel_array.h"
#include "hw/systemc/listener_guard.h"

namespace csgsim::pixel_square {

/// An instruction whose last step a renderer's pixels have just carried out.
struct Retired {
  std::uint32_t segment = 0;
  std::uint32_t index = 0;           ///< within the segment
  std::uint64_t clocks = 0;          ///< that the renderer counted
  std::uint64_t enabled_pixels = 0;  ///< pixels whose E was 1 when the instruction began
};

/// Sees a run go by: in order within a square, but squares that are drawn in parallel come interleaved. `pixels` hold
/// what the instruction left.
class RunListener {
 public:
  virtual ~RunListener() = default;
  virtual void after_instruction(const Retired& /*retired*/, const array::PixelArray& /*pixels*/) {}
  virtual void after_square(std::uint32_t /*segment*/, const array::PixelArray& /*pixels*/) {}
};

/// Where renderers tell what their pixels have carried out.
class RetirementPort : virtual public sc_core::sc_interface {
 public:
  virtual void carried_out(const Retired& retired, const array::PixelArray& pixels) = 0;
  virtual void drawn(std::uint32_t segment, const array::PixelArray& pixels) = 0;
};

/// Passes that on to the listener of the run. Takes no clock.
class Retirement final : public sc_core::sc_module, public RetirementPort {
 public:
  explicit Retirement(sc_core::sc_module_name name);

  /// The listener has to live until the run is done.
  void begin(RunListener& listener);

  /// Throws what the listener threw, if it did: the machine ran to its end without it.
  void rethrow() { guard_.rethrow(); }

  void carried_out(const Retired& retired, const array::PixelArray& pixels) override;
  void drawn(std::uint32_t segment, const array::PixelArray& pixels) override;

 private:
  RunListener* listener_ = nullptr;
  kernel::ListenerGuard guard_;
};

}  // namespace csgsim::pixel_square
