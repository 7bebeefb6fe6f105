// Interface to the page. Texts are passed through one input and one output buffer: the page requests room, writes,
// calls, and reads.
#include "sim/viewer/session.h"

#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "sim/session/options/json_text.h"
#include "sim/web/wasm/files.h"

namespace csgsim::web {

namespace {

std::string input;
std::string output;
std::unique_ptr<viewer::Session> session;

/// Splits the input at `length`.
std::pair<std::string, std::string> split_input(std::size_t length) {
  return {input.substr(0, length), input.substr(length)};
}

int store_answer(const std::string& path, std::string body) {
  if (!session) throw viewer::RequestError("no model has been opened");
  const bool is_got = path == "about" || path == "report";
  viewer::Reply reply = session->answer({.method = is_got ? "GET" : "POST", .body = std::move(body)}, path);
  output = std::move(reply.body);
  return reply.status;
}

template <class Work>
int status_of(const Work& work) noexcept {
  try {
    return work();
  } catch (const std::exception& error) {
    output = viewer::Json{{"error", error.what()}}.dump(-1, ' ', false, viewer::Json::error_handler_t::replace);
    return 422;
  }
}

}  // namespace

}  // namespace csgsim::web

extern "C" {

using csgsim::web::input;
using csgsim::web::output;

/// Allocates an input of this size.
char* csgsim_input(std::size_t size) {
  input.assign(size, '\0');
  return input.data();
}

/// The last answer and its size.
const char* csgsim_output() { return output.data(); }
std::size_t csgsim_output_size() { return output.size(); }

/// Stores a text as a model's file. Returns the status that a server would send, as do the functions below.
int csgsim_keep(std::size_t name_length) {
  return csgsim::web::status_of([&] {
    auto [name, text] = csgsim::web::split_input(name_length);
    csgsim::web::keep_file(std::move(name), std::move(text));
    return 200;
  });
}

/// Opens a stored model: its name, and knobs as JSON.
int csgsim_begin(std::size_t name_length) {
  return csgsim::web::status_of([&] {
    const auto [name, knobs] = csgsim::web::split_input(name_length);
    csgsim::web::session = std::make_unique<csgsim::viewer::Session>(
        csgsim::viewer::StartCommand{.model = name, .words = {}, .knobs = csgsim::session::parse_json(knobs, {})});
    return 200;
  });
}

/// Answers a question as Session::answer does: its name, and a request as JSON.
int csgsim_answer(std::size_t path_length) {
  return csgsim::web::status_of([&] {
    auto [path, body] = csgsim::web::split_input(path_length);
    return csgsim::web::store_answer(path, std::move(body));
  });
}
}
