#include "host/effects/rows.h"
#include "host/scene/read.h"
#include "hw/isa/binary.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

/// A scene that lists every effect and disables each of them.
std::string all_off() {
  std::string text;
  for (const scene::Section& section : effects::sections()) {
    if (section.name == "effects.flat") continue;
    text +=
        (section.is_list ? "[[" : "[") + std::string(section.name) + (section.is_list ? "]]" : "]") + "\non = false\n";
    if (section.name == "effects.cuts") text += "normal = [1, 0, 0]\n";
  }
  return text;
}

testing::Setup setup_of(const std::string& machine) {
  testing::Setup setup;
  setup.machine = machine;
  return setup;
}

std::vector<std::byte> bytes_of(const std::string& model, const testing::Setup& setup) {
  return isa::encode(
      testing::compile_default_view(testing::model_path(model), setup, view::Projection::orthographic).program);
}

}  // namespace

TEST_CASE("scenes without effects or with all disabled compile to the same Program") {
  for (const char* machine : {"pixel-planes-4", "scan-line", "pixel-square", "pixel-square+divider.kind=host"}) {
    for (const char* model : {"thesis_fig_2_3", "old_example002"}) {
      CAPTURE(machine);
      CAPTURE(model);
      testing::Setup setup = setup_of(machine);
      const std::vector<std::byte> no_effects = bytes_of(model, setup);
      setup.options.effects = effects::all();
      CHECK(bytes_of(model, setup) == no_effects);
      setup.options.scene = scene::read_scene(all_off(), "off.toml", {}, effects::sections());
      CHECK_FALSE(setup.options.scene.effects.empty());
      CHECK(bytes_of(model, setup) == no_effects);
      setup.options.scene = scene::read_scene("[effects.smooth]\n", "on.toml", {}, effects::sections());
      if (setup.machine != "pixel-square") CHECK(bytes_of(model, setup) != no_effects);
    }
  }
}
