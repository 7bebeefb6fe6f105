// The open connections and their limits.
// Used by server.h.
#pragma once

#include <cstddef>
#include <list>
#include <memory>

namespace csgsim::viewer {

class Connection;

/// The open connections. All come from this computer, so addresses do not distinguish clients. A connection is a
/// stranger until it has sent the token. Strangers have a separate limit, so that they cannot block admitted
/// connections.
class Connections {
 public:
  static constexpr std::size_t max_strangers = 32;
  static constexpr std::size_t max_admitted = 64;

  /// Adds a connection as a stranger. If there are too many strangers, closes the oldest.
  void add(const std::shared_ptr<Connection>& connection);

  /// Counts a stranger as admitted. Returns false if max_admitted are admitted already.
  [[nodiscard]] bool try_admit(const std::shared_ptr<Connection>& connection);

  /// Removes a closed connection, stranger or admitted.
  void remove(const std::shared_ptr<Connection>& connection);

 private:
  std::list<std::shared_ptr<Connection>> strangers_;  ///< ordered by arrival
  std::list<std::shared_ptr<Connection>> admitted_;
};

}  // namespace csgsim::viewer
