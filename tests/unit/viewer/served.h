#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <exception>
#include <future>
#include <thread>

#include "sim/viewer/serve.h"
#include "tests/support/test.h"

namespace csgsim::testing {

/// A server in a thread of this process, until its page is left or the object is destroyed.
class RunningServer {
 public:
  /// `serving` sets only the members that the test needs.
  explicit RunningServer(viewer::Serving serving) : serving_(std::move(serving)) {
    const auto tick = serving_.tick;
    serving_.begun = [this](std::uint16_t had) { port_.set_value(had); };
    // An exception of a tick ends the server at once.
    serving_.tick = [this, tick] {
      if (is_ended_) throw std::runtime_error("the test is done");
      if (tick) tick();
    };
    if (!serving_.gate) serving_.gate = [](const viewer::Request&) { return std::optional<viewer::Reply>(); };
    if (!serving_.stays) serving_.stays = [](const viewer::Request& request) { return request.path == "/stay"; };
    if (!serving_.ending) serving_.ending = [] {};
    thread_ = std::thread([this] {
      try {
        viewer::serve(serving_);
        is_left_ = true;
      } catch (const InputError& error) {
        port_.set_exception(std::make_exception_ptr(error));
      } catch (const std::runtime_error&) {
      }
    });
    try {
      port = port_.get_future().get();
    } catch (const InputError&) {
      thread_.join();
      throw;
    }
  }
  ~RunningServer() {
    is_ended_ = true;
    if (thread_.joinable()) thread_.join();
  }
  RunningServer(const RunningServer&) = delete;
  RunningServer& operator=(const RunningServer&) = delete;

  /// Whether the server ends within three seconds.
  [[nodiscard]] bool ends_soon() const {
    for (int i = 0; i < 300 && !is_left_; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return is_left_;
  }
  /// Whether the server has ended.
  [[nodiscard]] bool has_left() const { return is_left_; }

  std::uint16_t port = 0;

 private:
  viewer::Serving serving_;
  std::promise<std::uint16_t> port_;
  std::atomic<bool> is_ended_ = false;
  std::atomic<bool> is_left_ = false;
  std::thread thread_;
};

/// A client's connection. Operations that take longer than three seconds count as failed.
class Client {
 public:
  explicit Client(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    const timeval most{3, 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &most, sizeof most);
    ::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &most, sizeof most);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    REQUIRE(::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
  }
  ~Client() { close(); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  void close() {
    if (socket_ >= 0) ::close(std::exchange(socket_, -1));
  }

  /// Whether all bytes were accepted.
  bool send(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t count = ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
      if (count <= 0) return false;
      text.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
  }

  /// Unread bytes up to the end of the text, or to the connection's end.
  std::string until(std::string_view text) {
    while (held_.find(text) == held_.npos && receive()) {
    }
    const std::size_t found = held_.find(text);
    return take(found == held_.npos ? held_.size() : found + text.size());
  }
  std::string bytes(std::size_t count) {
    while (held_.size() < count && receive()) {
    }
    return take(std::min(count, held_.size()));
  }
  /// All bytes up to the connection's end.
  std::string rest() {
    while (receive()) {
    }
    return take(held_.size());
  }

  /// Whether the connection ended; false after three seconds without data.
  [[nodiscard]] bool is_at_end() {
    while (receive()) {
    }
    return is_at_end_;
  }
  /// Whether the connection is open; does not wait.
  [[nodiscard]] bool is_open() const {
    char byte = 0;
    return ::recv(socket_, &byte, 1, MSG_PEEK | MSG_DONTWAIT) < 0 && (errno == EAGAIN || errno == EWOULDBLOCK);
  }

 private:
  bool receive() {
    std::string block(std::size_t{1} << 16U, ' ');
    const ssize_t count = ::recv(socket_, block.data(), block.size(), 0);
    is_at_end_ = count == 0 || (count < 0 && errno == ECONNRESET);
    if (count <= 0) return false;
    held_.append(block, 0, static_cast<std::size_t>(count));
    return true;
  }
  std::string take(std::size_t count) {
    std::string taken = held_.substr(0, count);
    held_.erase(0, count);
    return taken;
  }

  int socket_;
  std::string held_;
  bool is_at_end_ = false;
};

}  // namespace csgsim::testing
