#include "sim/viewer/door.h"

#include <rapidcheck.h>

#include "tests/support/test.h"

using namespace csgsim;

namespace {

const viewer::Door door{8080, "0123456789abcdef0123456789abcdef"};

viewer::Request own_post() {
  return {.method = "POST",
          .path = "/" + door.token + "/draw",
          .host = "127.0.0.1:8080",
          .origin = "http://127.0.0.1:8080",
          .site = "same-origin",
          .content_type = "application/json"};
}

viewer::Request own_get() {
  return {.method = "GET", .path = "/" + door.token + "/", .host = "localhost:8080", .site = "none"};
}

/// Status of the refusal; 200 if admitted.
int status_of(const viewer::Request& request) {
  const viewer::Admission admission = viewer::admit(door, request);
  return admission.is_admitted ? 200 : admission.refusal.status;
}

}  // namespace

TEST_CASE("the access check admits the page's requests and returns the path after the token") {
  CHECK(viewer::admit(door, own_post()).path == "draw");
  const viewer::Request get = own_get();
  CHECK(viewer::admit(door, get).is_admitted);
  CHECK(viewer::admit(door, get).path == "");
  viewer::Request plain = own_post();
  plain.site = "";
  plain.content_type = "application/json; charset=utf-8";
  CHECK(status_of(plain) == 200);
  CHECK(door.address() == "http://127.0.0.1:8080/0123456789abcdef0123456789abcdef/");
}

TEST_CASE("the access check rejects any other host or origin or site or token or type") {
  const auto with = [](std::string viewer::Request::*member, const std::string& value, viewer::Request request) {
    request.*member = value;
    return status_of(request);
  };
  for (const char* host : {"", "127.0.0.1", "127.0.0.1:80", "127.0.0.1:8080 ", "localhost:8081", "evil.example:8080",
                           "LOCALHOST:8080", "[::1]:8080"}) {
    CHECK(with(&viewer::Request::host, host, own_post()) == 403);
    CHECK(with(&viewer::Request::host, host, own_get()) == 403);
  }
  for (const char* origin :
       {"null", "http://evil.example", "https://127.0.0.1:8080", "http://127.0.0.1:8080/", "http://127.0.0.1:80801"}) {
    CHECK(with(&viewer::Request::origin, origin, own_post()) == 403);
    CHECK(with(&viewer::Request::origin, origin, own_get()) == 403);
  }
  CHECK(with(&viewer::Request::origin, "", own_post()) == 403);
  for (const char* site : {"cross-site", "same-site"}) {
    CHECK(with(&viewer::Request::site, site, own_post()) == 403);
    CHECK(with(&viewer::Request::site, site, own_get()) == 403);
  }
  CHECK(with(&viewer::Request::site, "none", own_post()) == 403);
  for (const char* type : {"", "text/plain", "application/jsonx", "multipart/form-data"})
    CHECK(with(&viewer::Request::content_type, type, own_post()) == 415);
}

TEST_CASE("the access check rejects any path with a changed or missing token") {
  CHECK(rc::check([] {
    viewer::Request request = own_post();
    const auto at = *rc::gen::inRange<std::size_t>(0, door.token.size() + 1);
    const auto byte = *rc::gen::arbitrary<char>();
    RC_PRE(request.path[at] != byte);
    request.path[at] = byte;
    RC_ASSERT(status_of(request) == 403);
  }));
  CHECK(rc::check([](const std::string& path) {
    viewer::Request request = own_post();
    request.path = path;
    RC_ASSERT(status_of(request) == 403);
  }));
}

TEST_CASE("access tokens are distinct and have 32 hexadecimal digits") {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) {
    const std::string token = viewer::make_token();
    CHECK(token.size() == 32);
    CHECK(token.find_first_not_of("0123456789abcdef") == token.npos);
    tokens.insert(token);
  }
  CHECK(tokens.size() == 100);
}

TEST_CASE("a request's path has the token between its first two slashes") {
  const auto status = [](const std::string& path) {
    viewer::Request request = own_get();
    request.path = path;
    return status_of(request);
  };
  CHECK(status("/" + door.token + "/") == 200);
  CHECK(status("/" + door.token + "/a/b") == 200);
  for (const std::string& path :
       {std::string(), std::string("/"), std::string("//"), "/" + door.token, door.token + "/", "x" + door.token + "/",
        "//" + door.token + "/", "/" + door.token + "0/", "/" + door.token.substr(1) + "/", "/x/" + door.token + "/"})
    CHECK(status(path) == 403);
  viewer::Request request = own_get();
  request.path = "/" + door.token + "/a/b";
  CHECK(viewer::admit(door, request).path == "a/b");
  CHECK_FALSE(viewer::Admission{}.is_admitted);
  CHECK(viewer::Door{}.port == 0);
}

TEST_CASE("every rejected access states its reason") {
  const auto refusal = [](std::string viewer::Request::*member, const char* value) {
    viewer::Request request = own_post();
    request.*member = value;
    const viewer::Reply reply = viewer::admit(door, request).refusal;
    return std::to_string(reply.status) + " " + reply.body;
  };
  const auto refused = [](const std::string& status, const std::string& why) {
    return status + " {\"error\":\"csgsim view " + why + "\"}\n";
  };
  CHECK(refusal(&viewer::Request::host, "h") == refused("403", "only accepts requests to 127.0.0.1 and localhost"));
  CHECK(refusal(&viewer::Request::origin, "o") == refused("403", "only accepts requests from its own page"));
  CHECK(refusal(&viewer::Request::site, "cross-site") == refused("403", "only accepts requests from its own page"));
  CHECK(refusal(&viewer::Request::path, "/x/") == refused("403", "requires the complete address that it printed"));
  CHECK(refusal(&viewer::Request::content_type, "text/plain") == refused("415", "only accepts application/json"));
}
