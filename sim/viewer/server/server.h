// State shared by all connections.
// Used by connection.h and module.cpp.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/thread_pool.hpp>
#include <cstddef>

#include "sim/viewer/module.h"
#include "sim/viewer/server/connections.h"
#include "sim/viewer/server/pages.h"

namespace csgsim::viewer {

/// State shared by the connections. One thread does all input and output; workers compute the answers.
struct Server {
  static constexpr std::size_t workers_count = 8;  ///< a browser sends up to six requests at a time

  const Serving& serving;
  boost::asio::io_context io{};
  Connections connections{};
  Pages pages{};
  boost::asio::thread_pool workers{workers_count};
};

}  // namespace csgsim::viewer
