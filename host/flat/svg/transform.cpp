#include "host/flat/svg/transform.h"

#include <string>
#include <vector>

#include "host/flat/svg/numbers.h"
#include "host/model/degrees.h"
#include "hw/base/error.h"
#include "hw/base/text.h"

namespace csgsim::flat::svg {

namespace {

struct Call {
  std::string_view name;
  std::vector<double> arguments;
};

[[noreturn]] void fail_transform(std::string_view text) {
  throw InputError("transform=\"" + printable(text) +
                   "\" is not a list of matrix(), translate(), scale(), rotate(), skewX(), skewY(); correct it");
}

glm::dmat3 columns(double a, double b, double c, double d, double e, double f) { return {a, b, 0, c, d, 0, e, f, 1}; }

glm::dmat3 rotation(double angle) {
  const double sine = model::sin_degrees(angle);
  const double cosine = model::cos_degrees(angle);
  return columns(cosine, sine, -sine, cosine, 0, 0);
}

double tangent(double angle) { return model::sin_degrees(angle) / model::cos_degrees(angle); }

glm::dmat3 matrix(const Call& call, std::string_view text) {
  const std::vector<double>& a = call.arguments;
  const std::size_t count = a.size();
  if (call.name == "matrix" && count == 6) return columns(a[0], a[1], a[2], a[3], a[4], a[5]);
  if (call.name == "translate" && count == 1) return columns(1, 0, 0, 1, a[0], 0);
  if (call.name == "translate" && count == 2) return columns(1, 0, 0, 1, a[0], a[1]);
  if (call.name == "scale" && count == 1) return columns(a[0], 0, 0, a[0], 0, 0);
  if (call.name == "scale" && count == 2) return columns(a[0], 0, 0, a[1], 0, 0);
  if (call.name == "rotate" && count == 1) return rotation(a[0]);
  if (call.name == "rotate" && count == 3) {
    return columns(1, 0, 0, 1, a[1], a[2]) * rotation(a[0]) * columns(1, 0, 0, 1, -a[1], -a[2]);
  }
  if (call.name == "skewX" && count == 1) return columns(1, 0, tangent(a[0]), 1, 0, 0);
  if (call.name == "skewY" && count == 1) return columns(1, tangent(a[0]), 0, 1, 0, 0);
  fail_transform(text);
}

Call read_call(Numbers& rest, std::string_view text) {
  Call call{rest.word(), {}};
  rest.skip_separators();
  if (!rest.take('(')) fail_transform(text);
  rest.skip_separators();
  while (!rest.take(')')) {
    const std::optional<double> number = rest.number();
    if (!number) fail_transform(text);
    call.arguments.push_back(*number);
    rest.skip_separators();
  }
  return call;
}

}  // namespace

glm::dmat3 read_transform(std::string_view text) {
  glm::dmat3 result(1);
  Numbers rest(text);
  rest.skip_separators();
  while (!rest.at_end()) {
    result = result * matrix(read_call(rest, text), text);
    rest.skip_separators();
  }
  return result;
}

}  // namespace csgsim::flat::svg
