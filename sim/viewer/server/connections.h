#pragma once

#include <cstddef>
#include <list>
#include <memory>

namespace csgsim::viewer {

class Connection;

/// The connections that are open. All come from this computer, so that addresses do not distinguish clients. Those that
/// have shown the token are counted apart from strangers, which cannot keep out others.
class Connections {
 public:
  static constexpr std::size_t most_strangers = 32;
  static constexpr std::size_t most_admitted = 64;

  /// A new one is a stranger. Where there are too many, the one that has been there longest is closed.
  void add(const std::shared_ptr<Connection>& one);

  /// Counts a stranger as admitted. False if most_admitted are already.
  [[nodiscard]] bool admit(const std::shared_ptr<Connection>& one);

  void remove(const std::shared_ptr<Connection>& one);

 private:
  std::list<std::shared_ptr<Connection>> strangers_;  ///< in the order in which they came
  std::list<std::shared_ptr<Connection>> admitted_;
};

}  // namespace csgsim::viewer
