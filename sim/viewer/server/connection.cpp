#include "sim/viewer/server/connection.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <exception>
#include <string_view>
#include <utility>

#include "sim/viewer/server/reply_head.h"

namespace csgsim::viewer {

namespace {

using boost::system::error_code;

constexpr std::string_view no_event = ":\n\n";

Reply late_reply(std::chrono::milliseconds time_limit) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time_limit);
  return error_reply(408, "the request was not complete after " + std::to_string(seconds.count()) + " s");
}

/// Called on a worker thread.
Reply reply_to(const Request& request, const Serving& serving) {
  try {
    return serving.handler(request);
  } catch (const std::exception& error) {
    return {.status = 500, .body = std::string(error.what()) + "\n"};
  }
}

}  // namespace

Connection::Connection(boost::asio::ip::tcp::socket socket, Server& server)
    : socket_(std::move(socket)),
      timer_(server.io),
      server_(server),
      reader_(server.serving.limits, server.serving.gate) {}

void Connection::begin() {
  error_code ignored;
  socket_.set_option(boost::asio::ip::tcp::no_delay(true), ignored);
  read_request();
}

void Connection::close() {
  if (!is_open_) return;
  is_open_ = false;
  error_code ignored;
  socket_.close(ignored);
  timer_.cancel();
  if (phase_ == Phase::staying) server_.pages.close();
  server_.connections.remove(shared_from_this());
}

void Connection::enter(Phase phase, std::chrono::milliseconds time_limit) {
  phase_ = phase;
  timer_.expires_after(time_limit);
  wait();
}

void Connection::wait() {
  timer_.async_wait([self = shared_from_this()](error_code error) {
    // An expired timer's handler may still be called after the timer was set again.
    const bool is_old = self->timer_.expiry() > std::chrono::steady_clock::now();
    if (!error && !is_old && self->is_open_) self->out_of_time();
  });
}

void Connection::out_of_time() {
  error_code ignored;
  switch (phase_) {
    case Phase::answering: return;
    case Phase::reading:
      is_late_ = true;
      static_cast<void>(socket_.cancel(ignored));
      return;
    case Phase::staying: return stay();
    case Phase::writing:
    case Phase::leaving: return close();
  }
}

void Connection::read_request() {
  enter(Phase::reading, server_.serving.times.request);
  advance();
}

void Connection::read() {
  socket_.async_read_some(boost::asio::buffer(block_),
                          [self = shared_from_this()](error_code error, std::size_t count) {
                            if (!self->is_open_) return;
                            if (self->is_late_ && self->reader_.has_begun())
                              return self->refuse(late_reply(self->server_.serving.times.request));
                            if (error || self->is_late_) return self->close();
                            self->reader_.put({self->block_.data(), count});
                            self->advance();
                          });
}

void Connection::advance() {
  using State = RequestReader::State;
  const State state = reader_.state();
  if (state == State::refused) return refuse(reader_.refusal());
  if (state != State::head && !server_.connections.try_admit(shared_from_this()))
    return refuse(error_reply(503, "too many connections are open; close some pages"));
  if (state == State::whole) return answer();
  read();
}

void Connection::answer() {
  const Request& request = reader_.request();
  if (request.method == "GET" && server_.serving.stays(request)) {
    server_.pages.open();
    head_ = stream_head();
    phase_ = Phase::staying;
    discard_input();
    return stay();
  }
  phase_ = Phase::answering;
  timer_.cancel();
  boost::asio::post(server_.workers, [self = shared_from_this()] {
    Reply reply = reply_to(self->reader_.request(), self->server_.serving);
    boost::asio::post(self->server_.io, [self, reply = std::move(reply)]() mutable {
      if (self->is_open_) self->write(std::move(reply), self->reader_.keeps_alive());
    });
  });
}

void Connection::write(Reply reply, bool keeps_alive) {
  enter(Phase::writing, server_.serving.times.reply);
  head_ = reply_head(reply, keeps_alive);
  body_ = std::move(reply.body);
  const std::array parts{boost::asio::buffer(head_), boost::asio::buffer(body_)};
  boost::asio::async_write(socket_, parts,
                           [self = shared_from_this(), keeps_alive](error_code error, std::size_t /*count*/) {
                             if (!self->is_open_) return;
                             if (error) return self->close();
                             self->body_ = {};
                             if (!keeps_alive) return self->leave();
                             self->reader_.next();
                             self->read_request();
                           });
}

void Connection::stay() {
  boost::asio::async_write(socket_, boost::asio::buffer(head_),
                           [self = shared_from_this()](error_code error, std::size_t /*count*/) {
                             if (!self->is_open_) return;
                             if (error) return self->close();
                             self->head_ = no_event;
                             self->enter(Phase::staying, self->server_.serving.times.between_events);
                           });
}

void Connection::leave() {
  enter(Phase::leaving, server_.serving.times.leave);
  error_code ignored;
  socket_.shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
  discard_input();
}

void Connection::discard_input() {
  socket_.async_read_some(boost::asio::buffer(block_),
                          [self = shared_from_this()](error_code error, std::size_t /*count*/) {
                            if (!self->is_open_) return;
                            if (error) return self->close();
                            self->discard_input();
                          });
}

}  // namespace csgsim::viewer
