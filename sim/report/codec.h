#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace csgsim::report {

/// Appends a number in groups of 7 bits, the lowest first; all but the last byte have their highest bit set (LEB128).
void put_varint(std::uint64_t number, std::string& bytes);

/// Takes a number from the front. The bytes have to hold one.
std::uint64_t take_varint(std::string_view& bytes);

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

/// Values as varints in turn: how many pixels, and their value + 1, where no_owner is 0.
std::string owner_runs(std::span<const std::uint32_t> owners);

/// What turns `before` into `after` by an exclusive or, as DrawingStep::changes. Both are equally long.
std::string changes(std::span<const std::uint32_t> before, std::span<const std::uint32_t> after);

/// Carries out such changes.
void change(std::string_view changes, std::span<std::uint32_t> states);

}  // namespace csgsim::report
