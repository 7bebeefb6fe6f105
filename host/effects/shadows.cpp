#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "host/effects/rows.h"
#include "host/effects/shadow_broadcast.h"
#include "host/effects/shadow_parts.h"
#include "host/effects/shadow_receivers.h"
#include "host/effects/shadow_volumes.h"
#include "hw/base/error.h"
#include "hw/isa/field_role.h"
#include "hw/isa/opcodes.h"

namespace csgsim::effects {

namespace {

struct Settings {
  std::optional<std::uint32_t> light;
  Casters casters;
};

constexpr double last_light = 1000;

void visit_keys(Settings& settings, auto&& visit) {
  visit(scene::integer_key("light", "", 0, last_light,
                           "number in the scene, from 0, of the only light that casts shadows; by default all do"),
        settings.light);
  visit(scene::integer_key("from_line", "", 1, scene::last_line,
                           "primitives from this line of the model on cast shadows; by default all do"),
        settings.casters.from_line);
  visit(scene::integer_key("to_line", "", 1, scene::last_line,
                           "last line of the primitives that cast shadows; by default from_line"),
        settings.casters.to_line);
}

void complete(const Settings& settings) {
  const Casters& casters = settings.casters;
  if (casters.to_line && !casters.from_line) throw InputError("to_line without from_line; add from_line");
  if (casters.to_line && *casters.to_line < *casters.from_line)
    throw InputError("to_line precedes from_line; set it to from_line or more");
}

/// Lights of a drawing that cast shadows.
std::vector<std::size_t> casting_lights(const Settings& settings, const lighting::Lighting& lighting) {
  std::vector<std::size_t> lights;
  for (std::size_t i = 0; i < lighting.lights.size(); ++i)
    if (settings.light.value_or(i) == i) lights.push_back(i);
  if (lights.empty()) {
    throw InputError(fmt::format("effects.shadows.light is {}; the scene's lights are numbered 0 to {}",
                                 *settings.light, lighting.lights.size() - 1));
  }
  return lights;
}

struct Prepared : emit::EffectState {
  std::shared_ptr<const std::vector<CastLight>> cast_lights;  ///< shared by all samples of a drawing
  std::vector<ShadowLight> lights;
};

/// Maximum number of bits for marking the planes that volumes share.
constexpr std::size_t max_marks = 8;

std::string flag_name(std::size_t index) { return fmt::format("flag{}", index); }

class CastShadows final : public emit::EffectOf<Settings, Prepared> {
 public:
  /// Fields: one flag per light, a spare bit, and as many marks as fit into Z1.
  [[nodiscard]] std::vector<emit::FieldRequest> fields(const emit::Drawing& drawing,
                                                       const emit::DrawingInputs& /*inputs*/) const override {
    const std::size_t lights = casting_lights(settings, drawing.look.lighting).size();
    const auto request = [](const std::string& name, std::size_t width) {
      return emit::FieldRequest{name, isa::FieldRole::scratch, static_cast<unsigned>(width), "shadow", {}, true};
    };
    std::vector<emit::FieldRequest> all;
    for (std::size_t i = 0; i < lights; ++i) all.push_back(request(flag_name(i), 1));
    all.push_back(request("spare", 1));
    const std::size_t left =
        drawing.view.sampling.z_bits - std::min<std::size_t>(drawing.view.sampling.z_bits, lights + 1);
    all.push_back(request("marks", std::min(left, max_marks)));
    return all;
  }

  void light(const emit::EffectCall& call, emit::Broadcast& out, emit::Shadows& shadows) const override {
    const emit::Context& context = call.context;
    const auto field = [&](std::string_view name) { return context.layout.of("shadows", name); };
    shadows.spare = field("spare");
    const std::vector<ShadowLight>& lights = prepared(call).lights;
    for (std::size_t i = 0; i < lights.size(); ++i) {
      const Receivers receivers = find_receivers(context, lights[i].light);
      const ShadowParts found =
          find_touching_parts(lights[i].volumes, receivers, context.view.sampling.fraction_bits, context.options.work);
      if (found.parts.empty()) continue;
      emit::ShadowBit bit{lights[i].light, field(flag_name(i)), {}};
      emit_shadows(context, out, found.parts, bit.bit, field("marks"));
      for (const std::size_t one : found.touched)
        bit.facets.emplace_back(receivers.facets[one].primitive, receivers.facets[one].halfspace);
      shadows.bits.push_back(std::move(bit));
    }
  }

 private:
  void prepare(State& state, const emit::Drawing& drawing, const emit::DrawingInputs& inputs) const override {
    const State* const other = drawing.sampled_from != nullptr ? prepared_in(*drawing.sampled_from, inputs) : nullptr;
    state.cast_lights =
        other != nullptr
            ? other->cast_lights
            : std::make_shared<const std::vector<CastLight>>(cast_volumes(
                  casting_lights(settings, drawing.look.lighting), drawing, settings.casters, inputs.options.work));
    state.lights = volumes_in_view(drawing, *state.cast_lights);
  }
};

}  // namespace

extern const emit::EffectRow shadows{
    .section = scene::effect_section<Settings>("effects.shadows", "solids block the light of one another"),
    .technique =
        "shadow volumes (Crow 1977): for each convex piece of the model an intersection of half-spaces, which are "
        "compared with the visible depth, as in Fuchs et al. 1985 for polygons",
    .parts = emit::parts_of<CastShadows>,
    .needs_owners = true};

}  // namespace csgsim::effects
