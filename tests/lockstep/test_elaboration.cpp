#include <systemc>

#include "host/effects/rows.h"
#include "host/scene/read.h"
#include "hw/kinds/load.h"
#include "sim/engine/engine.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

void add_modules(const std::vector<sc_core::sc_object*>& objects, std::vector<std::string>& names) {
  for (const sc_core::sc_object* const object : objects) {
    if (dynamic_cast<const sc_core::sc_module*>(object) == nullptr) continue;
    names.emplace_back(object->name());
    add_modules(object->get_child_objects(), names);
  }
}

/// The names of the SystemC modules of this process.
std::vector<std::string> modules() {
  std::vector<std::string> names;
  add_modules(sc_core::sc_get_top_level_objects(), names);
  std::sort(names.begin(), names.end());
  return names;
}

isa::Program program_of(const std::string& scene) {
  testing::Setup setup;
  setup.machine = "pixel-planes-4";
  setup.sampling.width = 32;
  setup.sampling.height = 24;
  setup.options.effects = effects::all();
  setup.options.scene = scene::read_scene(scene, "scene", {}, effects::sections());
  return testing::compile_default_view(testing::model_path("old_example002"), setup, view::Projection::orthographic)
      .program;
}

}  // namespace

TEST_CASE("effects run on the same SystemC modules as Programs without effects") {
  machines::Machine machine = kinds::load("pixel-planes-4");
  machines::set_picture_size(machine, {32, 24});
  const auto engine = engine::make_cycle_engine(machine);
  engine->run(program_of(""), {});
  const std::vector<std::string> before = modules();
  MESSAGE(before.size(), " modules");
  for (const std::string& name : before) {
    INFO(name);
    for (const scene::Section& effect : effects::sections())
      CHECK(name.find(std::string(effect.name.substr(8))) == std::string::npos);
  }
  CHECK_FALSE(before.empty());
  engine->run(program_of("[effects.smooth]\n"), {});
  CHECK(modules() == before);
}
