// Published quantities of chips beside the model.
// Used by sim/app.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/process/process.h"

// The chips of a process's time: what is published about them, and what the model gives. A quantity is either fitted by
// one parameter of the process or predicted, never both.
namespace csgsim::process {

enum class Use : std::uint8_t {
  fitted,     ///< a parameter was chosen so that the model gives the quantity
  predicted,  ///< no parameter depends on the quantity
  not_found,  ///< no publication that we could read states the quantity; the model's value is a prediction
};

/// A published quantity.
struct Quantity {
  std::string_view what;  ///< with its unit
  double published = 0;   ///< 0 if not found
  Use use = Use::predicted;
  std::string_view parameter;  ///< fitted to the quantity; empty if not fitted
  double tolerance = 0;        ///< accepted deviation of the model, as a fraction of what is published
  std::string_view reason;     ///< why the tolerance of a prediction is not less
  std::string_view source;     ///< the publication, or where it is missing
};

struct Comparison {
  Quantity quantity;
  double model = 0;

  /// The model's deviation from what is published, as a fraction of the latter; 0 if not found.
  [[nodiscard]] double deviation() const { return quantity.published > 0 ? model / quantity.published - 1 : 0; }
};

/// Loads a built-in machine by name.
using LoadMachine = std::function<machines::Machine(std::string_view name)>;

/// All quantities for a built-in process, also with changed parameters; empty for other processes.
std::vector<Comparison> compare_published(const Process& process, const LoadMachine& load);

}  // namespace csgsim::process
