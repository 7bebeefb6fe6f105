#include "sim/studies/classify/events.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "sim/software/draw.h"
#include "sim/software/rays/caster.h"

namespace csgsim::studies {

namespace {

using Json = nlohmann::ordered_json;

Json ray_json(std::size_t column, std::size_t row, std::span<const software::Event> events,
              const software::VisibleSurface& seen) {
  Json ray{{"pixel", {column, row}}, {"events", Json::array()}, {"seen", nullptr}};
  for (const software::Event& event : events)
    ray["events"].push_back(Json::array({event.depth, event.primitive(), event.leaves()}));
  if (seen.owner != software::VisibleSurface::nothing_seen) ray["seen"] = {seen.depth, seen.owner};
  return ray;
}

void put_rays(const Scene& scene, const JsonExport::Put& put) {
  const software::Tree tree = software::make_tree(scene.tree, software::Shape::balanced);
  const software::Subject subject{scene.tree, scene.geometry, scene.view, tree};
  const software::RayCaster rays(scene.tree, scene.geometry, scene.view);
  const std::unique_ptr<software::Method> method =
      software::make_method(software::choice_of("status/list-structure"), subject, false);
  software::RayBand band;
  std::vector<software::VisibleSurface> seen;
  for (std::uint32_t row = 0; row < rays.height(); row += software::band_rows) {
    rays.cast(row, band);
    seen.resize(band.rays());
    method->classify(band, seen);
    for (std::size_t ray = 0; ray < band.rays(); ++ray) {
      if (band.events_of(ray).empty()) continue;
      put(ray_json(ray % band.width, row + ray / band.width, band.events_of(ray), seen[ray]));
    }
  }
}

}  // namespace

void write_events(const JsonExport& json, std::span<const std::filesystem::path> inputs, const Scene& scene) {
  const auto facts = [&] {
    return Json{{"width", scene.view.sampling.width},
                {"height", scene.view.sampling.height},
                {"z_bits", scene.view.sampling.z_bits},
                {"primitives", scene.tree.primitives.size()}};
  };
  json.write(inputs, facts, "rays", [&](const JsonExport::Put& put) { put_rays(scene, put); });
}

}  // namespace csgsim::studies
