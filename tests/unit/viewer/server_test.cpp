// Tests of csgsim view's server by its clients' replies, over local connections.

#include <atomic>
#include <chrono>
#include <list>
#include <thread>

#include "sim/viewer/server/pages.h"
#include "tests/support/test.h"
#include "tests/unit/viewer/served.h"

using namespace csgsim;
using namespace std::chrono_literals;
using testing::Client;
using testing::RunningServer;

namespace {

/// Fields of every reply, and the permitted sources of a page's scripts, styles and requests.
std::string policy(const std::string& own, const std::string& asks) {
  return "Cache-Control: no-store\r\nContent-Security-Policy: default-src 'none'; script-src " + own + "; style-src " +
         own + "; img-src data:; connect-src " + asks +
         "; frame-ancestors 'none'; base-uri 'none'; form-action 'none'\r\nCross-Origin-Opener-Policy: same-origin\r\n"
         "Cross-Origin-Resource-Policy: same-origin\r\nReferrer-Policy: no-referrer\r\n"
         "X-Content-Type-Options: nosniff\r\n\r\n";
}

const std::string plain_policy = policy("'self'", "'self'");

/// Replies of each kind by path; any other path echoes the method, the path and the body.
viewer::Reply reply_to_path(const viewer::Request& request) {
  if (request.path == "/page") return {.type = "text/html", .body = "<p>", .has_scripts = true};
  if (request.path == "/none") return {.status = 404, .body = "none"};
  if (request.path == "/no") return viewer::error_reply(405, "no");
  if (request.path == "/fault") throw std::runtime_error("a fault");
  return {.body = request.method + " " + request.path + " " + request.body};
}

viewer::Serving serving(viewer::ConnectionTimes times = {}) {
  viewer::Serving one;
  one.times = times;
  one.handler = reply_to_path;
  return one;
}

std::string get(const std::string& path, const std::string& fields = "") {
  return "GET " + path + " HTTP/1.1\r\nHost: h\r\n" + fields + "\r\n";
}

std::string head(const std::string& status, const std::string& type, std::size_t length, const std::string& more) {
  return "HTTP/1.1 " + status + "\r\nContent-Type: " + type + "\r\nContent-Length: " + std::to_string(length) + "\r\n" +
         more;
}

constexpr const char* plain = "text/plain; charset=utf-8";

/// The reply to a request of a connection that stays open.
std::string plain_reply(const std::string& body) {
  return head("200 OK", plain, body.size(), "Connection: keep-alive\r\n" + plain_policy) + body;
}

}  // namespace

