#include "sim/viewer/server/connections.h"

#include <algorithm>

#include "sim/viewer/server/connection.h"

namespace csgsim::viewer {

void Connections::add(const std::shared_ptr<Connection>& connection) {
  if (strangers_.size() == max_strangers) {
    const std::shared_ptr<Connection> oldest = strangers_.front();
    oldest->close();
  }
  strangers_.push_back(connection);
}

bool Connections::try_admit(const std::shared_ptr<Connection>& connection) {
  const auto stranger = std::ranges::find(strangers_, connection);
  if (stranger == strangers_.end()) return true;
  if (admitted_.size() == max_admitted) return false;
  admitted_.splice(admitted_.end(), strangers_, stranger);
  return true;
}

void Connections::remove(const std::shared_ptr<Connection>& connection) {
  strangers_.remove(connection);
  admitted_.remove(connection);
}

}  // namespace csgsim::viewer
