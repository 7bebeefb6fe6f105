#include "sim/viewer/module.h"

#include <boost/asio/ip/address_v4.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <memory>
#include <utility>

#include "sim/viewer/server/connection.h"
#include "sim/viewer/server/server.h"

namespace csgsim::viewer {

namespace {

using namespace std::chrono_literals;
using boost::asio::ip::tcp;
using boost::system::error_code;

constexpr auto tick = 100ms;

/// Listens without SO_REUSEPORT, which would let two servers share the port. Returns the error.
error_code listen(tcp::acceptor& acceptor, std::uint16_t port) {
  const tcp::endpoint here(boost::asio::ip::address_v4::loopback(), port);
  error_code error;
  acceptor.open(here.protocol(), error);
  if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(here, error);
  if (!error) acceptor.listen(boost::asio::socket_base::max_listen_connections, error);
  return error;
}

/// Accepts connections, and stops the server after the last page is closed.
class Attendant {
 public:
  Attendant(Server& server, tcp::acceptor& acceptor) : server_(server), acceptor_(acceptor), timer_(server.io) {}

  void accept() {
    acceptor_.async_accept([this](error_code error, tcp::socket socket) {
      // The process may be out of file descriptors; the next tick tries again.
      is_accepting_ = !error;
      if (error) return;
      const auto connection = std::make_shared<Connection>(std::move(socket), server_);
      server_.connections.add(connection);
      connection->begin();
      accept();
    });
    is_accepting_ = true;
  }

  void wait() {
    timer_.expires_after(tick);
    timer_.async_wait([this](error_code /*error*/) {
      server_.serving.tick();
      if (!is_accepting_) accept();
      const std::chrono::milliseconds patience = server_.serving.patience;
      if (patience.count() > 0 && server_.pages.are_closed_for(patience)) return server_.io.stop();
      wait();
    });
  }

 private:
  Server& server_;
  tcp::acceptor& acceptor_;
  boost::asio::steady_timer timer_;
  bool is_accepting_ = false;
};

std::string serve(const Serving& serving) {
  Server server{.serving = serving};
  tcp::acceptor acceptor(server.io);
  if (listen(acceptor, serving.port))
    return "port " + std::to_string(serving.port) + " of 127.0.0.1 is not available; choose another one with --port";
  serving.begun(acceptor.local_endpoint().port());
  Attendant attendant(server, acceptor);
  attendant.accept();
  attendant.wait();
  server.io.run();
  serving.ending();
  server.workers.join();
  return "";
}

}  // namespace

}  // namespace csgsim::viewer

// The name must equal module_symbol.
extern "C" [[gnu::visibility("default")]] const csgsim::viewer::Module csgsim_viewer_3;
const csgsim::viewer::Module csgsim_viewer_3{csgsim::viewer::serve};
