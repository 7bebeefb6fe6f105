#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "hw/machines/machine.h"
#include "sim/debug/clocks.h"
#include "sim/engine/run.h"

namespace csgsim::viewer {

/// What is asked of an instant.
struct InstantWish {
  std::uint64_t number = 0;  ///< instructions that come before it
  std::string field;         ///< name of a field, or `E`; empty: the colour
  bool is_tinted = false;    ///< enabled pixels are
  // In place of a number: before the first instruction that serves the primitive, or of which something is still to be
  // issued when the clock begins.
  std::optional<std::uint64_t> primitive{};
  std::optional<std::uint64_t> clock{};
};

/// A run that is looked at before any of its instructions, at the functional level.
class Instants {
 public:
  /// Both have to outlive it.
  Instants(const isa::Program& program, const machines::Machine& machine);
  ~Instants();

  /// What stands in pixel memory there, as a picture; which instruction comes next, whom it serves, in which clocks it
  /// is issued, in which segment it is and which piece it draws; and the instructions around it. A skip may pass the
  /// number: `number` tells where it is. Throws InputError for a field that does not exist.
  nlohmann::ordered_json at(const InstantWish& wish);

  /// Names of fields that can be asked for.
  [[nodiscard]] std::vector<std::string> fields() const;

 private:
  class Finished;

  void go_to(std::uint64_t number);
  [[nodiscard]] std::uint64_t number_of(const InstantWish& wish);
  [[nodiscard]] std::uint64_t first_of(std::uint64_t primitive) const;
  [[nodiscard]] isa::Field field_named(const std::string& name) const;
  [[nodiscard]] std::vector<std::uint8_t> pixels_of(isa::Field field, std::string& scale) const;
  void tint(std::vector<std::uint8_t>& pixels) const;
  [[nodiscard]] nlohmann::ordered_json told_of(std::uint64_t number) const;
  void put_clocks(engine::Place place, nlohmann::ordered_json& instant);

  const isa::Program& program_;
  engine::Numbers numbers_;
  debug::Clocks clocks_;
  std::unique_ptr<engine::Engine> engine_;
  std::unique_ptr<engine::Run> run_;
  std::unique_ptr<Finished> finished_;
};

}  // namespace csgsim::viewer
