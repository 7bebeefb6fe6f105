#include "sim/report/codec.h"

#include <cstddef>

namespace csgsim::report {

namespace {

constexpr unsigned varint_bits = 7;
constexpr unsigned char more_follow = 0x80U;

constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// End of the run of equal values that starts at `begin`.
template <class Value>
std::size_t run_end(std::size_t begin, std::size_t end, Value value) {
  std::size_t at = begin + 1;
  while (at < end && value(at) == value(begin)) ++at;
  return at;
}

}  // namespace

void put_varint(std::uint64_t number, std::string& bytes) {
  while (number >= more_follow) {
    bytes.push_back(static_cast<char>((number & (more_follow - 1U)) | more_follow));
    number >>= varint_bits;
  }
  bytes.push_back(static_cast<char>(number));
}

std::uint64_t read_varint(std::string_view& bytes) {
  std::uint64_t number = 0;
  for (unsigned shift = 0;; shift += varint_bits) {
    const auto byte = static_cast<unsigned char>(bytes.front());
    bytes.remove_prefix(1);
    number |= static_cast<std::uint64_t>(byte & (more_follow - 1U)) << shift;
    if ((byte & more_follow) == 0) return number;
  }
}

std::string base64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text.push_back(i + k <= bytes.size() ? digits[group >> (18U - 6U * k) & 63U] : '=');
  }
  return text;
}

std::string encode_owner_runs(std::span<const std::uint32_t> owners) {
  std::string bytes;
  for (std::size_t i = 0; i < owners.size();) {
    const std::size_t end = run_end(i, owners.size(), [&](std::size_t at) { return owners[at]; });
    put_varint(end - i, bytes);
    put_varint(owners[i] + std::uint32_t{1}, bytes);
    i = end;
  }
  return bytes;
}

std::string encode_changes(std::span<const std::uint32_t> before, std::span<const std::uint32_t> after) {
  std::string bytes;
  std::size_t same = 0;
  const auto difference = [&](std::size_t at) { return before[at] ^ after[at]; };
  for (std::size_t i = 0; i < before.size();) {
    const std::size_t end = run_end(i, before.size(), difference);
    if (difference(i) == 0) {
      same = end - i;
    } else {
      put_varint(same, bytes);
      put_varint(end - i, bytes);
      put_varint(difference(i), bytes);
      same = 0;
    }
    i = end;
  }
  return bytes;
}

void apply_changes(std::string_view changes, std::span<std::uint32_t> states) {
  std::size_t at = 0;
  while (!changes.empty()) {
    at += read_varint(changes);
    const std::uint64_t count = read_varint(changes);
    const auto difference = static_cast<std::uint32_t>(read_varint(changes));
    for (const std::uint64_t end = at + count; at < end; ++at) states[at] ^= difference;
  }
}

}  // namespace csgsim::report
