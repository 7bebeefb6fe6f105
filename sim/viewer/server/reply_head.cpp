#include "sim/viewer/server/reply_head.h"

#include <boost/beast/http/status.hpp>
#include <ostream>
#include <string_view>

namespace csgsim::viewer {

namespace {

void add_status(std::string& head, int status) {
  const auto reason =
      boost::beast::http::obsolete_reason(boost::beast::http::int_to_status(static_cast<unsigned>(status)));
  head += "HTTP/1.1 " + std::to_string(status) + " ";
  head.append(reason.data(), reason.size());
  head += "\r\n";
}

void add_field(std::string& head, std::string_view name, std::string_view value) {
  head.append(name).append(": ").append(value).append("\r\n");
}

/// Forbids caching, framing, type guessing and referrers; a page may load only what this server sends.
void add_policy(std::string& head, bool has_scripts) {
  add_field(head, "Cache-Control", "no-store");
  const std::string own = has_scripts ? "'unsafe-inline'" : "'self'";
  add_field(head, "Content-Security-Policy",
            "default-src 'none'; script-src " + own + "; style-src " + own + "; img-src data:; connect-src " +
                (has_scripts ? "'none'" : "'self'") + "; frame-ancestors 'none'; base-uri 'none'; form-action 'none'");
  add_field(head, "Cross-Origin-Opener-Policy", "same-origin");
  add_field(head, "Cross-Origin-Resource-Policy", "same-origin");
  add_field(head, "Referrer-Policy", "no-referrer");
  add_field(head, "X-Content-Type-Options", "nosniff");
}

}  // namespace

std::string reply_head(const Reply& reply, bool keeps_alive) {
  std::string head;
  add_status(head, reply.status);
  add_field(head, "Content-Type", reply.type);
  add_field(head, "Content-Length", std::to_string(reply.body.size()));
  add_field(head, "Connection", keeps_alive ? "keep-alive" : "close");
  if (reply.status == 405) add_field(head, "Allow", "GET, POST");
  add_policy(head, reply.has_scripts);
  return head + "\r\n";
}

std::string stream_head() {
  std::string head;
  add_status(head, 200);
  add_field(head, "Content-Type", "text/event-stream");
  add_field(head, "Connection", "close");
  add_policy(head, false);
  return head + "\r\n";
}

}  // namespace csgsim::viewer
