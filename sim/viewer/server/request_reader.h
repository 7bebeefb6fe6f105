#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "sim/viewer/http.h"

namespace csgsim::viewer {

/// What a request may take. A longer one is refused before more of it is read.
struct RequestLimits {
  std::size_t header_bytes = std::size_t{32} << 10U;  ///< of the request line and all header fields
  std::size_t header_fields = 100;
  std::size_t body_bytes = std::size_t{4} << 20U;
};

/// Reads requests of HTTP/1.1 from the bytes of one connection, one after another. It holds no more than the limits
/// allow, and the bytes of one call to put().
class RequestReader {
 public:
  enum class State : std::uint8_t {
    head,     ///< the header is not complete
    body,     ///< the header is complete and admitted, the body is not complete
    whole,    ///< request() is complete
    refused,  ///< refusal() is the answer; the connection cannot be used any further
  };

  /// The answer that refuses a request by its header alone; none admits it.
  using Gate = std::function<std::optional<Reply>(const Request& head)>;

  RequestReader(const RequestLimits& limits, Gate gate) : limits_(limits), gate_(std::move(gate)) {}

  /// Takes bytes in the order in which they arrive. In the states `whole` and `refused` nothing may be put.
  void put(std::string_view bytes);

  /// Begins with the next request. Some of its bytes may have been put already. Only in the state `whole`.
  void next();

  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] const Request& request() const { return request_; }
  [[nodiscard]] const Reply& refusal() const { return refusal_; }

  /// Whether the client wants to use the connection again. Only in the state `whole`.
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
  std::string bytes_;            ///< not yet taken
  std::size_t searched_ = 0;     ///< bytes in which the header does not end
  std::size_t body_length_ = 0;  ///< that the header announces
  bool keeps_alive_ = false;
  Request request_;
  Reply refusal_;
};

}  // namespace csgsim::viewer
