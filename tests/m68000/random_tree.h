#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "tests/m68000/tree.h"

namespace csgsim::m68000 {

/// A tree of 1 to `most` primitives that is balanced, left-deep or of random form, and a sequence of their surfaces. It
/// depends only on the seed and is the same on every computer.
class RandomTree {
 public:
  explicit RandomTree(std::uint32_t seed, std::size_t most = 60) : random_(seed) {
    primitives_ = 1 + below(most);
    const Form form = static_cast<Form>(below(3));
    tree_.root = grow(0, primitives_, form);
    for (std::size_t left = 2 * primitives_; left > 0; --left)
      flips_.push_back(static_cast<std::uint16_t>(below(primitives_)));
  }

  [[nodiscard]] const Tree& tree() const { return tree_; }
  [[nodiscard]] std::size_t primitives() const { return primitives_; }
  [[nodiscard]] const std::vector<std::uint16_t>& flips() const { return flips_; }

 private:
  enum class Form : std::uint8_t { balanced, left_deep, any };

  std::size_t below(std::size_t most) { return random_() % most; }

  /// Grows a subtree of the `count` primitives from `first` on; returns its index.
  std::size_t grow(std::size_t first, std::size_t count, Form form) {
    if (count == 1) {
      tree_.nodes.push_back({NodeKind::primitive, static_cast<std::uint16_t>(first), 0, 0});
      return tree_.nodes.size() - 1;
    }
    const std::size_t to_left = form == Form::balanced    ? (count + 1) / 2
                                : form == Form::left_deep ? count - 1
                                                          : 1 + below(count - 1);
    const std::size_t left = grow(first, to_left, form);
    const std::size_t right = grow(first + to_left, count - to_left, form);
    tree_.nodes.push_back({static_cast<NodeKind>(1 + below(3)), 0, left, right});
    return tree_.nodes.size() - 1;
  }

  std::mt19937 random_;
  std::size_t primitives_ = 0;
  Tree tree_;
  std::vector<std::uint16_t> flips_;
};

}  // namespace csgsim::m68000
