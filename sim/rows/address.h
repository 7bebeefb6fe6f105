// Places of rows and bursts in a rank of DDR4.
// Used by the forms of other simulators.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/rows/form.h"

namespace csgsim::rows {

/// Clocks of the data bus for a burst of DDR4: eight transfers, two a clock.
inline constexpr std::uint64_t burst_clocks = 4;
/// Columns of a chip that a burst transfers.
inline constexpr std::uint32_t burst_columns = 8;
inline constexpr std::uint32_t bank_groups = 4;

/// The group of a bank. Consecutive banks belong to different groups, so that tRRD_S and tCCD_S apply between them.
constexpr std::uint32_t group_of(std::uint32_t bank) { return bank % bank_groups; }
constexpr std::uint32_t bank_in_group(std::uint32_t bank) { return bank / bank_groups; }

/// Index of a row in its bank.
std::uint32_t row_in_bank(bit_serial_memory::Row row, std::uint64_t slot, const Frame& frame);

/// Bytes that all chips transfer in a burst.
std::uint64_t burst_bytes(const Frame& frame);

/// Clocks of the column commands that transfer a slot's row. timing.column is tRCD and CL, which are equal in the
/// speed grades of DDR4: a command is issued half of it before its data.
std::vector<std::uint64_t> burst_commands(const Issue& issue, const Frame& frame);

}  // namespace csgsim::rows
