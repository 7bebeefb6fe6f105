#include "sim/session/run/configuration.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numbers>
#include <system_error>
#include <variant>

#include "hw/isa/facts.h"
#include "hw/machines/hash.h"
#include "hw/machines/kind.h"
#include "hw/machines/schema.h"
#include "sim/observe/frame_hash.h"
#include "sim/session/options/version.h"
#include "sim/session/run/recorded_bytes.h"

namespace csgsim::session {

namespace {

using Json = nlohmann::ordered_json;

template <class Number>
Json number_json(const std::string& text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return bytes_json(text);
  return number;
}

Json value_json(const OptionValue& option) {
  if (option.takes == Takes::flag) return !option.values.empty() && option.values.front() != "false";
  if (option.takes == Takes::texts) {
    Json values = Json::array();
    for (const std::string& value : option.values) values.push_back(bytes_json(value));
    return values;
  }
  if (option.values.empty()) return nullptr;
  const std::string& value = option.values.front();
  if (option.takes == Takes::whole_number) return number_json<std::uint64_t>(value);
  if (option.takes == Takes::number) return number_json<double>(value);
  return bytes_json(value);
}

Json command_json(const std::vector<std::string>& arguments) {
  Json words = Json::array({"csgsim"});
  for (std::size_t i = 1; i < arguments.size(); ++i) words.push_back(bytes_json(arguments[i]));
  return words;
}

Json vector_json(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

Json camera_json(const RunSubject& subject) {
  const isa::DepthScale& depth = subject.program.facts->depth_scale;
  Json json;
  if (subject.camera != nullptr) {
    json["eye"] = vector_json(subject.camera->eye);
    json["centre"] = vector_json(subject.camera->centre);
    json["field_of_view"] = 2.0 * std::atan(view::half_height_per_distance()) * 180.0 / std::numbers::pi;
    if (!depth.perspective) json["half_height"] = view::half_height(*subject.camera);
  }
  json["projection"] = depth.perspective ? "perspective" : "ortho";
  json["near"] = depth.near;
  json["far"] = depth.far;
  return json;
}

struct SceneValue {
  const scene::Key& key;

  Json operator()(bool value) const { return value; }
  Json operator()(std::int64_t value) const {
    if (key.kind != scene::ValueKind::choice) return value;
    return key.names[static_cast<std::size_t>(value)];
  }
  Json operator()(double value) const { return value; }
  Json operator()(const glm::dvec3& value) const { return vector_json(value); }
  Json operator()(const scene::ColourTable& table) const {
    Json rows = Json::array();
    for (const std::vector<glm::dvec3>& row : table) {
      Json& colours = rows.emplace_back(Json::array());
      for (const glm::dvec3& colour : row) colours.push_back(vector_json(colour));
    }
    return rows;
  }
};

/// Sections by name; the sections of a list form an array.
Json scene_json(const std::vector<scene::SectionValues>& sections) {
  Json json = Json::object();
  for (const scene::SectionValues& section : sections) {
    Json keys = Json::object();
    for (const auto& [key, value] : section.values)
      keys[std::string(key.name)] = value ? std::visit(SceneValue{key}, *value) : Json();
    Json& place = json[std::string(section.name)];
    if (section.is_list_entry) {
      place.push_back(std::move(keys));
    } else {
      place = std::move(keys);
    }
  }
  return json;
}

Json inputs_json(const RunSubject& subject) {
  Json inputs = Json::array();
  std::vector<std::filesystem::path> known;
  for (const std::filesystem::path& file : subject.inputs) {
    if (std::ranges::find(known, file) != known.end()) continue;
    const bool is_read = !subject.is_in_place || !known.empty();
    known.push_back(file);
    inputs.push_back(
        {{"file", bytes_json(file.native())}, {"hash", is_read ? hash_of_file(file) : Json(subject.hash)}});
  }
  return inputs;
}

}  // namespace

Json machine_json(const machines::Machine& machine) {
  Json figures = Json::object();
  for (const machines::Figure& figure : machine.figures) {
    const std::string value = machines::used_value(figure, machine);
    Json entry{{"value", number_json<std::int64_t>(value)}};
    if (!figure.unit.empty()) entry["unit"] = figure.unit;
    entry["provenance"] = value == figure.value ? figure.provenance : "assumed";
    figures[figure.key] = std::move(entry);
  }
  return {{"name", machine.name}, {"hash", machines::hash_of(machine)}, {"figures", std::move(figures)}};
}

Json configuration_of(const OptionList& options, const RunSubject& subject) {
  Json values = Json::object();
  for (const OptionValue& option : options.values()) values[option.name] = value_json(option);
  Json configuration{{"command", command_json(options.arguments())},
                     {"options", std::move(values)},
                     {"version", version_and_build()},
                     {"machine", machine_json(subject.machine)},
                     {"camera", camera_json(subject)}};
  if (subject.scene != nullptr) configuration["scene"] = scene_json(*subject.scene);
  Json inputs = inputs_json(subject);
  configuration["model"] = inputs.at(0);
  if (!subject.hash.empty()) configuration["model"]["hash"] = subject.hash;
  configuration["inputs"] = std::move(inputs);
  return configuration;
}

void insert_configuration(Json& stats, Json configuration, const observe::Frame& picture) {
  configuration["picture"] = {{"hash", observe::hash_of(picture)}};
  const Json wall = stats["wall_seconds"];
  stats.erase("wall_seconds");
  stats["configuration"] = std::move(configuration);
  stats["wall_seconds"] = wall;
}

}  // namespace csgsim::session
