// POST requests of csgsim view's page: a line with the question's name, followed by its JSON parameters.

#include <algorithm>
#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "sim/session/options/json_text.h"
#include "sim/viewer/session.h"
#include "tests/fuzz/property.h"
#include "tests/fuzz/scratch_file.h"

namespace fuzz = csgsim::fuzz;
namespace viewer = csgsim::viewer;
using viewer::Json;

namespace {

constexpr std::string_view model = R"(difference() { cube(size = [6, 6, 4], center = true);
  sphere($fn = 8, r = 3); cylinder($fn = 6, h = 9, r1 = 1, r2 = 1, center = true); }
)";

constexpr std::string_view first_request = R"({"knobs":{"size":"8x6","camera":"30,-40,25,0,0,2"}})";

std::string recorder(const csgsim::isa::Program& /*program*/, std::span<const std::string> /*options*/) {
  throw csgsim::InputError("this session records no waves");
}

/// A session with small pictures, so that a mutation takes a fraction of a second.
viewer::Session& session() {
  static const fuzz::ScratchFolder folder;
  static const std::string file = [] {
    const std::string name = folder.path() / "model.csg";
    fuzz::write_scratch(name, model);
    return name;
  }();
  static viewer::Session one({file, {"--limit", "2"}, Json::object()}, {.recorder = recorder});
  return one;
}

/// Limits the picture size in the request, at any place. The JSON depth is bounded.
void make_small(Json& request) {
  constexpr std::size_t longest_size = 5;
  if (request.is_object() && request.contains("knobs") && request["knobs"].is_object()) {
    Json& size = request["knobs"]["size"];
    if (size.is_null() || (size.is_string() && size.get_ref<const std::string&>().size() > longest_size)) size = "8x6";
  } else if (request.is_object()) {
    request["knobs"] = {{"size", "8x6"}};
  }
  for (const char* const member : {"a", "b"}) {
    if (request.is_object() && request.contains(member)) make_small(request[member]);
  }
}

/// Malformed requests stay unchanged.
std::string made_small(std::string body) {
  try {
    Json request = csgsim::session::parse_json(body, {.depth = 16});
    make_small(request);
    return viewer::text_of(request);
  } catch (const Json::exception&) {
    return body;
  } catch (const csgsim::InputError&) {
    return body;
  }
}

viewer::Reply ask(std::string_view question, std::string body) {
  return session().answer({.method = "POST", .body = std::move(body)}, question);
}

void check(const viewer::Reply& reply) {
  constexpr std::array known{200, 400, 404, 422};
  fuzz::require(std::ranges::find(known, reply.status) != known.end(), "an answer has one of the known statuses");
  if (reply.status == 404) return;
  const Json body = Json::parse(reply.body, nullptr, false);
  fuzz::require(body.is_object(), "an answer is a JSON object");
  fuzz::require(reply.status == 200 || (body.contains("error") && body["error"].is_string()),
                "an error answer states the reason");
}

/// Checks that the first picture does not depend on earlier requests.
void check_first_picture() {
  static const std::string expected = Json::parse(ask("draw", std::string(first_request)).body).at("picture");
  fuzz::require(Json::parse(ask("draw", std::string(first_request)).body).at("picture") == expected,
                "a request always gets the same answer");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static unsigned count = 0;
  constexpr unsigned now_and_then = 64;
  if (count++ % now_and_then == 0) check_first_picture();
  const std::string_view text = fuzz::text_of(data, size);
  const std::size_t end = std::min(text.find('\n'), text.size());
  check(ask(text.substr(0, end), made_small(std::string(text.substr(std::min(end + 1, text.size()))))));
  return 0;
}
