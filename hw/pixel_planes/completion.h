#pragma once

#include <cstdint>
#include <span>
#include <systemc>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/timing.h"
#include "hw/pixel_planes/control_word.h"
#include "hw/pixel_planes/pixel_ports.h"
#include "hw/systemc/retirement.h"

namespace csgsim::pixel_planes {

/// Tells who watches the run what the pixels have carried out, with what the controller counted for it. No part of the
/// machine, and takes no clock: it acts between the edge that carries out an instruction and the next. It knows the
/// Program, so that it can say of which segment an instruction is.
class Completion final : public sc_core::sc_module {
 public:
  sc_core::sc_in<std::uint64_t> retired{"retired"};
  sc_core::sc_fifo_in<Account> accounts{"accounts"};
  sc_core::sc_port<EnableLines> enable{"enable"};
  sc_core::sc_port<systemc::RetirementPort> retirement{"retirement"};

  explicit Completion(sc_core::sc_module_name name);

  /// The segments have to live until the program is done.
  void begin(std::span<const isa::Segment> segments);

  /// After begin: the next instruction to be carried out is that one.
  void resume(std::uint32_t segment, std::uint32_t index);

  /// Answers to the host's questions, in order, since begin.
  [[nodiscard]] const std::vector<bool>& answers() const { return answers_; }

  /// Instructions that were not carried out, since begin, and the questions before them.
  [[nodiscard]] std::uint64_t skipped() const { return skipped_; }
  [[nodiscard]] const std::vector<machines::Skip>& skips() const { return skips_; }

 private:
  void complete();
  void tell(const Account& account);
  void finish_segment();

  std::span<const isa::Segment> segments_;
  std::uint64_t told_ = 0;  ///< commands, since the machine was built
  std::uint32_t segments_begun_ = 0;
  std::uint32_t index_ = 0;
  std::uint64_t enabled_ = 0;
  std::uint64_t skipped_ = 0;
  std::vector<machines::Skip> skips_;
  std::vector<bool> answers_;
};

}  // namespace csgsim::pixel_planes
