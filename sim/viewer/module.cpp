#include "sim/viewer/module.h"

#include <httplib.h>

#include <chrono>
#include <condition_variable>
#include <cstring>
#include <exception>
#include <mutex>
#include <thread>

namespace csgsim::viewer {

namespace {

constexpr int most_connections = 24;  // a browser keeps some open
constexpr int seconds_without_a_byte = 10;

/// How many pages are open, and since when there is none.
class Pages {
 public:
  void open() {
    const std::lock_guard lock(mutex_);
    ++open_;
    has_been_ = true;
  }
  void close() {
    const std::lock_guard lock(mutex_);
    --open_;
    closed_ = Clock::now();
  }
  [[nodiscard]] bool is_left_for(std::chrono::milliseconds patience) const {
    const std::lock_guard lock(mutex_);
    return has_been_ && open_ == 0 && Clock::now() - closed_ > patience;
  }

 private:
  using Clock = std::chrono::steady_clock;

  mutable std::mutex mutex_;
  int open_ = 0;
  bool has_been_ = false;
  Clock::time_point closed_;
};

/// Stops the server when nobody has been there for so long, until the end of its own life.
class Watch {
 public:
  Watch(httplib::Server& server, const Pages& pages, std::chrono::milliseconds patience)
      : thread_([&, patience] { run(server, pages, patience); }) {}
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
  ~Watch() {
    {
      const std::lock_guard lock(mutex_);
      ends_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }

 private:
  void run(httplib::Server& server, const Pages& pages, std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, std::chrono::milliseconds(200), [&] { return ends_; })) {
      if (patience.count() == 0 || !pages.is_left_for(patience)) continue;
      server.stop();
      return;
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool ends_ = false;
  std::thread thread_;
};

Request request_of(const httplib::Request& from) {
  return {.method = from.method,
          .path = from.path,
          .host = from.get_header_value("Host"),
          .origin = from.get_header_value("Origin"),
          .site = from.get_header_value("Sec-Fetch-Site"),
          .content_type = from.get_header_value("Content-Type"),
          .body = from.body};
}

/// Nothing is kept, framed, guessed at or sent on; and a page has what this server sends, and nothing else.
void set_headers(httplib::Response& response, bool has_scripts) {
  response.set_header("Cache-Control", "no-store");
  const std::string own = has_scripts ? "'unsafe-inline'" : "'self'";
  response.set_header("Content-Security-Policy", "default-src 'none'; script-src " + own + "; style-src " + own +
                                                     "; img-src data:; connect-src " +
                                                     (has_scripts ? "'none'" : "'self'") +
                                                     "; frame-ancestors 'none'; base-uri 'none'; form-action 'none'");
  response.set_header("Cross-Origin-Opener-Policy", "same-origin");
  response.set_header("Cross-Origin-Resource-Policy", "same-origin");
  response.set_header("Referrer-Policy", "no-referrer");
  response.set_header("X-Content-Type-Options", "nosniff");
}

/// A stream that says something twice a second, so that its end is noticed.
void stay(httplib::Response& response, Pages& pages) {
  pages.open();
  response.set_chunked_content_provider(
      "text/event-stream",
      [](std::size_t, httplib::DataSink& sink) {
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        constexpr const char* nothing = ":\n\n";
        return sink.is_writable() && sink.write(nothing, std::strlen(nothing));
      },
      [&pages](bool) { pages.close(); });
}

void answer(const Serving& serving, Pages& pages, const httplib::Request& from, httplib::Response& response) {
  const Request request = request_of(from);
  Reply reply;
  try {
    if (request.method == "GET" && serving.stays(request)) {
      set_headers(response, false);
      return stay(response, pages);
    }
    reply = serving.handler(request);
  } catch (const std::exception& error) {
    reply = {.status = 500, .body = std::string(error.what()) + "\n"};
  }
  set_headers(response, reply.has_scripts);
  response.status = reply.status;
  response.set_content(reply.body, reply.type);
}

/// Without SO_REUSEPORT, with which two servers would share a port.
void set_socket_options(int socket) {
  const int yes = 1;
  ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

std::string serve(const Serving& serving) {
  httplib::Server server;
  Pages pages;
  server.new_task_queue = [] { return new httplib::ThreadPool(most_connections); };
  server.set_socket_options([](int socket) { set_socket_options(socket); });
  server.set_payload_max_length(serving.most_bytes);
  server.set_read_timeout(seconds_without_a_byte);
  server.set_write_timeout(seconds_without_a_byte);
  server.set_keep_alive_max_count(1000);
  const auto handle = [&](const httplib::Request& from, httplib::Response& response) {
    answer(serving, pages, from, response);
  };
  server.Get(".*", handle);
  server.Post(".*", handle);
  constexpr const char* here = "127.0.0.1";
  int port = serving.port;
  if (port == 0) {
    port = server.bind_to_any_port(here);
  } else if (!server.bind_to_port(here, port)) {
    port = -1;
  }
  if (port < 0) return "port " + std::to_string(serving.port) + " of 127.0.0.1 cannot be had; is it in use?";
  serving.begun(static_cast<std::uint16_t>(port));
  const Watch watch(server, pages, serving.patience);
  return server.listen_after_bind() ? "" : "the server has ended";
}

}  // namespace

}  // namespace csgsim::viewer

// The name is that of module_symbol.
extern "C" [[gnu::visibility("default")]] const csgsim::viewer::Module csgsim_viewer_1;
const csgsim::viewer::Module csgsim_viewer_1{csgsim::viewer::serve};
