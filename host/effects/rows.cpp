#include "host/effects/rows.h"

namespace csgsim::effects {

std::vector<scene::Section> sections() {
  std::vector<scene::Section> sections;
  sections.reserve(all().size());
  for (const emit::EffectRow* const one : all()) sections.push_back(one->section);
  return sections;
}

model::Tree reshape_model(model::Tree&& tree, const scene::Scene& scene) {
  for (const emit::EffectRow* const row : all()) {
    for (const scene::EffectRequest& one : scene.effects)
      if (one.is_on && one.name == row->section.name) tree = row->parts.make(one.tables)->reshape(std::move(tree));
  }
  return std::move(tree);
}

}  // namespace csgsim::effects
