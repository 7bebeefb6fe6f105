#include "host/commands/expression.h"

#include <vector>

namespace csgsim::commands {

namespace {

model::Operator to_operator(const Item& sign) {
  if (sign.text == "+") return model::Operator::unite;
  return sign.text == "-" ? model::Operator::subtract : model::Operator::intersect;
}

int strength(const Item& sign) { return sign.text == "*" ? 2 : 1; }

/// Dijkstra's shunting-yard algorithm, which needs no recursion for nested parentheses.
class Yard {
 public:
  Yard(Cursor& line, const Algebra& algebra) : line_(line), algebra_(algebra) {}

  std::uint32_t read() {
    operand();
    while (!line_.at_end()) {
      if (line_.is(")")) {
        close();
      } else if (line_.is("+") || line_.is("-") || line_.is("*")) {
        const Item& sign = line_.take();
        reduce(strength(sign));
        waiting_.push_back(&sign);
        operand();
      } else {
        line_.fail_here("expected +, -, * or the end of the line");
      }
    }
    reduce(1);
    if (!waiting_.empty()) line_.fail(waiting_.back()->offset, "this `(` is not closed; add a `)`");
    return solids_.back();
  }

 private:
  void operand() {
    while (line_.is("(")) waiting_.push_back(&line_.take());
    if (!line_.is(Kind::word))
      line_.fail_here("expected the name of a solid, or block, cylinder, cone, sphere, sweep, curve or patch");
    solids_.push_back(algebra_.solid(line_.take()));
  }

  void close() {
    reduce(1);
    if (waiting_.empty()) line_.fail(line_.offset(), "this `)` has no matching `(`; remove it");
    waiting_.pop_back();
    line_.take();
  }

  /// Applies the waiting operators of at least the given strength, back to an open parenthesis.
  void reduce(int weakest) {
    while (!waiting_.empty() && !waiting_.back()->is("(") && strength(*waiting_.back()) >= weakest) {
      const std::uint32_t right = solids_.back();
      solids_.pop_back();
      const Item& sign = *waiting_.back();
      solids_.back() = algebra_.combine(to_operator(sign), solids_.back(), right, sign);
      waiting_.pop_back();
    }
  }

  Cursor& line_;
  const Algebra& algebra_;
  std::vector<const Item*> waiting_;  ///< operators and open parentheses
  std::vector<std::uint32_t> solids_;
};

}  // namespace

std::uint32_t read_expression(Cursor& line, const Algebra& algebra) { return Yard(line, algebra).read(); }

}  // namespace csgsim::commands
