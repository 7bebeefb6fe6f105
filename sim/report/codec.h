// Compact encodings of page data: varints, base 64, runs.
// Used by sim/report, sim/viewer and sim/web.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace csgsim::report {

/// Appends a number in groups of 7 bits, the lowest first; all but the last byte have their highest bit set (LEB128).
void put_varint(std::uint64_t number, std::string& bytes);

/// Removes a number from the front and returns it. The bytes must begin with the result of put_varint().
std::uint64_t read_varint(std::string_view& bytes);

/// Base 64 with padding (RFC 4648).
std::string base64(std::string_view bytes);

/// Run lengths as varints: number of pixels and value + 1 in turn, where no_owner becomes 0.
std::string encode_owner_runs(std::span<const std::uint32_t> owners);

/// The exclusive or that turns `before` into `after`, in the form of DrawingStep::changes. Both have the same length.
std::string encode_changes(std::span<const std::uint32_t> before, std::span<const std::uint32_t> after);

/// Applies the result of encode_changes() to the states.
void apply_changes(std::string_view changes, std::span<std::uint32_t> states);

}  // namespace csgsim::report
