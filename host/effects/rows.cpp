#include "host/effects/rows.h"

#include <array>

#include "host/effects/antialias.h"
#include "host/effects/cuts.h"
#include "host/effects/depth_cue.h"
#include "host/effects/edges.h"
#include "host/effects/equalise.h"
#include "host/effects/mirrors.h"
#include "host/effects/shadows.h"
#include "host/effects/smooth.h"
#include "host/effects/textures.h"
#include "host/effects/transparency.h"
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

std::span<const emit::Effect* const> all() { return rows; }

std::vector<scene::Section> sections() {
  std::vector<scene::Section> sections;
  sections.reserve(rows.size());
  for (const emit::Effect* const one : rows) sections.push_back(one->section);
  return sections;
}

model::Tree reshaped(model::Tree&& tree, const scene::Scene& scene) {
  for (const emit::Effect* const row : rows) {
    if (row->reshape == nullptr) continue;
    for (const scene::CalledEffect& one : scene.effects)
      if (one.is_on && one.name == row->section.name) tree = row->reshape(one.settings, std::move(tree));
  }
  return std::move(tree);
}

}  // namespace csgsim::effects
