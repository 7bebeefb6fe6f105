#include "sim/studies/rows_json.h"

#include <nlohmann/json.hpp>

namespace csgsim::studies {

void set_json(nlohmann::ordered_json& row, const char* name, std::uint64_t value) { row[name] = value; }
void set_json(nlohmann::ordered_json& row, const char* name, double value) { row[name] = value; }
void set_json(nlohmann::ordered_json& row, const char* name, const std::string& value) { row[name] = value; }
void set_json(nlohmann::ordered_json& row, const char* name, std::nullopt_t /*none*/) { row[name] = nullptr; }

nlohmann::ordered_json points_json(const std::string& title, std::size_t point_count, const SetPoint& set_point) {
  nlohmann::ordered_json json{{"study", title}, {"points", nlohmann::ordered_json::array()}};
  for (std::size_t i = 0; i < point_count; ++i)
    set_point(json["points"].emplace_back(nlohmann::ordered_json::object()), i);
  return json;
}

std::string points_json_text(const std::string& title, std::size_t point_count, const SetPoint& set_point) {
  return json_file_text(points_json(title, point_count, set_point));
}

std::string json_file_text(const nlohmann::ordered_json& json) { return json.dump(2) + "\n"; }

}  // namespace csgsim::studies
