#pragma once

#include <cstdint>
#include <string_view>

/// The random numbers that rapidcheck's properties draw. Every property has a separate stream, made from the seed, the
/// name of its test case, its description and the number of properties checked there before. The seed is
/// fixed unless RC_PARAMS names one, so that the suite draws the same cases each time; ./setup.sh nightly names others.
namespace csgsim::testing {

/// Adds parameters to RC_PARAMS, as in `max_success=30`, that it does not set, and the fixed seed. To be called before
/// the first property is checked.
void add_parameters(std::string_view parameters = {});

/// Properties that are checked from now on are in this test case.
void begin_case(std::string_view name);

/// Calls begin_case() with the words of a program's command line, without the program's name.
void begin_program(int count, const char* const* words);

/// The seed of the next property of the test case.
std::uint64_t next_seed(std::uint64_t seed, std::string_view description);

}  // namespace csgsim::testing
