#include "sim/viewer/server/request_reader.h"

#include <nlohmann/json.hpp>

#include "tests/support/test.h"

using namespace csgsim;
using viewer::RequestReader;
using State = RequestReader::State;

namespace {

constexpr viewer::RequestLimits limits{.header_bytes = 200, .header_fields = 5, .body_bytes = 10};

std::optional<viewer::Reply> admit(const viewer::Request& /*head*/) { return std::nullopt; }

RequestReader read(std::string_view bytes) {
  RequestReader reader(limits, admit);
  reader.put(bytes);
  return reader;
}

/// Status of the refusal of these bytes, or 0. Its body must be JSON with an error.
int refusal_of(std::string_view bytes) {
  const RequestReader reader = read(bytes);
  if (reader.state() != State::refused) return 0;
  CHECK(nlohmann::json::parse(reader.refusal().body).at("error").is_string());
  return reader.refusal().status;
}

std::string post(const std::string& fields, const std::string& body) {
  return "POST /t/draw HTTP/1.1\r\n" + fields + "\r\n" + body;
}

/// A request whose header has this number of bytes.
std::string header_of(std::size_t bytes) {
  const std::string begin = "GET / HTTP/1.1\r\nX: ";
  return begin + std::string(bytes - begin.size() - 4, 'x') + "\r\n\r\n";
}

std::string fields(int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += "A" + std::to_string(i) + ": x\r\n";
  return all;
}

}  // namespace

TEST_CASE("an HTTP request is read alike as a whole and byte by byte") {
  const std::string first =
      "POST /t/draw?now HTTP/1.1\r\nHost: h:1\r\nOrigin: o\r\nSec-Fetch-Site: none\r\nContent-Type: "
      "application/json\r\nContent-Length: 3\r\n\r\n{ }";
  const std::string second = "GET /t/ HTTP/1.0\r\nhost: other\r\n\r\n";
  constexpr viewer::RequestLimits wide{.header_bytes = 1000, .header_fields = 9, .body_bytes = 3};
  for (const std::size_t step : {first.size() + second.size(), std::size_t{1}, std::size_t{7}}) {
    RequestReader reader(wide, admit);
    const std::string both = first + second;
    std::size_t at = 0;
    const auto put_until_whole = [&] {
      while (reader.state() != State::whole && at < both.size()) {
        reader.put(std::string_view(both).substr(at, step));
        at += step;
      }
      REQUIRE(reader.state() == State::whole);
    };
    CHECK_FALSE(reader.has_begun());
    put_until_whole();
    CHECK(reader.has_begun());
    const viewer::Request& request = reader.request();
    CHECK(request.method == "POST");
    CHECK(request.path == "/t/draw");
    CHECK(request.host == "h:1");
    CHECK(request.origin == "o");
    CHECK(request.site == "none");
    CHECK(request.content_type == "application/json");
    CHECK(request.body == "{ }");
    CHECK(reader.keeps_alive());
    reader.next();
    put_until_whole();
    CHECK(reader.request().method == "GET");
    CHECK(reader.request().host == "other");
    CHECK(reader.request().origin == "");
    CHECK(reader.request().body == "");
    CHECK_FALSE(reader.keeps_alive());
  }
}

TEST_CASE("an HTTP header of the allowed bytes and fields is read and a larger one rejected") {
  CHECK(refusal_of(header_of(200)) == 0);
  CHECK(read(header_of(200)).state() == State::whole);
  CHECK(refusal_of(header_of(201)) == 431);
  // The header is refused before its end.
  CHECK(refusal_of("GET / HTTP/1.1\r\nX: " + std::string(181, 'x')) == 0);
  CHECK(refusal_of("GET / HTTP/1.1\r\nX: " + std::string(182, 'x')) == 431);
  CHECK(refusal_of(std::string(201, 'G')) == 431);
  CHECK(refusal_of("GET / HTTP/1.1\r\n" + fields(5) + "\r\n") == 0);
  CHECK(refusal_of("GET / HTTP/1.1\r\n" + fields(6) + "\r\n") == 431);
}

TEST_CASE("an HTTP body of the allowed bytes is read and a larger one rejected beforehand") {
  CHECK(read(post("Content-Length: 10\r\n", "0123456789")).request().body == "0123456789");
  CHECK(read(post("Content-Length: 10\r\n", "012345678")).state() == State::body);
  CHECK(read(post("Content-Length: 0\r\n", "")).state() == State::whole);
  CHECK(refusal_of(post("Content-Length: 11\r\n", "")) == 413);
  CHECK(refusal_of(post("Content-Length: 18446744073709551615\r\n", "")) == 413);
  CHECK(refusal_of(post("Content-Length: 18446744073709551617\r\n", "")) == 400);
  CHECK(refusal_of(post("Content-Length: -1\r\n", "")) == 400);
  CHECK(refusal_of("GET / HTTP/1.1\r\nContent-Length: 1\r\n\r\n") == 413);
  CHECK(refusal_of("GET / HTTP/1.1\r\nContent-Length: 0\r\n\r\n") == 0);
}

