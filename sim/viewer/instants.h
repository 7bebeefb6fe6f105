// Pixel memory between two instructions.
// Used by drawings.h.
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

/// A request for the state at an instant.
struct InstantRequest {
  std::uint64_t number = 0;  ///< number of instructions before it
  std::string field;         ///< name of a field, or `E`; empty: the colour
  bool is_tinted = false;    ///< tint the enabled pixels
  // Alternatives to the number: the first instruction that serves the primitive, or the first one not completely issued
  // at the clock.
  std::optional<std::uint64_t> primitive{};
  std::optional<std::uint64_t> clock{};
};

/// A run at the functional level that can be inspected before any of its instructions.
class Instants {
 public:
  /// Both arguments must outlive this object.
  Instants(const isa::Program& program, const machines::Machine& machine);
  ~Instants();

  /// JSON with pixel memory at that instant as a picture, the next instruction (its purpose, its clocks of issue, its
  /// segment, the piece that it draws), and the instructions around it. If a skip passes the requested number, `number`
  /// of the result is the actual position. Throws InputError for an unknown field.
  nlohmann::ordered_json at(const InstantRequest& request);

  /// Names of the available fields.
  [[nodiscard]] std::vector<std::string> fields() const;

 private:
  class Finished;

  void go_to(std::uint64_t number);
  [[nodiscard]] std::uint64_t number_of(const InstantRequest& request);
  [[nodiscard]] std::uint64_t first_instruction_of(std::uint64_t primitive) const;
  [[nodiscard]] isa::Field field_named(const std::string& name) const;
  [[nodiscard]] std::vector<std::uint8_t> pixels_of(isa::Field field, std::string& scale) const;
  void tint(std::vector<std::uint8_t>& pixels) const;
  [[nodiscard]] nlohmann::ordered_json instruction_json(std::uint64_t number) const;
  void put_clocks(engine::Place place, nlohmann::ordered_json& instant);

  const isa::Program& program_;
  engine::Numbers numbers_;
  debug::Clocks clocks_;
  std::unique_ptr<engine::Engine> engine_;
  std::unique_ptr<engine::Run> run_;
  std::unique_ptr<Finished> finished_;
};

}  // namespace csgsim::viewer
