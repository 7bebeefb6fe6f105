#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "sim/viewer/http.h"
#include "sim/viewer/server/request_reader.h"

namespace csgsim::viewer {

/// How long a connection may take for what it does.
struct ConnectionTimes {
  std::chrono::milliseconds request = std::chrono::seconds(10);  ///< from the answer before it, or the beginning
  std::chrono::milliseconds reply = std::chrono::seconds(60);    ///< until the client has taken it
  std::chrono::milliseconds leave = std::chrono::seconds(2);     ///< until the client of a last reply is gone
  std::chrono::milliseconds between_events{500};                 ///< of a page that stays open
};

/// How long to serve, and whom.
struct Serving {
  std::uint16_t port = 0;  ///< 0: any that is free
  RequestLimits limits{};
  ConnectionTimes times{};
  std::chrono::milliseconds patience{};       ///< after the last page was closed; none: without an end
  std::function<void(std::uint16_t)> begun;   ///< called with the port, before the first request
  RequestReader::Gate gate;                   ///< called with each header, before the body is read
  Handler handler;                            ///< of all requests that the gate admits
  std::function<bool(const Request&)> stays;  ///< whether a GET is a page's that stays open as long as the page is
  std::function<void()> tick;                 ///< called ten times a second
  std::function<void()> ending;  ///< called before the server waits for the requests that are being handled
};

/// The module of csgsim view: a shared library that is opened when a page is asked for, since a server takes long to
/// load. It is of the same build as what opens it.
struct Module {
  /// Serves 127.0.0.1 until there is nobody left. Returns why it could not, or nothing.
  std::string (*serve)(const Serving& serving);
};

inline constexpr const char* module_file = "csgsim_viewer.so";

/// Of the only symbol of the module, a Module. It changes with this file, so that another version's is not taken.
inline constexpr const char* module_symbol = "csgsim_viewer_3";

}  // namespace csgsim::viewer
