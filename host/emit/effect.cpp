#include "host/emit/effect.h"

#include <algorithm>
#include <utility>

#include "host/csg/positive_tree.h"
#include "hw/base/error.h"

namespace csgsim::emit {

std::vector<EffectRequest> called_effects(const Options& options, const Look& look) {
  std::vector<EffectRequest> called;
  for (const EffectRow* const row : options.effects) {
    const std::vector<scene::EffectRequest>& said = options.scene.effects;
    const auto found = std::find_if(said.begin(), said.end(),
                                    [&](const scene::EffectRequest& one) { return one.name == row->section.name; });
    if (found != said.end()) {
      if (found->is_on) called.push_back({row, row->parts.make(found->tables)});
    } else {
      auto effect = row->parts.make({});
      if (effect->is_implied_by(look)) called.push_back({row, std::move(effect)});
    }
  }
  return called;
}

const EffectRow* find_transparency_effect(const Options& options, const model::Tree& tree, const view::Camera& camera) {
  const Look look = make_look(options.scene, tree, csg::make_positive_tree(tree), camera);
  for (const EffectRequest& one : called_effects(options, look))
    if (one.row->sees_through) return one.row;
  return nullptr;
}

std::vector<EffectFields> effect_fields(const Drawing& drawing, const DrawingInputs& inputs) {
  std::vector<EffectFields> all;
  for (const EffectRequest& one : inputs.called) all.push_back({one.row->name(), one.effect->fields(drawing, inputs)});
  return all;
}

bool any_needs_owners(std::span<const EffectRequest> called) {
  return std::any_of(called.begin(), called.end(), [](const EffectRequest& one) { return one.row->needs_owners; });
}

}  // namespace csgsim::emit
