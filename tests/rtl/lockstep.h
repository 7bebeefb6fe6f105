#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <systemc>
#include <vector>

#include "hw/isa/program.h"
#include "hw/pixel_planes/pixel_planes.h"
#include "tests/rtl/host_link.h"
#include "tests/rtl/rtl_machine.h"

namespace csgsim::rtl {

/// Runs Programs on the machine in SystemC and on that in Verilog, each with a host's link of its own, and compares the
/// registers and the memory of every pixel in every clock. One a process, as SystemC elaborates once.
class Lockstep final : public sc_core::sc_module {
 public:
  explicit Lockstep(const machines::Machine& machine);

  /// Returns where the two differ first, or nothing if they agree to the end, in the answers and in the clocks too.
  /// With the planted fault of that number in the Verilog; 0: none.
  std::string run(const isa::Program& program, std::uint8_t fault = 0);

  [[nodiscard]] std::uint64_t clocks_compared() const { return clocks_compared_; }

 private:
  void watch();
  void look();
  void edge();
  void compare();
  void compare_plane(const char* what, const Vector& expected, const Vector& actual, std::string_view which = {});
  void clear();
  [[nodiscard]] std::uint64_t edges() const;

  const machines::Machine figures_;
  pixel_planes::PixelPlanes machine_;
  std::unique_ptr<Machine> rtl_;
  HostLink host_;
  std::uint8_t fault_ = 0;
  bool comparing_ = false;
  std::uint64_t begin_ = 0;  ///< edge at which the frame begins
  std::uint64_t seen_ = 0;   ///< edges that the Verilog has had
  std::uint64_t clocks_compared_ = 0;
  std::uint32_t frames_done_ = 0;
  std::uint32_t clocks_ = 0;  ///< that the Verilog counted for the frame
  std::vector<bool> answers_;
  std::string difference_;
  Vector plane_;
};

}  // namespace csgsim::rtl
