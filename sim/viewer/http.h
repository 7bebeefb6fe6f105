#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace csgsim::viewer {

/// What a browser asks for. Headers that are not there are empty.
struct Request {
  std::string method{};
  std::string path{};
  std::string host{};          ///< header Host
  std::string origin{};        ///< header Origin
  std::string site{};          ///< header Sec-Fetch-Site
  std::string content_type{};  ///< of the body
  std::string body{};
};

struct Reply {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string body{};
  bool has_scripts = false;  ///< a page with its style and script in it, which asks for nothing else
};

/// A JSON object with the message as its `error`. The message is printable and has no quotes or backslashes.
inline Reply error_reply(int status, std::string_view message) {
  return {.status = status, .type = "application/json", .body = "{\"error\":\"" + std::string(message) + "\"}\n"};
}

/// Called on one of several threads.
using Handler = std::function<Reply(const Request&)>;

}  // namespace csgsim::viewer
