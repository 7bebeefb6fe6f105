#include "hw/bit_serial_memory/root_program.h"

#include <vector>

namespace csgsim::bit_serial_memory {

namespace {

/// Rows used while the root is computed.
class Root {
 public:
  Root(isa::Field field, ColumnLogic& logic) : field_(field), w_(field.width / 2U), logic_(logic) {}

  void take() {
    for (unsigned step = 0; step < w_; ++step) find_bit(w_ - 1 - step);
    correct_remainder();
    store();
  }

 private:
  [[nodiscard]] Row target(unsigned bit) const { return static_cast<Row>(field_.base + bit); }
  [[nodiscard]] Row root(unsigned bit) const { return logic_.map().sum(bit); }
  [[nodiscard]] Row remainder(unsigned bit) const { return logic_.map().sum(w_ + bit); }
  [[nodiscard]] Row difference(unsigned bit) const { return logic_.map().spare(bit); }

  /// The current remainder, followed by the next two bits of the square.
  [[nodiscard]] std::vector<Bit> shifted(unsigned k) const {
    std::vector<Bit> bits{Bit::of_row(target(2 * k)), Bit::of_row(target(2 * k + 1))};
    for (unsigned bit = 0; bit < remainder_bits_; ++bit) bits.push_back(Bit::of_row(remainder(bit)));
    return bits;
  }

  /// A bit of 4q + 1, where q is the part of the root above bit k.
  [[nodiscard]] Bit subtrahend(unsigned bit, unsigned k) const {
    if (bit < 2) return Bit::constant(bit == 0);
    const unsigned place = k + bit - 1;
    return place < w_ ? Bit::of_row(root(place)) : Bit::constant(false);
  }

  void find_bit(unsigned k) {
    const std::vector<Bit> from = shifted(k);
    logic_.begin_chain(Chain::difference, false);
    for (unsigned bit = 0; bit < from.size(); ++bit) logic_.sum(difference(bit), from[bit], subtrahend(bit, k));
    logic_.assign_chain(root(k), true);
    remainder_bits_ = w_ - k + 1;  // the remainder is at most twice the root
    for (unsigned bit = remainder_bits_; bit-- > 0;)
      logic_.choose(remainder(bit), root(k), Bit::of_row(difference(bit)), from[bit]);
  }

  /// If the root is even, the remainder is corrected to that of the next odd number.
  void correct_remainder() {
    logic_.assign(difference(0), Bit::of_row(root(0)), true);
    for (unsigned bit = 1; bit <= w_; ++bit)
      logic_.combine(BinaryOp::and_not, difference(bit), Bit::of_row(root(bit - 1)), Bit::of_row(root(0)));
    logic_.begin_chain(Chain::difference, false);
    for (unsigned bit = 0; bit <= w_; ++bit)
      logic_.sum(remainder(bit), Bit::of_row(remainder(bit)), Bit::of_row(difference(bit)));
  }

  void store() {
    for (unsigned bit = 0; bit <= w_; ++bit) logic_.store(target(bit), Bit::of_row(remainder(bit)), Mask::enable);
    for (unsigned bit = 0; bit < w_; ++bit) logic_.store(target(w_ + 1 + bit), Bit::of_row(root(bit)), Mask::enable);
  }

  const isa::Field field_;
  const unsigned w_;
  ColumnLogic& logic_;
  unsigned remainder_bits_ = 0;  ///< width of the remainder
};

}  // namespace

void write_root(isa::Field field, ColumnLogic& logic) { Root(field, logic).take(); }

}  // namespace csgsim::bit_serial_memory
