#include "sim/viewer/instants.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "hw/base/error.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/facts.h"
#include "hw/isa/pieces.h"
#include "hw/isa/text.h"
#include "sim/debug/field_picture.h"
#include "sim/report/drawing.h"
#include "sim/report/pictures.h"
#include "sim/viewer/png.h"

namespace csgsim::viewer {

namespace {

constexpr std::uint64_t listed_before = 12;  // instructions shown in the listing
constexpr std::uint64_t listed_after = 24;
constexpr const char* enable = "E";

}  // namespace

/// Collects the colours of completed segments.
class Instants::Finished : public engine::Observer {
 public:
  explicit Finished(const isa::Program& program)
      : program_(program), colours_(std::size_t{program.shape.width} * program.shape.height, program.background) {}

  [[nodiscard]] bool reads_after(const isa::Instruction& /*instruction*/) const override { return false; }
  void after_segment(std::uint32_t segment, const engine::PixelState& state) override {
    if (program_.colour.width > 0 && !program_.segments[segment].instructions.empty()) put(state, colours_);
  }

  /// The colours of completed segments and of the current one.
  [[nodiscard]] std::vector<std::uint32_t> with(const engine::PixelState& state) const {
    std::vector<std::uint32_t> all = colours_;
    if (program_.colour.width > 0) put(state, all);
    return all;
  }

  [[nodiscard]] const std::vector<std::uint32_t>& colours() const { return colours_; }

 private:
  void put(const engine::PixelState& state, std::vector<std::uint32_t>& picture) const {
    const isa::Region region = state.region();
    std::vector<std::uint32_t> values(std::size_t{region.width} * region.height);
    state.read_field(program_.colour, values);
    for (std::uint32_t y = 0; y < region.height; ++y) {
      const auto row = std::span(values).subspan(std::size_t{y} * region.width, region.width);
      const std::size_t place = std::size_t{region.y + y} * program_.shape.width + region.x;
      std::ranges::copy(row, std::span(picture).subspan(place).begin());
    }
  }

