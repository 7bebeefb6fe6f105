#include <fmt/format.h>

#include "hw/base/error.h"
#include "sim/rows/address.h"
#include "sim/rows/forms.h"

namespace csgsim::rows {

namespace {

/// A read or write of a burst by an ordinary memory controller.
struct Access {
  bool is_write = false;
  std::uint64_t clock = 0;
  std::uint32_t bank = 0;
  std::uint32_t row = 0;
  std::uint32_t burst = 0;
};

/// Forms that list accesses instead of commands: an activation becomes an access to the first burst of its row.
class AccessForm : public Form {
 public:
  using Form::Form;

  void add(const RowCommand& command, const Issue& issue, Lines& lines) const final {
    if (bit_serial_memory::activations(command.op) == 0) return;
    const std::uint32_t bank = frame().slots.bank(issue.place);
    const auto access = [&](bool is_write, std::uint64_t clock, const bit_serial_memory::WordLines& raised,
                            std::uint32_t burst) {
      lines.push_back(
          {clock, text({is_write, clock, bank, row_in_bank(raised.begin()->row, issue.place, frame()), burst})});
    };
    const bool is_written = command.from.count == 0;
    const auto& raised = is_written ? command.to : command.from;
    if (issue.transfer_clocks == 0) {
      access(is_written, issue.clock, raised, 0);
      if (command.op == RowOp::copy) access(true, issue.second, command.to, 0);
      return;
    }
    std::uint32_t burst = 0;
    for (const std::uint64_t clock : burst_commands(issue, frame())) access(is_written, clock, raised, burst++);
  }

  void add_refresh(std::uint64_t /*clock*/, Lines& /*lines*/) const final {}
  [[nodiscard]] bool has_refreshes() const final { return false; }

  [[nodiscard]] std::string_view instead(RowOp op) const final {
    switch (op) {
      case RowOp::copy: return "a read and a write of one burst";
      case RowOp::activate:
      case RowOp::latch:
      case RowOp::read: return "a read of one burst";
      case RowOp::write:
      case RowOp::leaf_copy: return "a write of one burst";
      case RowOp::logic:
      case RowOp::leaf:
      case RowOp::wired_or: return "nothing";
      case RowOp::receive:
      case RowOp::send: return {};
    }
    return {};
  }

 protected:
  [[nodiscard]] virtual std::string text(const Access& access) const = 0;
};

/// Refuses ranks whose addresses would differ from those of eight chips of DDR4 with 8 Gbit.
void check_geometry(const Frame& frame, std::string_view form) {
  const bit_serial_memory::Figures& figures = frame.figures;
  const bool fits = figures.chips == 8 && figures.banks == 16 && figures.row_bits == 8192 &&
                    std::uint64_t{figures.subarrays} * figures.subarray_rows == 65536;
  if (fits) return;
  throw InputError(
      fmt::format("{}: addresses of {} are those of eight chips with 16 banks of 65,536 rows and 8,192 columns; use "
                  "that geometry, or a form without addresses such as csgsim",
                  frame.machine.name, form));
}

constexpr unsigned byte_bits = 6;    ///< bits of an address within a burst of 64 bytes
constexpr unsigned column_bits = 7;  ///< bits of the number of a burst in its row
constexpr unsigned bank_bits = 4;    ///< two for the group, the lower ones, and two for the bank in its group

/// Address with the fields row, rank, bank, bank group, burst from the highest to the lowest bit; the rank is 0.
std::uint64_t address(const Access& access, unsigned rank_bits) {
  const std::uint64_t bank = (std::uint64_t{bank_in_group(access.bank)} << 2U) + group_of(access.bank);
  const std::uint64_t row_and_bank = (std::uint64_t{access.row} << (rank_bits + bank_bits)) + bank;
  return ((row_and_bank << column_bits) + access.burst) << byte_bits;
}

/// The trace that DRAMsim3 reads, with the address mapping and the two ranks of its configs/DDR4_8Gb_x8_2400.ini.
class Dramsim3Form final : public AccessForm {
 public:
  using AccessForm::AccessForm;

 protected:
  [[nodiscard]] std::string text(const Access& access) const override {
    return fmt::format("0x{:X} {} {}\n", address(access, 1), access.is_write ? "WRITE" : "READ", access.clock);
  }
};

/// The trace of Ramulator 2's LoadStoreTrace, for one rank and the address mapper RoBaRaCoCh.
class Ramulator2AccessForm final : public AccessForm {
 public:
  using AccessForm::AccessForm;

 protected:
  [[nodiscard]] std::string text(const Access& access) const override {
    return fmt::format("{} 0x{:X}\n", access.is_write ? "ST" : "LD", address(access, 0));
  }
};

}  // namespace

const FormRow dramsim3_form{.name = "dramsim3", .make = [](const Frame& frame) -> std::unique_ptr<Form> {
                              check_geometry(frame, "dramsim3");
                              return std::make_unique<Dramsim3Form>(frame);
                            }};
const FormRow ramulator2_accesses_form{.name = "ramulator2-accesses",
                                       .make = [](const Frame& frame) -> std::unique_ptr<Form> {
                                         check_geometry(frame, "ramulator2-accesses");
                                         return std::make_unique<Ramulator2AccessForm>(frame);
                                       }};

}  // namespace csgsim::rows
