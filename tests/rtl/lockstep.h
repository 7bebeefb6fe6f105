#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <systemc>
#include <vector>

#include "hw/isa/program.h"
#include "hw/pixel_planes/pixel_planes.h"
#include "tests/rtl/host_link.h"
#include "tests/rtl/rtl_machine.h"
#include "tests/rtl/screen.h"

namespace csgsim::rtl {

/// Runs Programs on the machine in SystemC and on that in Verilog, each with a separate host link, and compares the
/// registers and the memory of every pixel in every clock. One per process, as SystemC elaborates once.
class Lockstep final : public sc_core::sc_module {
 public:
  explicit Lockstep(const machines::Machine& machine);

  /// Draws the Programs one after the other. Returns the first difference, or an empty text if all is equal including
  /// answers, clocks, activities, intervals and pictures. `fault` is the number of the planted fault in the Verilog; 0:
  /// none.
  std::string run(std::span<const isa::Program> programs, std::uint8_t fault = 0);

  [[nodiscard]] std::uint64_t clocks_compared() const { return clocks_compared_; }

 private:
  /// Results of the Verilog for a frame.
  struct Frame {
    std::uint64_t begun = 0;   ///< edge at its start
    std::uint64_t shown = 0;   ///< edge at its display
    std::uint32_t clocks = 0;  ///< clocks until it was drawn
    std::vector<bool> answers{};
    std::array<std::uint32_t, counted.size()> counts{};
    std::vector<std::uint32_t> drawn{};    ///< colours in the SystemC machine's memory at that time
    std::vector<std::uint32_t> picture{};  ///< scanned-out picture
  };

  void watch();
  void look();
  void edge();
  void next_frame();
  void finish_frame();
  void compare();
  void compare_frames(const std::vector<systemc::RunReport>& reports);
  void compare_frame(std::size_t number, const systemc::RunReport& report);
  void report_difference(std::string difference);
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
  std::uint64_t seen_ = 0;   ///< edges received by the Verilog
  std::uint64_t clocks_compared_ = 0;
  std::span<const isa::Program> programs_;
  std::vector<Frame> frames_;    ///< frames begun by the Verilog
  std::size_t drawn_ = 0;        ///< number of drawn frames
  std::size_t scanned_out_ = 0;  ///< number of scanned-out frames
  bool waiting_ = false;         ///< whether a frame is in the host's memory
  Screen screen_;
  std::string difference_;
  Vector plane_;
};

}  // namespace csgsim::rtl
