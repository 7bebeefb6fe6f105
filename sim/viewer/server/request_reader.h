// Incremental HTTP request parser with limits.
// Used by connection.h and module.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "sim/viewer/http.h"

namespace csgsim::viewer {

/// Limits of a request. A request that exceeds them is refused before more of it is read.
struct RequestLimits {
  std::size_t header_bytes = std::size_t{32} << 10U;  ///< request line and all header fields
  std::size_t header_fields = 100;
  std::size_t body_bytes = std::size_t{4} << 20U;
};

/// Reads HTTP/1.1 requests from the bytes of one connection, one after another. It buffers no more than the limits
/// allow, plus the bytes of one call to put().
class RequestReader {
 public:
  enum class State : std::uint8_t {
    head,     ///< the header is not complete
    body,     ///< the header is complete and admitted, the body is not complete
    whole,    ///< request() is complete
    refused,  ///< refusal() is the reply; the connection cannot be used any more
  };

  /// Returns the reply that refuses a request because of its header, or nothing to admit it.
  using Gate = std::function<std::optional<Reply>(const Request& head)>;

  RequestReader(const RequestLimits& limits, Gate gate) : limits_(limits), gate_(std::move(gate)) {}

  /// Processes bytes in order of arrival. Must not be called in the states `whole` and `refused`.
  void put(std::string_view bytes);

  /// Starts the next request, whose first bytes may have arrived already. Only in the state `whole`.
  void next();

  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] const Request& request() const { return request_; }
  [[nodiscard]] const Reply& refusal() const { return refusal_; }

  /// Whether the client wants to reuse the connection. Only in the state `whole`.
  [[nodiscard]] bool keeps_alive() const { return keeps_alive_; }

  /// Whether a request has begun to arrive.
  [[nodiscard]] bool has_begun() const { return state_ != State::head || !bytes_.empty(); }

 private:
  void advance();
  void read_head();
  void read_body();
  void refuse(Reply reply);

  RequestLimits limits_;
  Gate gate_;
  State state_ = State::head;
  std::string bytes_;            ///< not yet processed
  std::size_t searched_ = 0;     ///< bytes already searched for the end of the header
  std::size_t body_length_ = 0;  ///< announced by the header
  bool keeps_alive_ = false;
  Request request_;
  Reply refusal_;
};

}  // namespace csgsim::viewer
