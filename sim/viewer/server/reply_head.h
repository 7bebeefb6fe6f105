// Header of an HTTP reply.
// Used by connection.cpp.
#pragma once

#include <string>

#include "sim/viewer/http.h"

namespace csgsim::viewer {

/// Status line and header fields of a reply.
std::string reply_head(const Reply& reply, bool keeps_alive);

/// Status line and header fields of an event stream, which ends with its connection.
std::string stream_head();

}  // namespace csgsim::viewer
