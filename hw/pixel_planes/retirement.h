#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <systemc>
#include <vector>

#include "hw/isa/program.h"
#include "hw/pixel_planes/pixel_processors.h"
#include "hw/pixel_planes/words.h"
#include "hw/systemc/listener_guard.h"

namespace csgsim::pixel_planes {

/// An instruction whose last step the pixels have just carried out.
struct Retired {
  std::uint32_t segment = 0;
  std::uint32_t index = 0;           ///< within the segment
  std::uint64_t clocks = 0;          ///< that the controller counted
  std::uint64_t enabled_pixels = 0;  ///< pixels whose E was 1 when the instruction began
  std::uint64_t skipped = 0;         ///< instructions after it that are not carried out
};

/// Sees a run go by. Memory and enable hold what the instruction left.
class RunListener {
 public:
  virtual ~RunListener() = default;
  virtual void after_instruction(const Retired& /*retired*/) {}
  virtual void after_segment(std::uint32_t /*segment*/) {}
};

/// Tells the listener of each instruction when it has been carried out, and resets the pixels between two segments.
/// Takes no clock: it acts between the edge that carries out an instruction and the next.
class Retirement final : public sc_core::sc_module {
 public:
  sc_core::sc_in<std::uint64_t> retired{"retired"};
  sc_core::sc_fifo_in<Account> accounts{"accounts"};
  sc_core::sc_port<EnableLines> enable{"enable"};

  explicit Retirement(sc_core::sc_module_name name);

  /// Resets the pixels for the first segment. The segments and the listener have to live until the program is done.
  void begin(std::span<const isa::Segment> segments, RunListener& listener);

  /// Answers to the host's questions, in order, since begin.
  [[nodiscard]] const std::vector<bool>& answers() const { return answers_; }

  /// Instructions that were not carried out, since begin.
  [[nodiscard]] std::uint64_t skipped() const { return skipped_; }

  /// Throws what the listener threw, if it did: the machine ran to its end without it.
  void rethrow() { guard_.rethrow(); }

 private:
  void retire();
  void tell(const Account& account);
  void finish_segments();

  std::span<const isa::Segment> segments_;
  RunListener* listener_ = nullptr;
  std::uint32_t segment_ = 0;
  std::uint32_t index_ = 0;
  std::uint64_t enabled_ = 0;
  std::uint64_t skipped_ = 0;
  std::vector<bool> answers_;
  kernel::ListenerGuard guard_;
};

}  // namespace csgsim::pixel_planes
