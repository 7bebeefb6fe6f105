#include "host/read/indices.h"

#include <cmath>

namespace csgsim::read {

namespace {

std::uint32_t read_index(const Arguments& arguments, ValueView value, std::size_t points) {
  const double number = arguments.read_number(value, "the index of a point");
  if (!(number >= 0 && number < static_cast<double>(points))) {
    arguments.fail(value, "there is no points[{}]; {}", number,
                   points == 0 ? "there are none" : fmt::format("there are points[0] to points[{}]", points - 1));
  }
  if (number != std::floor(number)) arguments.fail(value, "the index of a point must be a whole number");
  return static_cast<std::uint32_t>(number);
}

}  // namespace

std::vector<std::uint32_t> read_indices(const Arguments& arguments, ValueView list, std::size_t points) {
  if (!list.is(ValueKind::vector)) arguments.fail(list, "expected a vector of indices of points");
  std::vector<std::uint32_t> indices;
  list.for_each([&](ValueView value) { indices.push_back(read_index(arguments, value, points)); });
  return indices;
}

}  // namespace csgsim::read
