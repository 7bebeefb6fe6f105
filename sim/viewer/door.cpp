#include "sim/viewer/door.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <array>

#include "hw/base/error.h"

namespace csgsim::viewer {

namespace {

/// Compares in constant time, so that timing does not reveal how much of the token matches.
bool is_token(std::string_view text, std::string_view token) {
  if (text.size() != token.size()) return false;
  unsigned differences = 0;
  for (std::size_t i = 0; i < text.size(); ++i)
    differences |= static_cast<unsigned>(static_cast<unsigned char>(text[i]) ^ static_cast<unsigned char>(token[i]));
  return differences == 0;
}

Admission refused(int status, std::string_view why) { return {false, {}, error_reply(status, why)}; }

/// Whether the host is `127.0.0.1:PORT` or `localhost:PORT`.
bool is_own_host(const Door& door, std::string_view host) {
  return host == fmt::format("127.0.0.1:{}", door.port) || host == fmt::format("localhost:{}", door.port);
}

bool is_own_origin(const Door& door, std::string_view origin) {
  constexpr std::string_view scheme = "http://";
  return origin.starts_with(scheme) && is_own_host(door, origin.substr(scheme.size()));
}

bool is_json(std::string_view type) { return type.substr(0, type.find(';')) == "application/json"; }

}  // namespace

std::string make_token() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw InputError("the system provides no random numbers for the address of the page");
  std::string text;
  for (const unsigned char byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

std::string Door::address() const { return fmt::format("http://127.0.0.1:{}/{}/", port, token); }

Admission admit(const Door& door, const Request& request) {
  if (!is_own_host(door, request.host))
    return refused(403, "csgsim view only accepts requests to 127.0.0.1 and localhost");
  const bool is_post = request.method == "POST";
  if (!request.origin.empty() ? !is_own_origin(door, request.origin) : is_post)
    return refused(403, "csgsim view only accepts requests from its own page");
  if (!request.site.empty() && request.site != "same-origin" && (is_post || request.site != "none"))
    return refused(403, "csgsim view only accepts requests from its own page");
  const std::string_view path = request.path;
  const std::size_t end = path.find('/', 1);
  if (path.empty() || path.front() != '/' || end == path.npos || !is_token(path.substr(1, end - 1), door.token))
    return refused(403, "csgsim view requires the complete address that it printed");
  if (is_post && !is_json(request.content_type)) return refused(415, "csgsim view only accepts application/json");
  return {true, path.substr(end + 1), {}};
}

}  // namespace csgsim::viewer
