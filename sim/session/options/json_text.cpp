#include "sim/session/options/json_text.h"

#include <fmt/format.h>

namespace csgsim::session {

nlohmann::ordered_json parse_json(std::string_view text, const JsonLimits& limits) {
  using Json = nlohmann::ordered_json;
  std::size_t values = 0;
  return Json::parse(text, [&](int depth, Json::parse_event_t event, const Json& /*parsed*/) {
    const bool is_start = event == Json::parse_event_t::object_start || event == Json::parse_event_t::array_start;
    // The depth of a bracket is that of the value that contains it.
    if (is_start && depth >= limits.depth)
      throw JsonLimitError(fmt::format("brackets are nested deeper than {}", limits.depth));
    const bool is_end = event == Json::parse_event_t::object_end || event == Json::parse_event_t::array_end;
    if (!is_end && ++values > limits.values)
      throw JsonLimitError(fmt::format("it has more than {} values", limits.values));
    return true;
  });
}

}  // namespace csgsim::session