TEST_CASE("an HTTP body without a length or in chunks or compressed is rejected") {
  CHECK(refusal_of(post("", "")) == 411);
  CHECK(refusal_of(post("Transfer-Encoding: chunked\r\n", "")) == 411);
  CHECK(refusal_of("GET / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n") == 411);
  CHECK(refusal_of(post("Content-Length: 5\r\nTransfer-Encoding: chunked\r\n", "")) >= 400);
  CHECK(refusal_of(post("Content-Encoding: gzip\r\nContent-Length: 5\r\n", "")) == 415);
  CHECK(refusal_of(post("Content-Encoding: identity\r\nContent-Length: 5\r\n", "")) == 0);
  CHECK(refusal_of(post("Expect: 100-continue\r\nContent-Length: 5\r\n", "")) == 417);
}

TEST_CASE("HTTP methods other than GET and POST and other text are rejected") {
  for (const char* const method : {"PUT", "DELETE", "OPTIONS", "HEAD", "CONNECT", "PAINT"})
    CHECK(refusal_of(std::string(method) + " / HTTP/1.1\r\n\r\n") == 405);
  for (const char* const text :
       {"\r\n\r\n", "GET\r\n\r\n", "GET / HTTP/2.0\r\n\r\n", "GET / HTTP/1.1\r\nno colon\r\n\r\n",
        "GET / HTTP/1.1\r\nA: \x01\r\n\r\n", "\x16\x03\x01\x02\r\n\r\n"})
    CHECK(refusal_of(text) == 400);
}

TEST_CASE("a second value of an HTTP field that access depends on is rejected") {
  for (const char* const name : {"Host", "Origin", "Sec-Fetch-Site", "Content-Type", "Content-Encoding"})
    CHECK(refusal_of(std::string("GET / HTTP/1.1\r\n") + name + ": a\r\n" + name + ": a\r\n\r\n") == 400);
}

TEST_CASE("the access check receives an HTTP header before its body is examined") {
  int asked = 0;
  const auto refuse = [&](const viewer::Request& head) {
    ++asked;
    CHECK(head.host == "evil");
    CHECK(head.body.empty());
    return std::optional(viewer::error_reply(403, "no"));
  };
  for (const char* const more :
       {"", "Content-Length: 99999\r\n", "Transfer-Encoding: chunked\r\n", "Content-Length: 3\r\n"}) {
    RequestReader reader(limits, refuse);
    reader.put(post(std::string("Host: evil\r\n") + more, "abc"));
    CHECK(reader.state() == State::refused);
    CHECK(reader.refusal().status == 403);
  }
  CHECK(asked == 4);
}

TEST_CASE("an HTTP header may have 32 KiB and 100 fields by default") {
  const auto refusal = [](const std::string& bytes) {
    RequestReader reader({}, admit);
    reader.put(bytes);
    return reader.state() == State::whole ? "" : reader.refusal().body;
  };
  CHECK(refusal(header_of(32'768)) == "");
  CHECK(refusal(header_of(32'769)) == "{\"error\":\"the header of the request has more than 32768 bytes\"}\n");
  CHECK(refusal("GET / HTTP/1.1\r\n" + fields(100) + "\r\n") == "");
  CHECK(refusal("GET / HTTP/1.1\r\n" + fields(101) + "\r\n") ==
        "{\"error\":\"the request has more than 100 header fields\"}\n");
  CHECK(refusal(post("Content-Length: 4194305\r\n", "")) == "{\"error\":\"the body has more than 4194304 bytes\"}\n");
  CHECK(refusal(post("Content-Length: 4194304\r\n", std::string(4'194'304, 'x'))) == "");
}

TEST_CASE("an HTTP request's time starts with its first byte even after another request") {
  RequestReader reader(limits, admit);
  CHECK_FALSE(reader.has_begun());
  reader.put("G");
  CHECK(reader.has_begun());
  reader.put("ET / HTTP/1.1\r\n\r\n");
  REQUIRE(reader.state() == State::whole);
  reader.next();
  CHECK(reader.state() == State::head);
  CHECK_FALSE(reader.has_begun());
  reader.put(post("Content-Length: 2\r\n", "x"));
  CHECK(reader.state() == State::body);
  CHECK(reader.has_begun());
  reader.put("yG");
  REQUIRE(reader.state() == State::whole);
  CHECK(reader.request().body == "xy");
  reader.next();
  CHECK(reader.state() == State::head);
  CHECK(reader.has_begun());
}

TEST_CASE("the error message of each rejected HTTP request states the reason") {
  const auto error = [](std::string_view bytes) {
    return nlohmann::json::parse(read(bytes).refusal().body).at("error").get<std::string>();
  };
  CHECK(error("PUT / HTTP/1.1\r\n\r\n") == "csgsim view accepts GET and POST only");
  CHECK(error(post("Content-Length: 11\r\n", "")) == "the body has more than 10 bytes");
  CHECK(error("GET / HTTP/1.1\r\nContent-Length: 1\r\n\r\n") == "a GET must not have a body");
  CHECK(error("GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n") == "the request repeats the header field Host");
  CHECK(error("GET\r\n\r\n") == "not an HTTP/1.1 request");
}