TEST_CASE("a connection has default time limits and a page a default event interval") {
  const viewer::ConnectionTimes times;
  CHECK(times.request == 10s);
  CHECK(times.reply == 60s);
  CHECK(times.leave == 2s);
  CHECK(times.between_events == 500ms);
  CHECK(viewer::RequestLimits{}.header_bytes == 32'768);
  CHECK(viewer::RequestLimits{}.header_fields == 100);
  CHECK(viewer::RequestLimits{}.body_bytes == 4'194'304);
}

TEST_CASE("each kind of reply has its exact status line and headers and body") {
  const RunningServer server(serving());
  Client client(server.port);
  const auto reply = [&](const std::string& request) {
    client.send(request);
    const std::string begin = client.until("\r\n\r\n");
    const std::size_t at = begin.find("Content-Length: ");
    REQUIRE(at != begin.npos);
    return begin + client.bytes(std::stoul(begin.substr(at + 16)));
  };
  const std::string kept = "Connection: keep-alive\r\n";
  CHECK(reply(get("/a?b")) == plain_reply("GET /a "));
  CHECK(reply("POST /b HTTP/1.1\r\nContent-Length: 3\r\n\r\nxyz") == plain_reply("POST /b xyz"));
  CHECK(reply(get("/page")) == head("200 OK", "text/html", 3, kept + policy("'unsafe-inline'", "'none'")) + "<p>");
  CHECK(reply(get("/none")) == head("404 Not Found", plain, 4, kept + plain_policy) + "none");
  CHECK(reply(get("/no")) ==
        head("405 Method Not Allowed", "application/json", 15, kept + "Allow: GET, POST\r\n" + plain_policy) +
            "{\"error\":\"no\"}\n");
  CHECK(reply(get("/fault")) == head("500 Internal Server Error", plain, 8, kept + plain_policy) + "a fault\n");
  // A POST request never opens a page connection, whatever its path.
  CHECK(reply("POST /stay HTTP/1.1\r\nContent-Length: 0\r\n\r\n") == plain_reply("POST /stay "));
}

TEST_CASE("a server answers pipelined requests one by one and closes after the last reply") {
  const RunningServer server(serving());
  Client client(server.port);
  client.send(get("/a") + get("/b") + get("/c", "Connection: close\r\n"));
  CHECK(client.until("/a ") == plain_reply("GET /a "));
  CHECK(client.until("/b ") == plain_reply("GET /b "));
  CHECK(client.until("/c ") == head("200 OK", plain, 7, "Connection: close\r\n" + plain_policy) + "GET /c ");
  const auto begin = std::chrono::steady_clock::now();
  CHECK(client.is_at_end());
  CHECK(std::chrono::steady_clock::now() - begin < 1500ms);  // before its time limit
}

TEST_CASE("a request that arrives in two parts is one request") {
  const RunningServer server(serving());
  Client client(server.port);
  const std::string request = "POST /b HTTP/1.1\r\nContent-Length: 3\r\n\r\nxyz";
  for (const std::size_t first : {5U, 38U, 40U}) {
    client.send(request.substr(0, first));
    std::this_thread::sleep_for(10ms);
    client.send(request.substr(first));
    CHECK(client.until("xyz") == plain_reply("POST /b xyz"));
  }
}

TEST_CASE("a rejected client gets the reason while its further bytes are discarded") {
  viewer::Serving one = serving();
  one.limits.body_bytes = 10;
  const RunningServer server(std::move(one));
  Client client(server.port);
  CHECK(client.send("POST / HTTP/1.1\r\nContent-Length: 20000000\r\n\r\n"));
  CHECK(client.send(std::string(20'000'000, 'x')));  // more than the buffers between them hold
  const std::string reply = client.rest();
  CHECK(reply == head("413 Payload Too Large", "application/json", 44, "Connection: close\r\n" + plain_policy) +
                     "{\"error\":\"the body has more than 10 bytes\"}\n");
  CHECK(client.is_at_end());
}

TEST_CASE("a server drops a client that stays connected after its last reply") {
  const RunningServer server(serving({.leave = 50ms}));
  const Client client(server.port);
  client.send(get("/a", "Connection: close\r\n"));
  // A closed connection rejects further bytes.
  bool is_refused = false;
  for (int i = 0; i < 100 && !is_refused; ++i) {
    std::this_thread::sleep_for(10ms);
    is_refused = !client.send("x");
  }
  CHECK(is_refused);
}

TEST_CASE("a server has separate time limits for slow requests and idle connections") {
  const RunningServer server(serving({.request = 500ms}));
  Client silent(server.port);
  Client slow(server.port);
  Client body(server.port);
  Client steady(server.port);
  slow.send("GET / HT");
  body.send("POST / HTTP/1.1\r\nContent-Length: 3\r\n\r\nx");
  const auto begin = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - begin < 600ms) {
    std::this_thread::sleep_for(10ms);
    steady.send(get("/a"));
    CHECK(steady.until("/a ") == plain_reply("GET /a "));
  }
  CHECK(silent.rest().empty());
  CHECK(silent.is_at_end());
  for (Client* const late : {&slow, &body}) {
    const std::string reply = late->rest();
    CHECK(reply.starts_with("HTTP/1.1 408 Request Timeout\r\n"));
    CHECK(reply.ends_with("{\"error\":\"the request was not complete after 0 s\"}\n"));
    CHECK(late->is_at_end());
  }
}

TEST_CASE("a handler may take longer than the time limit of a request") {
  viewer::Serving one = serving({.request = 400ms, .reply = 2s});
  one.handler = [](const viewer::Request&) {
    std::this_thread::sleep_for(600ms);
    return viewer::Reply{.body = "done"};
  };
  const RunningServer server(std::move(one));
  Client client(server.port);
  client.send(get("/"));
  CHECK(client.until("done") == plain_reply("done"));
}

TEST_CASE("a server drops a client that does not read its reply and serves one that does") {
  constexpr std::size_t large = std::size_t{32} << 20U;
  viewer::Serving one = serving({.reply = 100ms});
  one.handler = [](const viewer::Request&) { return viewer::Reply{.body = std::string(large, 'x')}; };
  viewer::Serving other = serving();
  other.handler = one.handler;
  const RunningServer server(std::move(one));
  Client lazy(server.port);
  lazy.send(get("/"));
  std::this_thread::sleep_for(500ms);
  CHECK(lazy.rest().size() < large);
  const RunningServer patient(std::move(other));
  Client eager(patient.port);
  eager.send(get("/"));
  eager.until("\r\n\r\n");
  CHECK(eager.bytes(large).size() == large);
}

