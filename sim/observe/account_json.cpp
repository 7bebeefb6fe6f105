#include "sim/observe/account_json.h"

#include <nlohmann/json.hpp>
#include <string>

namespace csgsim::observe {

nlohmann::ordered_json account_json(const machines::Account& account) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const machines::Count& count : account.counts) json[count.name] = count.value;
  for (const machines::Share& share : account.shares) json[std::string(share.name)] = share.value();
  nlohmann::ordered_json& parts = json["parts"] = nlohmann::ordered_json::object();
  for (const machines::PartAccount& part : account.parts) {
    for (const auto& [activity, clocks] : part.clocks) parts[part.part][std::string(activity)] = clocks;
  }
  return json;
}

}  // namespace csgsim::observe
