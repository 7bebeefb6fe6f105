#include "host/emit/curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "host/emit/effect.h"
#include "hw/machines/regions.h"

namespace csgsim::emit {

namespace {

constexpr auto curve_names = std::to_array<std::string_view>({"facets", "fast", "exact", "auto"});
static_assert(curve_names.size() == curve_choices.size());

}  // namespace

std::string_view name_of(Curves curves) { return curve_names.at(static_cast<std::size_t>(curves)); }

std::optional<std::string> quadrics_unsupported_reason(const machines::Machine& machine, const Options& options,
                                                       const Look& look) {
  if (machine.evaluator_degree < 2)
    return fmt::format(
        "{} evaluates only linear expressions, and a curved surface needs quadratic ones; take a machine whose "
        "evaluator.degree is 2, such as pixel-powers",
        machine.name);
  return curves_unsupported_reason(machine, options, look);
}

std::optional<std::string> curves_unsupported_reason(const machines::Machine& machine, const Options& options,
                                                     const Look& look) {
  if (machines::division(machine))
    return fmt::format(
        "{} divides the model itself, and its divider supports only half-spaces; take a machine for which the host "
        "divides, such as pixel-powers",
        machine.name);
  for (const EffectRequest& one : called_effects(options, look)) {
    if (!one.row->takes_quadrics)
      return fmt::format("the effect {} works on facets; leave it out by --set effects.{}.on=false", one.row->name(),
                         one.row->name());
  }
  const bool shines = std::any_of(look.finishes.begin(), look.finishes.end(),
                                  [](const lighting::Finish& one) { return one.material.specular > 0; });
  if (shines) return "highlights are computed once per facet; remove the materials' specular from the scene";
  return std::nullopt;
}

}  // namespace csgsim::emit
