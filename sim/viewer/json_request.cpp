#include "sim/viewer/json_request.h"

#include <fmt/format.h>

namespace csgsim::viewer {

const Json& member_in(const Json& request, const char* key, Json::value_t type, const char* type_name) {
  static const Json nothing;
  const auto found = request.find(key);
  if (found == request.end() || found->is_null()) return nothing;
  if (found->type() != type) throw RequestError(fmt::format("{} must be {}", key, type_name));
  return *found;
}

std::string text_in(const Json& request, const char* key) {
  const Json& text = member_in(request, key, Json::value_t::string, "a string");
  return text.is_null() ? "" : text.get<std::string>();
}

std::vector<std::string> texts_in(const Json& request, const char* key) {
  std::vector<std::string> texts;
  for (const Json& one : member_in(request, key, Json::value_t::array, "an array of strings")) {
    if (!one.is_string()) throw RequestError(fmt::format("{} must be an array of strings", key));
    texts.push_back(one.get<std::string>());
  }
  return texts;
}

std::optional<std::uint64_t> number_in(const Json& request, const char* key) {
  const Json& number = member_in(request, key, Json::value_t::number_unsigned, "a number");
  return number.is_null() ? std::nullopt : std::optional(number.get<std::uint64_t>());
}

bool flag_in(const Json& request, const char* key) {
  const Json& flag = member_in(request, key, Json::value_t::boolean, "true or false");
  return flag.is_boolean() && flag.get<bool>();
}

Json object_in(const Json& request, const char* key) {
  const Json& object = member_in(request, key, Json::value_t::object, "an object");
  return object.is_null() ? Json::object() : object;
}

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace csgsim::viewer
