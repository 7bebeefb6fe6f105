#include "sim/studies/trace/directory_json.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

namespace csgsim::studies {

namespace {

using Json = nlohmann::ordered_json;

Json place_json(const glm::dvec3& place) { return Json::array({place.x, place.y, place.z}); }

Json facets_json(const software::TraceScene& scene) {
  const glm::dvec3 centre = scene.geometry().planes.centre();
  Json facets = Json::array();
  for (std::uint32_t i = 0; i < scene.facets().facets.size(); ++i) {
    Json corners = Json::array();
    for (const glm::dvec3& corner : scene.facets().corners_of(i)) corners.push_back(place_json(corner + centre));
    facets.push_back({{"primitive", scene.facets().facets[i].primitive}, {"corners", std::move(corners)}});
  }
  return facets;
}

Json part_json(const software::SpacePart& part, const glm::dvec3& centre) {
  Json json{{"box", {place_json(part.box.low + centre), place_json(part.box.high + centre)}}};
  if (part.is_cell()) {
    json["facets"] = std::vector<std::uint32_t>(part.facets.begin(), part.facets.end());
  } else {
    json["axis"] = part.axis;
    json["wall"] = part.wall + centre[part.axis];
    json["low"] = part.low;
    json["high"] = part.high;
  }
  return json;
}

}  // namespace

void write_directory_json(const JsonExport& json, std::span<const std::filesystem::path> inputs,
                          const TraceSubject& subject, const std::string& directory_name, std::uint32_t bucket_size) {
  const software::TraceScene& scene = subject.scene();
  const std::unique_ptr<software::Directory> made =
      software::directory_of(directory_name).make(scene.shapes(), {bucket_size});
  const auto facts = [&] {
    return Json{{"directory", directory_name},
                {"bucket_size", bucket_size},
                {"reach", scene.shapes().reach()},
                {"facets", facets_json(scene)}};
  };
  json.write(inputs, facts, "parts", [&](const JsonExport::Put& put) {
    for (const software::SpacePart& part : made->parts()) put(part_json(part, scene.geometry().planes.centre()));
  });
}

}  // namespace csgsim::studies
