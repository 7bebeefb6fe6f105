#include <nlohmann/json.hpp>

#include "hw/base/text.h"
#include "tests/performance/report.h"

namespace csgsim::bench {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Speed& speed) {
  return {{"model", printable(speed.model)},
          {"machine", printable(speed.machine)},
          {"level", speed.level},
          {"clocks", speed.clocks},
          {"simulated_seconds", speed.simulated},
          {"wall_seconds", speed.wall},
          {"simulated_over_wall", speed.ratio()},
          {"command", printable(speed.command)}};
}

Json to_json(const DensePair& pair) {
  return {{"model", printable(pair.model)},     {"clocks", pair.clocks},
          {"clocked_seconds", pair.clocked},    {"dense_seconds", pair.dense},
          {"clocked_over_dense", pair.ratio()}, {"command", printable(pair.command)}};
}

Json to_json(const Rival& rival) {
  Json json{{"model", printable(rival.model)}, {"command", printable(rival.command)}};
  if (!rival.reason.empty()) {
    json["not_measured"] = printable(rival.reason);
    return json;
  }
  json["seconds"] = rival.rival;
  json["csgsim_command"] = printable(rival.csgsim_command);
  json["csgsim_seconds"] = rival.csgsim;
  json["csgsim_over_other"] = rival.ratio();
  return json;
}

Json to_json(const Growth& growth) {
  Json json{{"against", growth.against}, {"part", growth.part}};
  if (const std::optional<double> power = growth.power()) json["exponent"] = *power;
  for (const Point& point : growth.points) json["points"].push_back({{"size", point.x}, {"seconds", point.y}});
  json["command_of_the_largest"] = printable(growth.command);
  return json;
}

template <class Row>
Json list(const std::vector<Row>& rows) {
  Json json = Json::array();
  for (const Row& row : rows) json.push_back(to_json(row));
  return json;
}

}  // namespace

Json to_json(const Results& results) {
  const Build& build = results.build;
  return {{"machine", {{"cpu", build.cpu}, {"cores", build.cores}, {"vectors", build.vectors}}},
          {"build", {{"commit", build.commit}, {"compiler", build.compiler}, {"flags", build.flags}}},
          {"size", results.settings.size},
          {"rounds", {{"most", results.settings.rounds.most}, {"seconds", results.settings.rounds.seconds}}},
          {"speed", list(results.speeds)},
          {"dense", list(results.dense)},
          {"rivals", list(results.rivals)},
          {"growth", list(results.growths)}};
}

}  // namespace csgsim::bench