TEST_CASE("an open page receives periodic events and the server ends after the last page") {
  viewer::Serving one = serving({.between_events = 20ms});
  one.patience = 200ms;
  std::atomic<int> ticks = 0;
  std::atomic<int> ends = 0;
  one.tick = [&] { ++ticks; };
  one.ending = [&] { ++ends; };
  const RunningServer server(std::move(one));
  std::this_thread::sleep_for(150ms);
  CHECK_FALSE(server.has_left());  // no page has been opened yet
  Client first(server.port);
  Client second(server.port);
  const auto asked = std::chrono::steady_clock::now();
  first.send(get("/stay"));
  const std::string begin =
      "HTTP/1.1 200 OK\r\nContent-Type: text/event-stream\r\nConnection: close\r\n" + plain_policy;
  CHECK(first.until("\r\n\r\n") == begin);
  second.send(get("/stay"));
  CHECK(second.until("\r\n\r\n") == begin);
  CHECK(first.bytes(15) == ":\n\n:\n\n:\n\n:\n\n:\n\n");
  CHECK(std::chrono::steady_clock::now() - asked > 90ms);  // five times, 20 ms apart
  first.close();
  std::this_thread::sleep_for(350ms);
  CHECK_FALSE(server.has_left());
  CHECK(second.bytes(3) == ":\n\n");
  CHECK(ends == 0);
  second.close();
  CHECK(server.ends_soon());
  CHECK(ends == 1);
  CHECK(ticks > 1);
}

TEST_CASE("a server without a patience limit continues when no page is open") {
  const RunningServer server(serving());
  Client page(server.port);
  page.send(get("/stay"));
  CHECK(page.until("\r\n\r\n").starts_with("HTTP/1.1 200"));
  page.close();
  std::this_thread::sleep_for(300ms);
  CHECK_FALSE(server.has_left());
}

TEST_CASE("a server announces its end before it waits for requests in progress") {
  std::atomic<bool> is_ending = false;
  std::atomic<bool> was_announced = false;
  viewer::Serving one = serving();
  one.patience = 1ms;
  one.ending = [&] { is_ending = true; };
  one.handler = [&](const viewer::Request&) {
    for (int i = 0; i < 200 && !is_ending; ++i) std::this_thread::sleep_for(10ms);
    was_announced = is_ending.load();
    return viewer::Reply{};
  };
  const RunningServer server(std::move(one));
  const Client asks(server.port);
  asks.send(get("/"));
  Client page(server.port);
  page.send(get("/stay"));
  page.until("\r\n\r\n");
  page.close();
  CHECK(server.ends_soon());
  CHECK(was_announced);
}

TEST_CASE("a server handles up to eight requests at a time") {
  std::atomic<int> inside = 0;
  std::atomic<int> most = 0;
  viewer::Serving one = serving();
  one.handler = [&](const viewer::Request&) {
    const int now = ++inside;
    if (now > most) most = now;
    for (int i = 0; i < 100 && most < 8; ++i) std::this_thread::sleep_for(10ms);
    std::this_thread::sleep_for(100ms);  // long enough for a ninth to enter
    --inside;
    return viewer::Reply{.body = "done"};
  };
  const RunningServer server(std::move(one));
  std::list<Client> clients;
  for (int i = 0; i < 12; ++i) clients.emplace_back(server.port).send(get("/"));
  for (Client& client : clients) CHECK(client.until("done") == plain_reply("done"));
  CHECK(most == 8);
}

