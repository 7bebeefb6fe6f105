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
  /// Throws std::runtime_error for what it does not know, a time that goes back, a range of more or fewer bits than the
  /// variable has, a section ($dumpvars, $dumpoff, $dumpon) without all variables or where it has no business, and a
  /// change before $dumpvars or between $dumpoff and $dumpon; std::out_of_range for a change of an unknown variable.
  explicit Vcd(std::string_view text);

  /// Full names, with dots, `top.part.name`.
  [[nodiscard]] std::vector<std::string> names() const;

  /// What the variable shows at that time, as the file has it: digits, z or x, or a text. Throws std::out_of_range for
  /// a name that there is not, and before the first value.
  [[nodiscard]] std::string at(const std::string& name, std::uint64_t time) const;

  /// The same as a number; none if it is not all digits.
  [[nodiscard]] std::optional<std::uint64_t> number_at(const std::string& name, std::uint64_t time) const;

  [[nodiscard]] std::uint64_t first_time() const { return first_time_; }
  [[nodiscard]] std::uint64_t last_time() const { return last_time_; }

 private:
  using Changes = std::map<std::uint64_t, std::string>;

  void read_header(std::istream& in);
  void read_changes(std::istream& in);

  std::map<std::string, std::string> codes_;  ///< of names
  std::map<std::string, Changes> changes_;    ///< of codes
  std::uint64_t first_time_ = 0;
  std::uint64_t last_time_ = 0;
};

}  // namespace csgsim::test
