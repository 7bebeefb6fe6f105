// Constants of the checkpoint format.
// Used by decode.cpp and snapshot.cpp.
#pragma once

#include <array>
#include <boost/crc.hpp>
#include <cstddef>
#include <cstdint>
#include <span>

namespace csgsim::checkpoint {

/// The bytes with which the file of a Snapshot begins, its format version, and the size of its checksum in bytes.
inline constexpr std::array<std::uint8_t, 4> snapshot_magic{'C', 'S', 'G', 'S'};
inline constexpr std::uint8_t snapshot_version = 3;
inline constexpr std::size_t snapshot_checksum_size = 4;

inline std::uint32_t snapshot_checksum(std::span<const std::byte> bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

/// Calls visit(cost) for every cost, in the order of the file.
template <class Stats, class Visit>
void for_each_cost(Stats& stats, Visit visit) {
  visit(stats.total);
  for (auto& cost : stats.by_opcode) visit(cost);
  for (auto& cost : stats.by_purpose) visit(cost);
  for (auto& cost : stats.by_primitive) visit(cost);
  for (auto& cost : stats.plain_by_primitive) visit(cost);
  for (auto& cost : stats.by_effect) visit(cost);
}

}  // namespace csgsim::checkpoint
