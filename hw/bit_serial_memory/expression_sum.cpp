#include "hw/bit_serial_memory/expression_sum.h"

#include <algorithm>
#include <bit>
#include <optional>

namespace csgsim::bit_serial_memory {

namespace {

static_assert(isa::max_linear_width < 64);

constexpr std::uint64_t low_bits(unsigned bits) { return (std::uint64_t{1} << bits) - 1; }

struct Digit {
  unsigned place = 0;
  bool negative = false;
};

/// Non-adjacent form of the number, modulo 2^width: digits 1 and -1.
std::vector<Digit> digits_of(std::uint64_t number, unsigned width) {
  std::vector<Digit> digits;
  for (unsigned place = 0; place < width && number != 0; ++place) {
    if ((number >> place & 1U) == 0) continue;
    const bool negative = (number >> place & 3U) == 3;
    digits.push_back({place, negative});
    if (negative)
      number = (number + (std::uint64_t{1} << place)) & low_bits(width);
    else
      number -= std::uint64_t{1} << place;
  }
  return digits;
}

std::vector<Term> terms_by_digit(std::uint64_t number, std::span<const Row> coordinate, unsigned width) {
  std::vector<Term> terms;
  for (const Digit digit : digits_of(number, width))
    terms.push_back({digit.place, digit.negative, {coordinate.begin(), coordinate.end()}, 0, 0});
  return terms;
}

std::vector<Term> terms_by_coordinate(std::uint64_t number, std::span<const Row> coordinate, unsigned width) {
  std::vector<Term> terms;
  for (unsigned bit = 0; bit < coordinate.size() && bit < width; ++bit) {
    const std::uint64_t multiple = number << bit & low_bits(width);
    if (multiple == 0) break;
    terms.push_back({static_cast<unsigned>(std::countr_zero(multiple)), false, {}, coordinate[bit], multiple});
  }
  return terms;
}

std::uint64_t bits_to_add(const std::vector<Term>& terms, unsigned width) {
  std::uint64_t bits = 0;
  for (const Term& term : terms) bits += width - term.first;
  return bits;
}

Bit bit_of(const Term& term, unsigned bit) {
  if (term.rows.empty()) return (term.multiple >> bit & 1U) != 0 ? Bit::of_row(term.coordinate) : Bit::constant(false);
  const unsigned place = bit - term.first;
  return place < term.rows.size() ? Bit::of_row(term.rows[place]) : Bit::constant(false);
}

/// Adds a term to the sum; sum bits below `first_kept` are no longer needed.
void add(const Term& term, unsigned first_kept, std::vector<Bit>& sum, ColumnLogic& logic) {
  if (term.rows.empty()) logic.hold(term.coordinate);
  logic.begin_chain(term.subtracted ? Chain::difference : Chain::sum, false);
  for (unsigned bit = term.first; bit < sum.size(); ++bit) {
    if (bit < first_kept) {
      logic.carry(sum[bit], bit_of(term, bit));
      continue;
    }
    const Row target = logic.map().sum(bit);
    logic.sum(target, sum[bit], bit_of(term, bit));
    sum[bit] = Bit::of_row(target);
  }
}

template <class RowOf>
std::vector<Row> rows_of(unsigned bits, const RowOf& row_of) {
  std::vector<Row> rows;
  for (unsigned bit = 0; bit < bits; ++bit) rows.push_back(row_of(bit));
  return rows;
}

}  // namespace

std::vector<Term> terms_of(std::int64_t coefficient, std::span<const Row> coordinate, unsigned width) {
  const std::uint64_t number = static_cast<std::uint64_t>(coefficient) & low_bits(width);
  if (number == 0 || coordinate.empty()) return {};
  std::vector<Term> by_digit = terms_by_digit(number, coordinate, width);
  std::vector<Term> by_coordinate = terms_by_coordinate(number, coordinate, width);
  return bits_to_add(by_digit, width) <= bits_to_add(by_coordinate, width) ? by_digit : by_coordinate;
}

std::vector<Bit> sum_expression(const isa::Linear& linear, RequiredBits required, ColumnLogic& logic) {
  const RowMap& map = logic.map();
  std::vector<Term> terms =
      terms_of(linear.a, rows_of(map.x_bits, [&](unsigned bit) { return map.x(bit); }), linear.width);
  for (Term& term : terms_of(linear.b, rows_of(map.y_bits, [&](unsigned bit) { return map.y(bit); }), linear.width))
    terms.push_back(std::move(term));
  std::ranges::stable_sort(terms, [](const Term& one, const Term& other) { return one.first > other.first; });

  std::vector<Bit> sum;
  for (unsigned bit = 0; bit < linear.width; ++bit)
    sum.push_back(Bit::constant((static_cast<std::uint64_t>(linear.c) >> bit & 1U) != 0));
  const unsigned first_required = required.sign_alone ? linear.width - 1U : required.first;
  for (std::size_t i = 0; i < terms.size(); ++i) add(terms[i], i + 1 == terms.size() ? first_required : 0, sum, logic);
  return sum;
}

}  // namespace csgsim::bit_serial_memory
