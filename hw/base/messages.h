#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace csgsim {

/// Writes to standard error as it is; where that cannot be written nothing happens.
void tell(std::string_view text) noexcept;

/// One line on standard error, made harmless by printable().
void tell_line(std::string_view line) noexcept;

/// While it lives, the lines that this thread tells are kept instead, as they are.
class KeptLines {
 public:
  KeptLines() noexcept;
  ~KeptLines();
  KeptLines(const KeptLines&) = delete;
  KeptLines& operator=(const KeptLines&) = delete;

  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }

 private:
  friend void tell_line(std::string_view line) noexcept;

  std::vector<std::string> lines_;
  KeptLines* before_;
};

/// Standard input, output and error that are closed are opened so that they cannot be used: a file that is opened later
/// must not take their numbers.
void keep_standard_numbers();

}  // namespace csgsim
