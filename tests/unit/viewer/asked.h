#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "sim/viewer/session.h"

namespace csgsim::testing {

struct Answer {
  int status = 0;
  viewer::Json json;
};

/// Returns the answer to a POST request of the page.
inline Answer ask(viewer::Session& session, std::string_view what, const viewer::Json& request) {
  const viewer::Reply reply = session.answer({.method = "POST", .body = request.dump()}, what);
  return {reply.status, viewer::Json::parse(reply.body)};
}

}  // namespace csgsim::testing
