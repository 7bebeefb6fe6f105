// Writes messages to standard error.
// Used by host/convex, host/read, host/setup and sim.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace csgsim {

/// Writes the text unchanged to standard error; write errors are ignored.
void write_message(std::string_view text) noexcept;

/// Writes one line to standard error, after printable().
void report_line(std::string_view line) noexcept;

/// Collects the lines that this thread passes to report_line(), unchanged, instead of writing them.
class CollectedLines {
 public:
  CollectedLines() noexcept;
  ~CollectedLines();
  CollectedLines(const CollectedLines&) = delete;
  CollectedLines& operator=(const CollectedLines&) = delete;

  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }

 private:
  friend void report_line(std::string_view line) noexcept;

  std::vector<std::string> lines_;
  CollectedLines* before_;
};

/// Opens /dev/null for each closed standard stream, so that no file opened later gets the stream's descriptor number.
void open_closed_standard_streams();

}  // namespace csgsim
