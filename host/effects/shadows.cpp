#include "host/effects/shadows.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "host/effects/shadow_broadcast.h"
#include "host/effects/shadow_parts.h"
#include "host/effects/shadow_receivers.h"
#include "host/effects/shadow_volumes.h"
#include "hw/base/error.h"
#include "hw/isa/opcodes.h"

namespace csgsim::effects {

namespace {

struct Settings {
  std::optional<std::uint32_t> light;
  Casters casters;
};

constexpr double last_light = 1000;

constexpr std::array keys{
    scene::integer_key<&Settings::light>("light", "", 0, last_light,
                                         "the only one that throws shadows, by its number in the scene, from 0; "
                                         "all do, if not given"),
    scene::integer_key<&Settings::casters, &Casters::from_line>(
        "from_line", "", 1, scene::last_line,
        "primitives from this line of the model on throw shadows; all do, if "
        "not given"),
    scene::integer_key<&Settings::casters, &Casters::to_line>("to_line", "", 1, scene::last_line,
                                                              "to this line; from_line if not given")};

void keep(scene::Scene& scene, const scene::Section& section, std::any&& read) {
  const Casters& casters = std::any_cast<const Settings&>(read).casters;
  if (casters.to_line && !casters.from_line) throw InputError("to_line without from_line; add from_line");
  if (casters.to_line && *casters.to_line < *casters.from_line)
    throw InputError("to_line is before from_line; change them over");
  scene::keep_effect(scene, section, std::move(read));
}

/// Lights of a drawing that throw shadows.
std::vector<std::size_t> lights_of(const Settings& settings, const lighting::Lighting& lighting) {
  std::vector<std::size_t> lights;
  for (std::size_t i = 0; i < lighting.lights.size(); ++i)
    if (settings.light.value_or(i) == i) lights.push_back(i);
  if (lights.empty()) {
    throw InputError(fmt::format("effects.shadows.light is {}, and the scene's lights are numbered 0 to {}",
                                 *settings.light, lighting.lights.size() - 1));
  }
  return lights;
}

using Prepared = std::vector<ShadowLight>;

emit::EffectState prepare(const std::any& settings, const emit::Drawing& drawing, const emit::Workshop& workshop) {
  const auto& own = std::any_cast<const Settings&>(settings);
  emit::EffectState state;
  state.own =
      Prepared(shadow_lights(drawing, lights_of(own, drawing.look.lighting), own.casters, workshop.options.work));
  return state;
}

/// Most bits to remember what volumes have in common.
constexpr std::size_t most_marks = 8;

std::string flag_name(std::size_t index) { return fmt::format("flag{}", index); }

/// A flag a light, a spare bit, and marks, as far as Z1 has room for them.
std::vector<emit::FieldRequest> fields(const std::any& settings, const emit::Drawing& drawing,
                                       const emit::Workshop& /*workshop*/) {
  const std::size_t lights = lights_of(std::any_cast<const Settings&>(settings), drawing.look.lighting).size();
  const auto request = [](const std::string& name, std::size_t width) {
    return emit::FieldRequest{name, isa::FieldRole::scratch, static_cast<unsigned>(width), "shadow", {}, true};
  };
  std::vector<emit::FieldRequest> all;
  for (std::size_t i = 0; i < lights; ++i) all.push_back(request(flag_name(i), 1));
  all.push_back(request("spare", 1));
  const std::size_t left =
      drawing.view.sampling.z_bits - std::min<std::size_t>(drawing.view.sampling.z_bits, lights + 1);
  all.push_back(request("marks", std::min(left, most_marks)));
  return all;
}

emit::Shadows light(const emit::EffectCall& call, emit::Broadcast& out) {
  const emit::Context& context = call.context;
  const auto field = [&](std::string_view name) { return context.layout.of("shadows", name); };
  emit::Shadows result{{}, field("spare")};
  const auto& lights = std::any_cast<const Prepared&>(call.state.own);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const Receivers receivers = receivers_of(context, lights[i].light);
    const ShadowParts found =
        parts_that_touch(lights[i].volumes, receivers, context.view.sampling.fraction_bits, context.options.work);
    if (found.parts.empty()) continue;
    emit::ShadowBit bit{lights[i].light, field(flag_name(i)), {}};
    emit_shadows(context, out, found.parts, bit.bit, field("marks"));
    for (const std::size_t one : found.touched)
      bit.facets.emplace_back(receivers.facets[one].primitive, receivers.facets[one].halfspace);
    result.bits.push_back(std::move(bit));
  }
  return result;
}

}  // namespace

const emit::Effect shadows{
    .section = {"effects.shadows", "solids take the light from one another", false, keys,
                scene::blank_section<Settings>, keep},
    .technique =
        "shadow volumes (Crow, Shadow Algorithms for Computer Graphics, SIGGRAPH 1977), of each convex piece of the "
        "model an intersection of half-spaces that are compared with the depth of what is seen, as Fuchs et al., "
        "SIGGRAPH 1985, do for polygons",
    .prepare = prepare,
    .fields = fields,
    .needs_owners = true,
    .light = light};

}  // namespace csgsim::effects
