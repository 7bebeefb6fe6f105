#include "sim/session/run/recorded_bytes.h"

#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>

#include "hw/base/error.h"
#include "hw/base/hash.h"
#include "hw/base/input_file.h"
#include "hw/base/text.h"

namespace csgsim::session {

namespace {

using Json = nlohmann::ordered_json;

/// Unlimited: the file was read before, within the limits of its kind.
constexpr InputKind input_again{"a file", std::numeric_limits<std::size_t>::max(), ""};

}  // namespace

Json bytes_json(const std::string& bytes) {
  if (printable(bytes) == bytes) return bytes;
  std::string digits;
  for (const char byte : bytes) digits += fmt::format("{:02x}", static_cast<unsigned char>(byte));
  return {{"hex", digits}};
}

std::string bytes_from_json(const Json& json) {
  if (json.is_string()) return json.get<std::string>();
  const bool has_digits = json.is_object() && json.contains("hex") && json["hex"].is_string();
  const std::string digits = has_digits ? json["hex"].get<std::string>() : "";
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    unsigned byte = 0;
    const auto [end, error] = std::from_chars(digits.data() + i, digits.data() + i + 2, byte, 16);
    if (error != std::errc() || end != digits.data() + i + 2) break;
    bytes += static_cast<char>(byte);
  }
  if (!has_digits || bytes.size() * 2 != digits.size()) throw InputError("neither a text nor bytes in hexadecimal");
  return bytes;
}

Json hash_of_file(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) return nullptr;
  Hash hash;
  hash.add(read_file(file, input_again));
  return hash.text();
}

}  // namespace csgsim::session
