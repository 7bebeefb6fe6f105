#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace csgsim::report {

/// JSON as the content of a script element that no script runs: nothing in it ends the element or begins a comment.
std::string json_in_html(const nlohmann::ordered_json& json);

/// A word for an element's id: letters, digits and dashes.
std::string html_id(std::string_view text);

}  // namespace csgsim::report
