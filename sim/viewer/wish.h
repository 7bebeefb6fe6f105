#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

/// What the page asks for: members of a JSON object, none of which has to be there.
namespace csgsim::viewer {

using Json = nlohmann::ordered_json;

/// What the page may not ask for.
class WishError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Each throws WishError for a member of another type.

/// Null if it is not there.
const Json& member_in(const Json& wish, const char* key, Json::value_t type, const char* type_name);

/// Empty if it is not there.
std::string text_in(const Json& wish, const char* key);
std::vector<std::string> texts_in(const Json& wish, const char* key);

std::optional<std::uint64_t> number_in(const Json& wish, const char* key);

/// False if it is not there.
bool flag_in(const Json& wish, const char* key);

/// An object, empty if it is not there.
Json object_in(const Json& wish, const char* key);

/// The text that is sent for it. Bytes that are not UTF-8 are replaced.
std::string text_of(const Json& json);

}  // namespace csgsim::viewer
