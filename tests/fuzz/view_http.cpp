// Bytes of a connection, as read by csgsim view: requests, one after another.

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/viewer/door.h"
#include "sim/viewer/server/request_reader.h"
#include "tests/fuzz/property.h"

namespace fuzz = csgsim::fuzz;
namespace viewer = csgsim::viewer;

namespace {

using State = viewer::RequestReader::State;

constexpr viewer::RequestLimits limits{.header_bytes = 512, .header_fields = 12, .body_bytes = 256};

const viewer::Door door{8080, "0123456789abcdef0123456789abcdef"};

/// The requests and errors from a connection's bytes.
struct Outcome {
  std::vector<viewer::Request> requests;
  int refusal = 0;

  bool operator==(const Outcome& other) const {
    const auto is_same = [](const viewer::Request& a, const viewer::Request& b) {
      return a.method == b.method && a.path == b.path && a.host == b.host && a.body == b.body;
    };
    return refusal == other.refusal &&
           std::equal(requests.begin(), requests.end(), other.requests.begin(), other.requests.end(), is_same);
  }
};

std::optional<viewer::Reply> gate(const viewer::Request& head) {
  fuzz::require(head.body.empty(), "a request is admitted before its body is read");
  viewer::Admission admission = viewer::admit(door, head);
  return admission.is_admitted ? std::nullopt : std::optional(std::move(admission.refusal));
}

void check(const viewer::Request& request) {
  fuzz::require(viewer::admit(door, request).is_admitted, "a received request was admitted");
  fuzz::require(request.body.size() <= limits.body_bytes, "a body is within its limit");
  fuzz::require(request.method == "GET" || request.method == "POST", "a request is a GET or a POST");
  fuzz::require(request.path.size() + request.host.size() <= limits.header_bytes, "a header is within its limit");
}

void check(const viewer::Reply& refusal) {
  fuzz::require(refusal.status >= 400 && refusal.status < 500, "an error answer has an error status");
  const nlohmann::json body = nlohmann::json::parse(refusal.body, nullptr, false);
  fuzz::require(body.is_object() && body.contains("error"), "an error answer is JSON with an error");
}

/// Reads bytes that arrive in pieces of equal size.
Outcome read(std::string_view bytes, std::size_t piece) {
  viewer::RequestReader reader(limits, gate);
  Outcome outcome;
  for (std::size_t at = 0; at < bytes.size() && reader.state() != State::refused; at += piece) {
    reader.put(bytes.substr(at, piece));
    while (reader.state() == State::whole) {
      check(reader.request());
      outcome.requests.push_back(reader.request());
      reader.next();
    }
  }
  if (reader.state() != State::refused) return outcome;
  check(reader.refusal());
  outcome.refusal = reader.refusal().status;
  return outcome;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzz::text_of(data, size);
  fuzz::require(read(bytes, 1) == read(bytes, std::max<std::size_t>(size, 1)),
                "requests do not depend on how their bytes arrive");
  return 0;
}
