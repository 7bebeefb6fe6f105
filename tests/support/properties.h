#pragma once

#include <cstdint>
#include <string_view>

/// Random streams of rapidcheck's properties. Every property has a separate stream, derived from the seed, the name of
/// its test case, its description and the number of properties checked before it in that case. The seed is fixed unless
/// RC_PARAMS sets one, so that the suite draws the same cases each time; ./setup.sh nightly sets other seeds.
namespace csgsim::testing {

/// Adds parameters such as `max_success=30` to RC_PARAMS unless they are already set there, and the fixed seed. Must be
/// called before the first property is checked.
void add_parameters(std::string_view parameters = {});

/// Sets the test case of the properties that are checked from now on.
void begin_case(std::string_view name);

/// Calls begin_case() with the arguments of a command line, without the program name.
void begin_program(int count, const char* const* words);

/// Seed of the next property of the test case.
std::uint64_t next_seed(std::uint64_t seed, std::string_view description);

}  // namespace csgsim::testing
