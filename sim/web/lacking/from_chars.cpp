#include <charconv>

#include "sim/web/lacking/number.h"

// NOLINTBEGIN(cert-dcl58-cpp): missing in libc++ 19
namespace std {

from_chars_result from_chars(const char* first, const char* last, double& value, chars_format /*format*/) {
  return csgsim::web::read_number(first, last, value);
}

from_chars_result from_chars(const char* first, const char* last, float& value, chars_format /*format*/) {
  return csgsim::web::read_number(first, last, value);
}

}  // namespace std
// NOLINTEND(cert-dcl58-cpp)
