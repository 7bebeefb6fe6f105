// The option --json of studies.
// Used by the studies of software.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

#include "sim/session/options/option_list.h"

namespace csgsim::studies {

/// Option --json of a study: exports the inputs of its counts, so that other programs can verify them.
class JsonExport {
 public:
  /// `action` begins the help text, as in `Write the vertices of each mesh`.
  void add_to(session::OptionList& command, const std::string& action);

  [[nodiscard]] bool is_requested() const { return !file_.empty(); }

  /// Called with each item of the list.
  using Put = std::function<void(const nlohmann::ordered_json& item)>;

  /// Writes the file if it was requested: the facts, followed by a list named `list_name` with one item per line.
  /// Throws UsageError if the file is also an input, InputError if it cannot be written.
  void write(std::span<const std::filesystem::path> inputs, const std::function<nlohmann::ordered_json()>& make_facts,
             std::string_view list_name, const std::function<void(const Put& put)>& write_items) const;

 private:
  std::string file_;
};

}  // namespace csgsim::studies