  const isa::Program& program_;
  std::vector<std::uint32_t> colours_;
};

Instants::Instants(const isa::Program& program, const machines::Machine& machine)
    : program_(program),
      numbers_(program),
      clocks_(program, machine),
      engine_(engine::make_functional_engine(machine)),
      run_(engine_->begin(program)),
      finished_(std::make_unique<Finished>(program)) {}

Instants::~Instants() = default;

std::vector<std::string> Instants::fields() const {
  std::vector<std::string> names{enable};
  for (const isa::NamedField& field : program_.facts->fields) names.push_back(field.name);
  return names;
}

isa::Field Instants::field_named(const std::string& name) const {
  if (name.empty()) return program_.colour;
  if (name == enable) return {};
  const auto found = std::ranges::find(program_.facts->fields, name, &isa::NamedField::name);
  if (found == program_.facts->fields.end())
    throw InputError(fmt::format("there is no field '{}'; the fields are {}", name, fmt::join(fields(), ", ")));
  return found->field;
}

void Instants::go_to(std::uint64_t number) {
  if (number < numbers_.of(run_->place())) {
    run_ = engine_->begin(program_);
    finished_ = std::make_unique<Finished>(program_);
  }
  engine::Observer* const observers[] = {finished_.get()};
  run_->advance(number, observers);
}

std::uint64_t Instants::first_instruction_of(std::uint64_t primitive) const {
  std::uint64_t number = 0;
  for (const isa::Segment& segment : program_.segments) {
    for (const isa::Instruction& one : segment.instructions) {
      const std::uint32_t piece = one.origin.primitive;
      if (piece != isa::no_primitive && isa::primitive_of(*program_.facts, piece) == primitive) return number;
      ++number;
    }
  }
  throw InputError(fmt::format(
      "no instruction draws p{}: it is not visible or does not exist; choose another primitive", primitive));
}

std::vector<std::uint8_t> Instants::pixels_of(isa::Field field, std::string& scale) const {
  std::vector<std::uint8_t> pixels;
  if (field == program_.colour && field.width > 0) {
    scale = "colour";
    const bool is_begun = !program_.segments[run_->place().segment].instructions.empty();
    for (const std::uint32_t packed : is_begun ? finished_->with(*run_) : finished_->colours()) {
      const std::array<std::uint8_t, 3> channels = isa::unpack_colour(packed, field.width);
      pixels.insert(pixels.end(), channels.begin(), channels.end());
    }
    return pixels;
  }
  const debug::FieldPicture made = debug::draw_field(field, *run_, program_);
  scale = made.scale;
  if (made.picture.channels == 3) return made.picture.bytes;
  for (const std::uint8_t grey : made.picture.bytes) pixels.insert(pixels.end(), 3, grey);
  return pixels;
}

void Instants::tint(std::vector<std::uint8_t>& pixels) const {
  const isa::Region region = run_->region();
  const std::size_t words = (region.width + 63U) / 64U;
  std::vector<std::uint64_t> enabled(words * region.height);
  run_->read_enable(enabled);
  for (std::uint32_t y = 0; y < region.height; ++y) {
    for (std::uint32_t x = 0; x < region.width; ++x) {
      if ((enabled[y * words + x / 64U] >> (x % 64U) & 1U) == 0) continue;
      const std::size_t at = 3 * (std::size_t{region.y + y} * program_.shape.width + region.x + x);
      for (std::size_t i = 0; i < 3; ++i)
        pixels[at + i] = static_cast<std::uint8_t>((pixels[at + i] + report::mark_colour[i]) / 2);
    }
  }
}

nlohmann::ordered_json Instants::instruction_json(std::uint64_t number) const {
  const engine::Place place = numbers_.place(number);
  const isa::Instruction& instruction = program_.segments[place.segment].instructions[place.index];
  nlohmann::ordered_json json{{"number", number},
                              {"text", isa::text_of(instruction, program_.facts->fields)},
                              {"serves", report::purpose_text(instruction, *program_.facts)}};
  const std::uint32_t piece = instruction.origin.primitive;
  if (piece != isa::no_primitive) json["primitive"] = isa::primitive_of(*program_.facts, piece);
  const std::uint32_t against = instruction.origin.node;
  if (against != isa::no_primitive) json["against"] = isa::primitive_of(*program_.facts, against);
  return json;
}

std::uint64_t Instants::number_of(const InstantRequest& request) {
  if (request.primitive) return first_instruction_of(*request.primitive);
  return request.clock ? clocks_.first_not_issued(*request.clock, 0) : std::min(request.number, numbers_.count());
}

/// Adds the clocks of issue, or the reason why the machine's kind does not provide them.
void Instants::put_clocks(engine::Place place, nlohmann::ordered_json& instant) {
  try {
    const machines::ClockSpan span = clocks_.issue_span(place);
    instant["clocks"] = {span.begin, span.end};
  } catch (const InputError& error) {
    instant["no_clocks"] = error.what();
  }
}

nlohmann::ordered_json Instants::at(const InstantRequest& request) {
  const isa::Field field = field_named(request.field);
  go_to(number_of(request));
  const std::uint64_t number = numbers_.of(run_->place());
  std::string scale;
  std::vector<std::uint8_t> pixels = pixels_of(field, scale);
  if (request.is_tinted) tint(pixels);
  nlohmann::ordered_json instant{{"number", number},
                                 {"count", numbers_.count()},
                                 {"picture", png_url(pixels, program_.shape.width, program_.shape.height)},
                                 {"scale", scale},
                                 {"fields", fields()},
                                 {"instructions", nlohmann::ordered_json::array()}};
  const std::uint64_t first = number < listed_before ? 0 : number - listed_before;
  for (std::uint64_t i = first; i < std::min(number + listed_after, numbers_.count()); ++i)
    instant["instructions"].push_back(instruction_json(i));
  if (number == numbers_.count()) return instant;
  const engine::Place place = numbers_.place(number);
  put_clocks(place, instant);
  instant["segment"] = place.segment;
  const std::uint32_t piece = program_.segments[place.segment].instructions[place.index].origin.primitive;
  if (piece != isa::no_primitive) instant["piece"] = piece;
  return instant;
}

}  // namespace csgsim::viewer
