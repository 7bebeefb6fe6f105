#include <nlohmann/json.hpp>

#include "sim/study/advice.h"

namespace csgsim::study {

namespace {

using Json = nlohmann::ordered_json;

template <class Part>
void add_members(Json& json, const Part& part) {
  visit_columns(part, [&](const char* name, const auto& member) { json[name] = member; });
}

/// Where there is no Program, only the point and why.
Json to_json(const AdviceRow& row) {
  Json json;
  if (row.compiled()) {
    add_members(json, row);
    json.erase("reason");
    return json;
  }
  add_members(json, row.point);
  add_members(json, row.inputs);
  json["reason"] = row.reason;
  return json;
}

Json rows_json(std::span<const AdviceRow> rows) {
  Json json = Json::array();
  for (const AdviceRow& row : rows) json.push_back(to_json(row));
  return json;
}

}  // namespace

std::string advice_json(const std::string& title, const Wishes& wishes, std::span<const AdviceRow> rows,
                        const Advice& advice) {
  Json recommended = Json::array();
  for (std::size_t i = 0; i < advice.recommendations.size(); ++i) {
    const Recommendation& one = advice.recommendations[i];
    recommended.push_back({{"what", recommendation_name(one.wish)},
                           {"missed_by", one.miss},
                           {"meets_all", one.miss == 0},
                           {"command", advice.commands[i]},
                           {"point", to_json(one.row)}});
  }
  Json json{{"study", title},
            {"wishes",
             {{"max_bits", wishes.max_bits},
              {"max_wrong_pixels", wishes.max_wrong_pixels},
              {"min_fps", wishes.min_fps},
              {"min_colour_bits", wishes.min_colour_bits}}},
            {"meets_all", !advice.nearest},
            {"recommendations", recommended}};
  if (advice.nearest) json["nearest"] = {{"command", advice.nearest_command}, {"point", to_json(*advice.nearest)}};
  json["front"] = rows_json(advice_front(rows));
  json["points"] = rows_json(rows);
  return json.dump(2) + "\n";
}

}  // namespace csgsim::study
