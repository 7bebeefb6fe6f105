#pragma once

#include <cstddef>
#include <cstdint>

namespace csgsim::read {

// What the reader takes at most. They keep a hostile file from filling memory; each is an InputError that says so.

inline constexpr std::size_t max_file_bytes = std::size_t{1} << 30U;
inline constexpr std::size_t max_depth = 100'000;  ///< braces in braces
inline constexpr std::uint32_t max_statements = 4'000'000;
inline constexpr std::size_t max_primitives = 1'000'000;
inline constexpr std::size_t max_vector_depth = 8;    ///< brackets in brackets
inline constexpr std::size_t max_values = 4'000'000;  ///< numbers, vectors, ... in one statement

}  // namespace csgsim::read
