#include "host/emit/effect.h"

#include <algorithm>

#include "hw/base/error.h"

namespace csgsim::emit {

std::vector<CalledEffect> called_effects(const Options& options, const Look& look) {
  std::vector<CalledEffect> called;
  for (const Effect* const effect : options.effects) {
    const std::vector<scene::CalledEffect>& said = options.scene.effects;
    const auto found = std::find_if(said.begin(), said.end(),
                                    [&](const scene::CalledEffect& one) { return one.name == effect->section.name; });
    if (found != said.end()) {
      if (found->is_on) called.push_back({effect, found->settings});
    } else if (effect->called_by != nullptr && effect->called_by(look)) {
      called.push_back({effect, effect->section.blank()});
    }
  }
  return called;
}

std::vector<EffectFields> effect_fields(const Drawing& drawing, const Workshop& workshop) {
  std::vector<EffectFields> all;
  for (const CalledEffect& one : workshop.called) {
    if (one.effect->fields == nullptr) continue;
    all.push_back({one.effect->name(), one.effect->fields(one.settings, drawing, workshop)});
  }
  return all;
}

bool any_needs_owners(std::span<const CalledEffect> called) {
  return std::any_of(called.begin(), called.end(), [](const CalledEffect& one) { return one.effect->needs_owners; });
}

}  // namespace csgsim::emit
