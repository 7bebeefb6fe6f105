// Interface of a text form of row-command traces.
// Used by sim/rows.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hw/bit_serial_memory/command_set.h"
#include "hw/bit_serial_memory/figures.h"
#include "hw/bit_serial_memory/row_listener.h"
#include "hw/bit_serial_memory/row_map.h"
#include "hw/bit_serial_memory/slots.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/timing.h"

namespace csgsim::rows {

using bit_serial_memory::Issue;
using bit_serial_memory::RowCommand;
using bit_serial_memory::RowOp;

/// The frame that a trace describes.
struct Frame {
  const isa::Program& program;
  const machines::Machine& machine;  ///< its picture is that of the Program
  const bit_serial_memory::Figures& figures;
  bit_serial_memory::RowMap map;
  bit_serial_memory::Slots slots;
  const bit_serial_memory::CommandSet* set = nullptr;  ///< replaces the gates if not null
};

/// A line of a trace with its line end. The lines of an instruction are sorted by clock.
struct Line {
  std::uint64_t clock = 0;
  std::string text;
};

using Lines = std::vector<Line>;

/// A text form of traces. Texts between the commands are empty by default.
class Form {
 public:
  explicit Form(const Frame& frame) : frame_(frame) {}
  Form(const Form&) = delete;
  Form& operator=(const Form&) = delete;
  virtual ~Form() = default;

  [[nodiscard]] virtual std::string heading() const { return {}; }
  virtual std::string segment(std::uint32_t /*number*/) { return {}; }
  virtual std::string instruction(std::uint64_t /*number*/, const isa::Instruction& /*instruction*/) { return {}; }
  [[nodiscard]] virtual std::string scan_out() const { return {}; }
  [[nodiscard]] virtual std::string end(const machines::FrameTiming& /*timing*/) const { return {}; }

  /// Appends the lines of a command in one slot or bank.
  virtual void add(const RowCommand& command, const Issue& issue, Lines& lines) const = 0;
  /// Appends the line of a refresh of all banks.
  virtual void add_refresh(std::uint64_t clock, Lines& lines) const = 0;

  /// Description of what the form contains instead of a command that it cannot express; empty if it can express it.
  [[nodiscard]] virtual std::string_view instead(RowOp op) const = 0;
  /// Whether the form contains refreshes.
  [[nodiscard]] virtual bool has_refreshes() const { return true; }
  /// Whether the form names all rows that are activated together, and the latch that masks a write.
  [[nodiscard]] virtual bool has_all_rows() const { return false; }

 protected:
  [[nodiscard]] const Frame& frame() const { return frame_; }

 private:
  const Frame& frame_;
};

}  // namespace csgsim::rows
