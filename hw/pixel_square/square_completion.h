#pragma once

#include <cstdint>
#include <optional>
#include <systemc>

#include "hw/pixel_planes/pixel_ports.h"
#include "hw/pixel_square/command_account.h"
#include "hw/systemc/retirement.h"
#include "hw/systemc/segment_names.h"

namespace csgsim::pixel_square {

/// Reports the commands that a renderer's pixels have completed, with the controller's counts, to the run listener.
/// This module models no hardware: it takes no clock, and acts between the edge that completes a command and the next
/// edge.
class SquareCompletion final : public sc_core::sc_module {
 public:
  sc_core::sc_in<std::uint64_t> retired{"retired"};
  sc_core::sc_fifo_in<CommandAccount> accounts{"accounts"};
  sc_core::sc_port<pixel_planes::EnableLines> enable{"enable"};
  sc_core::sc_port<systemc::RetirementPort> retirement{"retirement"};

  explicit SquareCompletion(sc_core::sc_module_name name);

  /// The names must outlive the frame.
  void begin(const systemc::SegmentNames& names) {
    names_ = &names;
    segment_.reset();
    skipped_ = 0;
  }

  /// Number of skipped instructions since begin().
  [[nodiscard]] std::uint64_t skipped() const { return skipped_; }

  /// For waves: the segment that the pixels draw, or drew last; empty before the first.
  [[nodiscard]] std::optional<std::uint32_t> segment() const { return segment_; }

 private:
  void complete();
  void report(const CommandAccount& account);

  const systemc::SegmentNames* names_ = nullptr;
  std::optional<std::uint32_t> segment_;  ///< segment of the current square
  std::uint32_t index_ = 0;               ///< index of the next instruction
  std::uint64_t enabled_ = 0;
  std::uint64_t reported_ = 0;  ///< number of commands reported since the machine was built
  std::uint64_t skipped_ = 0;
};

}  // namespace csgsim::pixel_square
