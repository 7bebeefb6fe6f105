#include "sim/viewer/server/request_reader.h"

#include <algorithm>
#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <limits>
#include <utility>

namespace csgsim::viewer {

namespace {

namespace http = boost::beast::http;

constexpr std::string_view end_of_head = "\r\n\r\n";

using HeadParser = http::request_parser<http::empty_body>;

/// Fields that must not be repeated: a proxy could act on a different value than this server.
constexpr auto single_fields = std::to_array<std::string_view>(
    {"Host", "Origin", "Sec-Fetch-Site", "Content-Type", "Content-Length", "Transfer-Encoding", "Content-Encoding"});

template <class View>
std::string text_of(const View& view) {
  return {view.data(), view.size()};
}

std::string value_of(const HeadParser& head, std::string_view name) {
  return text_of(head.get()[boost::beast::string_view(name.data(), name.size())]);
}

bool has(const HeadParser& head, std::string_view name) {
  return head.get().count(boost::beast::string_view(name.data(), name.size())) > 0;
}

/// The request target without its query.
std::string path_of(const HeadParser& head) {
  const std::string target = text_of(head.get().target());
  return target.substr(0, target.find('?'));
}

Request request_of(const HeadParser& head) {
  return {.method = text_of(head.get().method_string()),
          .path = path_of(head),
          .host = value_of(head, "Host"),
          .origin = value_of(head, "Origin"),
          .site = value_of(head, "Sec-Fetch-Site"),
          .content_type = value_of(head, "Content-Type")};
}

/// The reply if the header is refused before the gate sees it.
std::optional<Reply> malformed(const HeadParser& head, const RequestLimits& limits) {
  const auto& fields = head.get();
  if (static_cast<std::size_t>(std::distance(fields.begin(), fields.end())) > limits.header_fields)
    return error_reply(431, "the request has more than " + std::to_string(limits.header_fields) + " header fields");
  for (const std::string_view name : single_fields) {
    if (fields.count(boost::beast::string_view(name.data(), name.size())) > 1)
      return error_reply(400, "the request repeats the header field " + std::string(name));
  }
  return std::nullopt;
}

/// The reply if the body is refused before any of it is read.
std::optional<Reply> refused_body(const HeadParser& head, const RequestLimits& limits) {
  const bool is_post = head.get().method() == http::verb::post;
  if (!is_post && head.get().method() != http::verb::get)
    return error_reply(405, "csgsim view accepts GET and POST only");
  if (has(head, "Expect")) return error_reply(417, "send the body with the header, without Expect");
  if (has(head, "Transfer-Encoding")) return error_reply(411, "give the length of the body in Content-Length");
  if (const std::string coding = value_of(head, "Content-Encoding"); !coding.empty() && coding != "identity")
    return error_reply(415, "send the body uncompressed");
  const auto length = head.content_length();
  if (is_post && !length) return error_reply(411, "give the length of the body in Content-Length");
  if (!is_post && length.value_or(0) > 0) return error_reply(413, "a GET must not have a body");
  if (length.value_or(0) > limits.body_bytes)
    return error_reply(413, "the body has more than " + std::to_string(limits.body_bytes) + " bytes");
  return std::nullopt;
}

}  // namespace

void RequestReader::put(std::string_view bytes) {
  bytes_ += bytes;
  advance();
}

void RequestReader::next() {
  state_ = State::head;
  searched_ = 0;
  request_ = {};
  advance();
}

void RequestReader::advance() {
  if (state_ == State::head) read_head();
  if (state_ == State::body) read_body();
}

void RequestReader::refuse(Reply reply) {
  state_ = State::refused;
  refusal_ = std::move(reply);
  bytes_ = {};
  request_ = {};
}

void RequestReader::read_head() {
  const std::size_t end = bytes_.find(end_of_head, searched_);
  const bool is_complete = end != bytes_.npos;
  const std::size_t length = is_complete ? end + end_of_head.size() : bytes_.size();
  if (length > limits_.header_bytes) {
    return refuse(
        error_reply(431, "the header of the request has more than " + std::to_string(limits_.header_bytes) + " bytes"));
  }
  searched_ = bytes_.size() - std::min(bytes_.size(), end_of_head.size() - 1);
  if (!is_complete) return;
  HeadParser head;
  head.header_limit(static_cast<std::uint32_t>(length));
  head.body_limit(std::numeric_limits<std::uint64_t>::max());
  boost::system::error_code error;
  head.put(boost::asio::buffer(bytes_.data(), length), error);
  if (error || !head.is_header_done()) return refuse(error_reply(400, "not an HTTP/1.1 request"));
  if (std::optional<Reply> why = malformed(head, limits_)) return refuse(*std::move(why));
  request_ = request_of(head);
  if (std::optional<Reply> why = gate_(request_)) return refuse(*std::move(why));
  if (std::optional<Reply> why = refused_body(head, limits_)) return refuse(*std::move(why));
  keeps_alive_ = head.keep_alive();
  body_length_ = static_cast<std::size_t>(head.content_length().value_or(0));
  bytes_.erase(0, length);
  state_ = State::body;
}

void RequestReader::read_body() {
  const std::size_t taken = std::min(bytes_.size(), body_length_ - request_.body.size());
  request_.body.append(bytes_, 0, taken);
  bytes_.erase(0, taken);
  if (request_.body.size() == body_length_) state_ = State::whole;
}

}  // namespace csgsim::viewer
