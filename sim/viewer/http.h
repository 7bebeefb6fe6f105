// HTTP requests and replies.
// Used by sim/viewer.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace csgsim::viewer {

/// An HTTP request. Missing headers are empty.
struct Request {
  std::string method{};
  std::string path{};
  std::string host{};          ///< header Host
  std::string origin{};        ///< header Origin
  std::string site{};          ///< header Sec-Fetch-Site
  std::string content_type{};  ///< header Content-Type
  std::string body{};
};

struct Reply {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string body{};
  bool has_scripts = false;  ///< a self-contained page with inline style and script, which loads nothing else
};

/// A JSON object with the message as `error`. The message must be printable, without quotes and backslashes.
inline Reply error_reply(int status, std::string_view message) {
  return {.status = status, .type = "application/json", .body = "{\"error\":\"" + std::string(message) + "\"}\n"};
}

/// Called on one of several threads.
using Handler = std::function<Reply(const Request&)>;

}  // namespace csgsim::viewer
