#include "sim/study/settings.h"

#include <fmt/format.h>

#include <algorithm>

namespace csgsim::study {

namespace {

constexpr unsigned z_bits[] = {8, 10, 12, 14, 16, 18, 20, 22, 24};
constexpr unsigned fraction_bits[] = {0, 2, 4, 6, 8, 10, 12, 14, 16};
constexpr double edge_on[] = {1.0 / 4, 1.0 / 16, 1.0 / 64, 1.0 / 256, 1.0 / 1024, 1.0 / 4096};
constexpr unsigned size_parts[] = {8, 4, 2, 1};
constexpr unsigned fragments[] = {8, 16, 32, 64, 128};
constexpr double tolerances[] = {1e-2, 3e-3, 1e-3, 3e-4, 1e-4};

constexpr unsigned grid_z_bits[] = {10, 12, 14, 16, 18, 20};
constexpr unsigned grid_fraction_bits[] = {2, 4, 6, 8, 10, 12};

}  // namespace

std::vector<Settings> grid(const view::Sampling& base, const facet::Faceting& faceting) {
  std::vector<Settings> settings;
  for (const unsigned z : grid_z_bits) {
    for (const unsigned fraction : grid_fraction_bits) {
      Settings point{"together", fmt::format("{}/{}", z, fraction), faceting, base};
      point.sampling.z_bits = z;
      point.sampling.fraction_bits = fraction;
      settings.push_back(std::move(point));
    }
  }
  return settings;
}

std::vector<Settings> points(const view::Sampling& base, const facet::Faceting& faceting, double diagonal) {
  std::vector<Settings> settings;
  const auto add = [&](const char* knob, std::string value) -> Settings& {
    return settings.emplace_back(Settings{knob, std::move(value), faceting, base});
  };
  for (const unsigned bits : z_bits) add("z-bits", std::to_string(bits)).sampling.z_bits = bits;
  for (const unsigned bits : fraction_bits) add("fraction-bits", std::to_string(bits)).sampling.fraction_bits = bits;
  for (const double part : edge_on)
    add("edge-on", fmt::format("1/{:.0f}", 1.0 / part)).sampling.edge_on_fraction = part;
  for (const unsigned part : size_parts) {
    const std::uint32_t width = std::max(1U, base.width / part);
    const std::uint32_t height = std::max(1U, base.height / part);
    view::Sampling& sampling = add("size", fmt::format("{}x{}", width, height)).sampling;
    sampling.width = width;
    sampling.height = height;
  }
  for (const unsigned count : fragments) add("fn", std::to_string(count)).faceting = {std::nullopt, count};
  for (const double part : tolerances) {
    add("tolerance", fmt::format("{:g}", part * diagonal)).faceting = {part * diagonal, std::nullopt};
  }
  for (Settings& point : grid(base, faceting)) settings.push_back(std::move(point));
  return settings;
}

}  // namespace csgsim::study
