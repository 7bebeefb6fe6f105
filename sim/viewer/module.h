// Interface of the server module.
// Used by serve.h and server.h.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "sim/viewer/http.h"
#include "sim/viewer/server/request_reader.h"

namespace csgsim::viewer {

/// Time limits of a connection.
struct ConnectionTimes {
  std::chrono::milliseconds request = std::chrono::seconds(10);  ///< time for a request, from the previous reply or
                                                                 ///< from the beginning of the connection
  std::chrono::milliseconds reply = std::chrono::seconds(60);    ///< time for the client to receive the reply
  std::chrono::milliseconds leave = std::chrono::seconds(2);     ///< time for the client to close after a last reply
  std::chrono::milliseconds between_events{500};                 ///< between events to an open page
};

/// Parameters and callbacks of the server.
struct Serving {
  std::uint16_t port = 0;  ///< 0: any free port
  RequestLimits limits{};
  ConnectionTimes times{};
  std::chrono::milliseconds patience{};       ///< running time after the last page is closed; 0: unlimited
  std::function<void(std::uint16_t)> begun;   ///< called with the port, before the first request
  RequestReader::Gate gate;                   ///< called with each header, before the body is read
  Handler handler;                            ///< answers all requests that the gate admits
  std::function<bool(const Request&)> stays;  ///< whether a GET is the event stream that an open page keeps
  std::function<void()> tick;                 ///< called ten times per second
  std::function<void()> ending;               ///< called before the server waits for the requests in progress
};

/// The module of csgsim view: a shared library that is opened on demand, since a server takes long to load. It comes
/// from the same build as the program that opens it.
struct Module {
  /// Serves 127.0.0.1 until the last page is closed. Returns an error message, or an empty string.
  std::string (*serve)(const Serving& serving);
};

inline constexpr const char* module_file = "csgsim_viewer.so";

/// Name of the only symbol of the module, a Module. It changes with this file, so that a module of another version is
/// not accepted.
inline constexpr const char* module_symbol = "csgsim_viewer_3";

}  // namespace csgsim::viewer
