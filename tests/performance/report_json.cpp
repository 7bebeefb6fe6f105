#include <nlohmann/json.hpp>

#include "hw/base/text.h"
#include "tests/performance/report.h"

namespace csgsim::bench {

namespace {

using Json = nlohmann::ordered_json;

/// Adds the other build's seconds to a row.
void put_other(const Compared& compared, Json& json) {
  if (!compared.other) return;
  json["other_wall_seconds"] = compared.other->seconds;
  json["other_over_this"] = compared.other->ratio;
}

Json to_json(const Speed& speed) {
  Json json{{"model", printable(speed.model)},
            {"machine", printable(speed.machine)},
            {"level", speed.level},
            {"clocks", speed.clocks},
            {"simulated_seconds", speed.simulated},
            {"wall_seconds", speed.wall.seconds},
            {"simulated_over_wall", speed.ratio()},
            {"command", printable(speed.command)}};
  put_other(speed.wall, json);
  return json;
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
  for (const Point& point : growth.others) json["others"].push_back({{"size", point.x}, {"seconds", point.y}});
  if (const std::optional<double> power = exponent(growth.others)) json["other_exponent"] = *power;
  json["command_of_the_largest"] = printable(growth.command);
  return json;
}

Json to_json(const Count& count) {
  Json json{{"model", printable(count.model)}, {"machine", printable(count.machine)}};
  json.update(bench::to_json(count.work));
  json["command"] = printable(count.command);
  if (!count.reason.empty()) {
    json["not_counted"] = printable(count.reason);
    return json;
  }
  json["processor_instructions"] = count.instructions;
  if (count.others) json["other_processor_instructions"] = *count.others;
  return json;
}

Json seconds_by_threads(const std::vector<Point>& points) {
  Json json = Json::array();
  for (const Point& point : points) json.push_back({{"threads", point.x}, {"seconds", point.y}});
  return json;
}

Json to_json(const Schedule& schedule) {
  return {{"model", printable(schedule.model)},
          {"machine", printable(schedule.machine)},
          {"rest_seconds", schedule.rest},
          {"measured_two_seconds", schedule.measured_two},
          {"tiles", seconds_by_threads(schedule.tiles)},
          {"segments", seconds_by_threads(schedule.segments)}};
}

Json to_json(const Whole& whole) {
  Json json{
      {"name", whole.name}, {"what", whole.what}, {"wall_seconds", whole.wall.seconds}, {"memory_bytes", whole.memory}};
  put_other(whole.wall, json);
  if (whole.wall.other) json["other_memory_bytes"] = whole.other_memory;
  if (whole.halfspaces != 0) json["bytes_a_halfspace"] = whole.memory / whole.halfspaces;
  for (const std::string& command : whole.commands) json["commands"].push_back(printable(command));
  return json;
}

template <class Row>
Json list(const std::vector<Row>& rows) {
  Json json = Json::array();
  for (const Row& row : rows) json.push_back(to_json(row));
  return json;
}

}  // namespace

Json to_json(const ProgramWork& work) {
  return {{"segments", work.segments},
          {"stretches", work.stretches},
          {"tiles", work.tiles},
          {"instructions", work.work.instructions},
          {"linear", work.linear},
          {"words", work.work.words},
          {"lanes", work.work.lanes},
          {"steps", work.steps},
          {"open", work.open},
          {"longest", work.longest},
          {"longest_steps", work.longest_steps},
          {"longest_open", work.longest_open}};
}

Json to_json(const Results& results) {
  const Build& build = results.build;
  return {{"machine", {{"cpu", build.cpu}, {"cores", build.cores}, {"vectors", build.vectors}}},
          {"build", {{"commit", build.commit}, {"compiler", build.compiler}, {"flags", build.flags}}},
          {"other_build", results.other},
          {"size", results.settings.size},
          {"rounds", {{"most", results.settings.rounds.most}, {"seconds", results.settings.rounds.seconds}}},
          {"speed", list(results.speeds)},
          {"dense", list(results.dense)},
          {"rivals", list(results.rivals)},
          {"growth", list(results.growths)},
          {"counts", list(results.counts)},
          {"schedule", list(results.schedules)},
          {"works", list(results.works)}};
}

}  // namespace csgsim::bench
