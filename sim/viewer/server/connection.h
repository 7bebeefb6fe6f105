// One connection of the HTTP server.
// Used by connections.cpp and module.cpp.
#pragma once

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "sim/viewer/server/request_reader.h"
#include "sim/viewer/server/server.h"

namespace csgsim::viewer {

/// A client's connection, from its first byte to its end. All functions are called on the thread of Server::io.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(boost::asio::ip::tcp::socket socket, Server& server);
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Starts reading the first request.
  void begin();
  /// Closes the socket and removes the connection from the server. Has no effect if it is closed already.
  void close();

 private:
  /// State of the connection.
  enum class Phase : std::uint8_t {
    reading,    ///< waits for a complete request
    answering,  ///< waits for a worker's reply
    writing,    ///< waits until the client has received the reply
    staying,    ///< waits until the page is closed
    leaving,    ///< waits until the client closes; discards its remaining bytes, so that it can read the refusal
  };

  void enter(Phase phase, std::chrono::milliseconds time_limit);
  void wait();
  void out_of_time();
  void read();
  void advance();
  void read_request();
  void answer();
  void write(Reply reply, bool keeps_alive);
  void refuse(Reply reply) { write(std::move(reply), false); }
  void stay();
  void leave();
  void discard_input();

  boost::asio::ip::tcp::socket socket_;
  boost::asio::steady_timer timer_;
  Server& server_;
  RequestReader reader_;
  Phase phase_ = Phase::reading;
  bool is_late_ = false;
  bool is_open_ = true;
  std::array<char, std::size_t{16} << 10U> block_{};
  std::string head_;
  std::string body_;
};

}  // namespace csgsim::viewer
