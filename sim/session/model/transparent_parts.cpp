#include "sim/session/model/transparent_parts.h"

#include <fmt/format.h>

#include "host/emit/effect.h"
#include "hw/base/error.h"

namespace csgsim::session {

void refuse_transparent_parts(const emit::Options& options, const model::Tree& tree, const view::Camera& camera) {
  const emit::EffectRow* const effect = emit::find_transparency_effect(options, tree, camera);
  if (effect == nullptr) return;
  throw InputError(
      fmt::format("{}: the exact reference picture supports opaque solids only; add --set effects.{}.on=false",
                  tree.file, effect->name()));
}

}  // namespace csgsim::session
