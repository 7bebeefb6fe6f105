#pragma once

#include <cstdint>
#include <string>

namespace csgsim::budgets {

constexpr double published_triangle = 1e7 / 30'000;
constexpr double published_shadow = 1e7 / 21'000;
constexpr double published_sphere = 1e7 / 25'000;
constexpr double published_expression = 7.5e-3 * 1e7 / 1'900;

/// The first row of docs/performance.md that begins with that name, without the name.
std::string row_of_page(const std::string& name);

/// Fails the test if that row of the page states other clocks.
void check_row(const std::string& name, double published, std::uint64_t ours);

}  // namespace csgsim::budgets
