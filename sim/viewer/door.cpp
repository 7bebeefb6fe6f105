#include "sim/viewer/door.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <array>

#include "hw/base/error.h"

namespace csgsim::viewer {

namespace {

/// In a time that does not tell how much of it is right.
bool is_token(std::string_view text, std::string_view token) {
  if (text.size() != token.size()) return false;
  unsigned differences = 0;
  for (std::size_t i = 0; i < text.size(); ++i)
    differences |= static_cast<unsigned>(static_cast<unsigned char>(text[i]) ^ static_cast<unsigned char>(token[i]));
  return differences == 0;
}

Admission refused(int status, std::string_view why) { return {false, {}, error_reply(status, why)}; }

/// `127.0.0.1:PORT`, or by the name that only this computer has.
bool is_own(const Door& door, std::string_view host) {
  return host == fmt::format("127.0.0.1:{}", door.port) || host == fmt::format("localhost:{}", door.port);
}

bool is_own_origin(const Door& door, std::string_view origin) {
  constexpr std::string_view scheme = "http://";
  return origin.starts_with(scheme) && is_own(door, origin.substr(scheme.size()));
}

bool is_json(std::string_view type) { return type.substr(0, type.find(';')) == "application/json"; }

}  // namespace

std::string make_token() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw InputError("the system gives no random numbers for the address of the page");
  std::string text;
  for (const unsigned char byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

std::string Door::address() const { return fmt::format("http://127.0.0.1:{}/{}/", port, token); }

Admission admit(const Door& door, const Request& request) {
  if (!is_own(door, request.host)) return refused(403, "csgsim view answers 127.0.0.1 and localhost alone");
  const bool is_post = request.method == "POST";
  if (!request.origin.empty() ? !is_own_origin(door, request.origin) : is_post)
    return refused(403, "csgsim view answers its own page alone");
  if (!request.site.empty() && request.site != "same-origin" && (is_post || request.site != "none"))
    return refused(403, "csgsim view answers its own page alone");
  const std::string_view path = request.path;
  const std::size_t end = path.find('/', 1);
  if (path.empty() || path.front() != '/' || end == path.npos || !is_token(path.substr(1, end - 1), door.token))
    return refused(403, "csgsim view asks for the whole address that it printed");
  if (is_post && !is_json(request.content_type)) return refused(415, "csgsim view takes application/json");
  return {true, path.substr(end + 1), {}};
}

}  // namespace csgsim::viewer
