// Limits of the `.csg` reader.
// Used by build.cpp, parser.cpp, source.h, host/commands and sim/session.
#pragma once

#include <cstddef>
#include <cstdint>

namespace csgsim::read {

// Limits of the reader. They keep a hostile file from exhausting memory; exceeding one is an InputError.

inline constexpr std::size_t max_file_bytes = std::size_t{1} << 30U;
inline constexpr std::size_t max_depth = 100'000;  ///< nesting depth of braces
inline constexpr std::uint32_t max_statements = 4'000'000;
inline constexpr std::size_t max_primitives = 1'000'000;
inline constexpr std::size_t max_vector_depth = 8;    ///< nesting depth of brackets
inline constexpr std::size_t max_values = 4'000'000;  ///< numbers, vectors etc. in one statement

}  // namespace csgsim::read
