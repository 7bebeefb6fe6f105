// Access to members of the page's requests: JSON objects whose members are all optional.
// Used by drawings.h, evaluations.h and session.h.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace csgsim::viewer {

using Json = nlohmann::ordered_json;

/// Thrown for an invalid request: an error of the page, not of the user.
class RequestError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Each function throws RequestError for a member of another type.

/// Null if the member is missing.
const Json& member_in(const Json& request, const char* key, Json::value_t type, const char* type_name);

/// Empty if the member is missing.
std::string text_in(const Json& request, const char* key);
std::vector<std::string> texts_in(const Json& request, const char* key);

std::optional<std::uint64_t> number_in(const Json& request, const char* key);

/// False if the member is missing.
bool flag_in(const Json& request, const char* key);

/// Empty if the member is missing.
Json object_in(const Json& request, const char* key);

/// The JSON as text for a reply. Bytes that are not UTF-8 are replaced.
std::string text_of(const Json& json);

}  // namespace csgsim::viewer