TEST_CASE("a server keeps 32 connections without a token, and a new one closes the oldest") {
  const RunningServer server(serving());
  Client asks(server.port);
  // One turn of the server accepts a connection and notices closed ones; both have happened after many answered
  // requests.
  const auto settle = [&] {
    for (int i = 0; i < 50; ++i) {
      asks.send(get("/a"));
      CHECK(asks.until("/a ") == plain_reply("GET /a "));
    }
  };
  settle();
  std::list<Client> strangers;
  const auto come = [&](std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      strangers.emplace_back(server.port).send("G");
      if (i % 8 == 7) settle();
    }
    settle();
  };
  // Checks which of the remaining connections are open; waits for the expected state for a limited time.
  const auto are_open = [&](const std::string& expected) {
    std::string all;
    for (int i = 0; i < 100 && all != expected; ++i) {
      if (i > 0) std::this_thread::sleep_for(20ms);
      all.clear();
      for (const Client& one : strangers) all += one.is_open() ? '1' : '0';
    }
    return all == expected;
  };
  come(32);
  CHECK(are_open(std::string(32, '1')));
  come(2);
  CHECK(are_open("00" + std::string(32, '1')));
  // Five of the last 32 close, which makes room for five.
  for (int i = 0; i < 7; ++i) strangers.pop_front();
  settle();
  come(5);
  CHECK(are_open(std::string(32, '1')));
  // An admitted one makes room as well, and is not closed for others.
  Client& admitted = strangers.front();
  admitted.send("ET / HTTP/1.1\r\n\r\n");
  CHECK(admitted.until(" / ").starts_with("HTTP/1.1 200"));
  come(1);
  CHECK(are_open(std::string(33, '1')));
  come(32);
  CHECK(are_open("1" + std::string(32, '0') + std::string(32, '1')));
  admitted.send(get("/a"));
  CHECK(admitted.until("/a ") == plain_reply("GET /a "));
}

TEST_CASE("a server keeps 64 admitted connections and rejects one more until one closes") {
  const RunningServer server(serving());
  std::list<Client> all;
  const auto ask = [](Client& client) {
    client.send(get("/a"));
    return client.until("\r\n");
  };
  for (int i = 0; i < 64; ++i) CHECK(ask(all.emplace_back(server.port)) == "HTTP/1.1 200 OK\r\n");
  Client more(server.port);
  more.send(get("/a"));
  const std::string refused = more.rest();
  CHECK(refused.starts_with("HTTP/1.1 503 Service Unavailable\r\n"));
  CHECK(refused.ends_with("{\"error\":\"too many connections are open; close some pages\"}\n"));
  all.back().until("/a ");
  CHECK(ask(all.back()) == "HTTP/1.1 200 OK\r\n");
  all.pop_front();
  for (int i = 0; i < 50; ++i) {
    all.back().until("/a ");
    CHECK(ask(all.back()) == "HTTP/1.1 200 OK\r\n");
  }
  Client next(server.port);
  CHECK(ask(next) == "HTTP/1.1 200 OK\r\n");
}

TEST_CASE("the access check decides on an HTTP header before the body arrives") {
  viewer::Serving one = serving();
  one.gate = [](const viewer::Request& request) {
    return request.host == "h" ? std::nullopt : std::optional(viewer::error_reply(403, "no"));
  };
  const RunningServer server(std::move(one));
  Client known(server.port);
  known.send(get("/a"));
  CHECK(known.until("/a ") == plain_reply("GET /a "));
  Client stranger(server.port);
  stranger.send("POST /a HTTP/1.1\r\nHost: g\r\nContent-Length: 9\r\n\r\n");
  const std::string reply = stranger.rest();
  CHECK(reply.starts_with("HTTP/1.1 403 Forbidden\r\n"));
  CHECK(reply.ends_with("{\"error\":\"no\"}\n"));
}

TEST_CASE("a port in use is rejected and one of an ended server is free at once") {
  std::uint16_t port = 0;
  {
    const RunningServer server(serving());
    port = server.port;
    CHECK(port != 0);
    viewer::Serving second = serving();
    second.port = port;
    CHECK(testing::error_of([&] { const RunningServer other(second); }) ==
          "port " + std::to_string(port) + " of 127.0.0.1 is not available; choose another one with --port");
    // The server closes this connection first, and the system remembers that for a minute.
    Client client(port);
    client.send(get("/a", "Connection: close\r\n"));
    CHECK(client.is_at_end());
  }
  viewer::Serving again = serving();
  again.port = port;
  const RunningServer server(std::move(again));
  CHECK(server.port == port);
  Client client(port);
  client.send(get("/a"));
  CHECK(client.until("/a ") == plain_reply("GET /a "));
}

TEST_CASE("pages are left once all have been closed for longer than the given time") {
  viewer::Pages pages;
  CHECK_FALSE(pages.are_closed_for(0ms));
  pages.open();
  pages.open();
  CHECK_FALSE(pages.are_closed_for(0ms));
  pages.close();
  std::this_thread::sleep_for(2ms);
  CHECK_FALSE(pages.are_closed_for(0ms));
  pages.close();
  std::this_thread::sleep_for(2ms);
  CHECK(pages.are_closed_for(0ms));
  CHECK(pages.are_closed_for(1ms));
  CHECK_FALSE(pages.are_closed_for(1h));
  pages.open();
  CHECK_FALSE(pages.are_closed_for(0ms));
}