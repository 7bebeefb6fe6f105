#include "sim/report/page.h"

#include <utility>

namespace csgsim::report {

namespace {

std::string pointer_part(std::string key) {
  for (std::size_t at = 0; (at = key.find_first_of("~/", at)) != std::string::npos; at += 2)
    key.replace(at, 1, key[at] == '~' ? "~0" : "~1");
  return key;
}

}  // namespace

std::string child_pointer(const std::string& pointer, const std::string& key) {
  return pointer + "/" + pointer_part(key);
}

Cell cell(const Json& data, const std::string& at, Show show) {
  const Json::json_pointer pointer(at);
  return data.contains(pointer) ? Cell{data.at(pointer), at, show} : Cell{};
}

Cell share(const Json& part, double whole) {
  return part.is_number() ? Cell{whole == 0 ? 0.0 : part.get<double>() / whole, "", Show::share} : Cell{};
}

Json without_wall_times(Json data) {
  if (data.is_object()) {
    Json kept = Json::object();
    for (auto& [key, value] : data.items())
      if (!key.starts_with("wall_seconds")) kept[key] = without_wall_times(std::move(value));
    return kept;
  }
  if (data.is_array())
    for (Json& one : data) one = without_wall_times(std::move(one));
  return data;
}

}  // namespace csgsim::report
