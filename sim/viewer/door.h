// Access control of the page's server.
// Used by sim/app.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "sim/viewer/http.h"

// Only the page that csgsim itself has sent to a browser on this computer is admitted.
namespace csgsim::viewer {

/// 128 random bits in hexadecimal, the secret part of the page's address. Throws InputError if the system provides no
/// random numbers.
std::string make_token();

/// The port and the token of a server, which a request must name.
struct Door {
  std::uint16_t port = 0;
  std::string token;

  /// URL of the page.
  [[nodiscard]] std::string address() const;
};

/// Result of checking a request: the path behind the token (`draw` of `/TOKEN/draw`), or the reply that refuses it.
/// A request is refused if it has a foreign host name (DNS rebinding), comes from a page of another origin, has a wrong
/// token, or is a POST of anything but JSON.
struct Admission {
  bool is_admitted = false;
  std::string_view path{};  ///< path of the request behind the token
  Reply refusal{};
};

/// Checks the header of a request to the server behind the door.
Admission admit(const Door& door, const Request& request);

}  // namespace csgsim::viewer
