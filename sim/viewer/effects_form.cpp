#include "sim/viewer/effects_form.h"

#include <string>

#include "host/effects/rows.h"
#include "host/scene/manual.h"

namespace csgsim::viewer {

using Json = nlohmann::ordered_json;

namespace {

Json key_json(const scene::KeyValue& one) {
  const scene::Key& key = one.key;
  Json json{{"name", key.name},
            {"allowed", scene::allowed_text(key)},
            {"unit", key.unit},
            {"usual", scene::value_text(one)},
            {"meaning", key.meaning}};
  if (key.kind == scene::ValueKind::boolean) json["choices"] = {"true", "false"};
  if (key.kind == scene::ValueKind::choice) json["choices"] = key.names;
  return json;
}

Json section_json(const scene::Section& section) {
  const std::string name(section.name.substr(section.name.find('.') + 1));
  Json json{{"name", name},
            {"meaning", section.meaning},
            {"key", std::string(section.name) + (section.is_list ? ".0" : "")},
            {"is_list", section.is_list},
            {"keys", Json::array()}};
  for (const scene::KeyValue& one : section.blank()) {
    // Colour tables can only be given in scene files.
    if (one.key.kind != scene::ValueKind::colour_table) json["keys"].push_back(key_json(one));
  }
  return json;
}

}  // namespace

Json effects_form() {
  Json form = Json::array();
  for (const scene::Section& section : effects::sections()) form.push_back(section_json(section));
  return form;
}

}  // namespace csgsim::viewer
