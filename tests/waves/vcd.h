#pragma once

#include <cstdint>
#include <istream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::test {

/// A value change dump, read by the rules of IEEE 1364-2005, 18.2, with variables of the type `string`.
class Vcd {
 public:
  /// Throws std::runtime_error for unknown syntax, a decreasing time, a range that differs from the variable's width, a
  /// section ($dumpvars, $dumpoff, $dumpon) that is misplaced or lacks variables, and a change before $dumpvars or
  /// between $dumpoff and $dumpon; std::out_of_range for a change of an unknown variable.
  explicit Vcd(std::string_view text);

  /// Full names, with dots, `top.part.name`.
  [[nodiscard]] std::vector<std::string> names() const;

  /// The variable's value at that time, as in the file: digits, z or x, or a text. Throws std::out_of_range for an
  /// unknown name, and before the first value.
  [[nodiscard]] std::string at(const std::string& name, std::uint64_t time) const;

  /// The value as a number; empty unless it consists of digits.
  [[nodiscard]] std::optional<std::uint64_t> number_at(const std::string& name, std::uint64_t time) const;

  [[nodiscard]] std::uint64_t first_time() const { return first_time_; }
  [[nodiscard]] std::uint64_t last_time() const { return last_time_; }

 private:
  using Changes = std::map<std::uint64_t, std::string>;

  void read_header(std::istream& in);
  void read_changes(std::istream& in);

  std::map<std::string, std::string> codes_;  ///< codes by name
  std::map<std::string, Changes> changes_;    ///< changes by code
  std::uint64_t first_time_ = 0;
  std::uint64_t last_time_ = 0;
};

}  // namespace csgsim::test
