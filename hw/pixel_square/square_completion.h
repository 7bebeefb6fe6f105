#pragma once

#include <cstdint>
#include <optional>
#include <systemc>

#include "hw/pixel_planes/pixel_ports.h"
#include "hw/pixel_square/command_account.h"
#include "hw/systemc/retirement.h"
#include "hw/systemc/segment_names.h"

namespace csgsim::pixel_square {

/// Tells who watches the run what a renderer's pixels have carried out, with what its controller counted for it. No
/// part of the machine, and takes no clock: it acts between the edge that carries out a command and the next.
class SquareCompletion final : public sc_core::sc_module {
 public:
  sc_core::sc_in<std::uint64_t> retired{"retired"};
  sc_core::sc_fifo_in<CommandAccount> accounts{"accounts"};
  sc_core::sc_port<pixel_planes::EnableLines> enable{"enable"};
  sc_core::sc_port<systemc::RetirementPort> retirement{"retirement"};

  explicit SquareCompletion(sc_core::sc_module_name name);

  /// The names have to live until the frame is drawn.
  void begin(const systemc::SegmentNames& names) {
    names_ = &names;
    segment_.reset();
    skipped_ = 0;
  }

  /// Instructions that were not carried out, since begin.
  [[nodiscard]] std::uint64_t skipped() const { return skipped_; }

  /// For waves: which segment the pixels draw, or have drawn last; none before the first.
  [[nodiscard]] std::optional<std::uint32_t> segment() const { return segment_; }

 private:
  void complete();
  void tell(const CommandAccount& account);

  const systemc::SegmentNames* names_ = nullptr;
  std::optional<std::uint32_t> segment_;  ///< that the square is
  std::uint32_t index_ = 0;               ///< of the instruction that comes next
  std::uint64_t enabled_ = 0;
  std::uint64_t told_ = 0;  ///< commands, since the machine was built
  std::uint64_t skipped_ = 0;
};

}  // namespace csgsim::pixel_square
