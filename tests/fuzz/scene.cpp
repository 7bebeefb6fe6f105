// Scene files, and settings of a scene on the command line: the first line, if it has no bracket before its `=`.

#include <cmath>
#include <string>
#include <vector>

#include "host/effects/rows.h"
#include "host/scene/read.h"
#include "tests/fuzz/property.h"

namespace effects = csgsim::effects;
namespace fuzz = csgsim::fuzz;
namespace scene = csgsim::scene;

namespace {

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool is_colour(const glm::dvec3& v) {
  return is_finite(v) && v.x >= 0 && v.x <= 1 && v.y >= 0 && v.y <= 1 && v.z >= 0 && v.z <= 1;
}

void check(const scene::Scene& read) {
  for (const scene::Light& light : read.lights) {
    fuzz::require(is_colour(light.colour), "a light's colour is valid");
    fuzz::require(is_finite(light.direction) && is_finite(light.position), "positions of lights are finite");
    fuzz::require(light.kind == scene::LightKind::point || light.direction != glm::dvec3(0),
                  "a light's direction is not zero");
  }
  for (const scene::MaterialRule& rule : read.materials) {
    fuzz::require(!rule.colour || is_colour(*rule.colour), "a material's colour is valid");
    fuzz::require(!rule.opacity || (*rule.opacity >= 0 && *rule.opacity <= 1), "opacity is from 0 to 1");
    fuzz::require(!rule.to_line || rule.from_line, "a range of lines has a beginning");
  }
}

}  // namespace

/// Any bytes give a scene that satisfies the schema or one line of error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const std::vector<scene::Section> sections = effects::sections();
  try {
    check(scene::read_scene(text, "fuzz.toml", {}, sections));
  } catch (const scene::SetError&) {
    fuzz::broken("reading a file throws no error of a setting");
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, "fuzz.toml");
  }
  const std::vector<std::string> sets{std::string(text.substr(0, text.find('\n')))};
  try {
    check(scene::read_scene("", "fuzz.toml", sets, sections));
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error);
  }
  return 0;
}
