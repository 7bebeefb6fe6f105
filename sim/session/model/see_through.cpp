#include "sim/session/model/see_through.h"

#include <fmt/format.h>

#include "host/csg/positive_tree.h"
#include "hw/base/error.h"
#include "hw/base/text.h"

namespace csgsim::session {

const emit::EffectRow* see_through(const emit::Options& emit, const model::Tree& tree, const view::Camera& camera) {
  const emit::Look look = emit::make_look(emit.scene, tree, csg::make_positive(tree), camera);
  for (const emit::EffectRequest& one : emit::called_effects(emit, look))
    if (one.row->sees_through) return one.row;
  return nullptr;
}

void refuse_see_through(const ModelRequest& request, const model::Tree& tree, const view::Camera& camera) {
  if (const emit::EffectRow* const effect = see_through(emit_options_of(request), tree, camera)) {
    throw InputError(
        fmt::format("{}: the exact reference picture supports opaque solids only; add --set effects.{}.on=false",
                    printable(request.model), effect->name()));
  }
}

}  // namespace csgsim::session
