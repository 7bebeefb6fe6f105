#include "host/effects/rows.h"

#include <array>

#include "host/emit/flat_shading.h"

namespace csgsim::effects {

namespace {

// clang-format off
// Mirrors before transparency: they are behind the glass.
constexpr std::array rows{
    &emit::flat,
    &smooth,
    &textures,
    &cuts,
    &shadows,
    &mirrors,
    &transparency,
    &antialias,
    &depth_cue,
    &edges,
    &equalise,
};
// clang-format on

}  // namespace

std::span<const emit::EffectRow* const> all() { return rows; }

std::vector<scene::Section> sections() {
  std::vector<scene::Section> sections;
  sections.reserve(rows.size());
  for (const emit::EffectRow* const one : rows) sections.push_back(one->section);
  return sections;
}

model::Tree reshaped(model::Tree&& tree, const scene::Scene& scene) {
  for (const emit::EffectRow* const row : rows) {
    for (const scene::CalledEffect& one : scene.effects)
      if (one.is_on && one.name == row->section.name) tree = row->parts.make(one.tables)->reshape(std::move(tree));
  }
  return std::move(tree);
}

}  // namespace csgsim::effects
