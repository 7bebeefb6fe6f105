#include <nlohmann/json.hpp>

#include "sim/studies/advise/advice.h"
#include "sim/studies/rows_json.h"

namespace csgsim::studies {

namespace {

using Json = nlohmann::ordered_json;

Json choice_json(const AdviceRow& row) {
  Json json;
  set_columns(json, row);
  if (row.compiled()) json.erase("reason");
  return json;
}

Json choices_json(std::span<const AdviceRow> rows) {
  Json json = Json::array();
  for (const AdviceRow& row : rows) json.push_back(choice_json(row));
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
                           {"point", choice_json(one.row)}});
  }
  Json json{{"study", title},
            {"wishes",
             {{"max_bits", wishes.max_bits},
              {"max_wrong_pixels", wishes.max_wrong_pixels},
              {"min_fps", wishes.min_fps},
              {"min_colour_bits", wishes.min_colour_bits}}},
            {"meets_all", !advice.nearest},
            {"recommendations", recommended}};
  if (advice.nearest) json["nearest"] = {{"command", advice.nearest_command}, {"point", choice_json(*advice.nearest)}};
  json["front"] = choices_json(advice_front(rows));
  json["points"] = choices_json(rows);
  return file_text(json);
}

}  // namespace csgsim::studies
