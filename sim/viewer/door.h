#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "sim/viewer/http.h"

/// Who is let in: the page that csgsim itself has sent to a browser of this computer, and nobody else.
namespace csgsim::viewer {

/// 128 random bits in hexadecimal digits: whoever knows the address of the page may ask. Throws InputError where
/// the system has none to give.
std::string make_token();

struct Door {
  std::uint16_t port = 0;
  std::string token;

  /// Where the page is.
  [[nodiscard]] std::string address() const;
};

/// Where a request is let in, its path behind the token (`draw` of `/TOKEN/draw`); else the answer that refuses it. A
/// name that is not this computer's (DNS rebinding), a page of another origin, a wrong token and anything but JSON in a
/// POST are refused.
struct Admission {
  bool is_admitted = false;
  std::string_view path{};  ///< of the request
  Reply refusal{};
};

Admission admit(const Door& door, const Request& request);

}  // namespace csgsim::viewer
