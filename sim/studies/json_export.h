#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

#include "sim/session/options/option_list.h"

namespace csgsim::studies {

/// --json of a study: what it is made from, by which others can judge its counts.
class JsonExport {
 public:
  /// `what` is in the file.
  void add_to(session::OptionList& command, const std::string& what);

  [[nodiscard]] bool is_asked() const { return !file_.empty(); }

  /// Called with each item of the list.
  using Put = std::function<void(const nlohmann::ordered_json& item)>;

  /// Writes the file, if it is asked for: the facts, and behind them a list with that name, an item a line. Throws
  /// UsageError for a file that is read, InputError where it cannot be written.
  void write(std::span<const std::filesystem::path> inputs, const std::function<nlohmann::ordered_json()>& facts,
             std::string_view list, const std::function<void(const Put& put)>& items) const;

 private:
  std::string file_;
};

}  // namespace csgsim::studies
