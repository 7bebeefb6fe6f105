#include "host/effects/rows.h"

#include <algorithm>
#include <array>

#include "host/effects/smooth.h"

namespace csgsim::effects {

namespace {

constexpr std::array<const emit::Effect*, 1> rows{&smooth};

}  // namespace

std::span<const emit::Effect* const> all() { return rows; }

std::vector<scene::Section> sections() {
  std::vector<scene::Section> sections;
  sections.reserve(rows.size());
  for (const emit::Effect* const one : rows) sections.push_back(one->section);
  return sections;
}

std::vector<emit::CalledEffect> called_by(const scene::Scene& scene) {
  std::vector<emit::CalledEffect> called;
  for (const emit::Effect* const row : rows) {
    const auto of_row = [&](const scene::CalledEffect& one) { return one.name == row->section.name; };
    const auto found = std::find_if(scene.effects.begin(), scene.effects.end(), of_row);
    if (found != scene.effects.end()) called.push_back({row, found->settings});
  }
  return called;
}

}  // namespace csgsim::effects
