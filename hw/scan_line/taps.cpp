#include "hw/scan_line/taps.h"

#include <array>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "hw/isa/instruction_numbers.h"
#include "hw/wave/instruction_taps.h"
#include "hw/wave/pixel_taps.h"
#include "hw/wave/segments.h"

namespace csgsim::scan_line {

namespace {

using wave::Number;
using wave::Tap;

constexpr unsigned row_bits = 16;
constexpr unsigned sum_bits = 64;

using ReadBeat = std::function<Beat()>;

Number row_of(std::size_t line, const isa::Program& program) {
  return line < program.segments.size() ? Number(program.segments[line].region.y) : std::nullopt;
}

Tap activity_tap(const std::string& part, std::function<std::string_view()> read) {
  return wave::text(part + ".activity", [read = std::move(read)] { return std::string(read()); });
}

std::string_view kind_of(const Beat& beat) {
  constexpr auto names = std::to_array<std::string_view>({"", "clear", "instruction", "mark"});
  return beat.packet == nullptr ? "" : names.at(static_cast<std::size_t>(beat.packet->kind));
}

/// Whether words of F and A arrive with the beat.
bool brings_words(const Beat& beat) {
  return beat.packet != nullptr && beat.packet->brings_f() && beat.number < beat.packet->words;
}

/// Taps of the instruction to whose packet the beat belongs, and `.packet` and `.beat`; with a shape, also the words
/// that arrive at the cell: `.a`, `.f` and, for degree 2, `.aa`.
std::vector<Tap> packet_taps(const std::string& part, const ReadBeat& beat, std::uint32_t cell,
                             const isa::Program& program, std::optional<WordShape> shape) {
  std::vector<Tap> taps =
      wave::instruction_taps(part, program, [beat, firsts = isa::first_instruction_numbers(program)]() -> Number {
        const Packet* const at = beat().packet;
        if (at == nullptr || at->kind != PacketKind::instruction) return std::nullopt;
        return firsts[at->segment] + at->index;
      });
  taps.push_back(wave::text(part + ".packet", [beat] { return std::string(kind_of(beat())); }));
  taps.push_back(wave::number(part + ".beat", 16, [beat] {
    const Beat at = beat();
    return kind_of(at).empty() ? std::nullopt : Number(at.number);
  }));
  if (!shape) return taps;
  const auto word = [&](const char* name, std::uint64_t BeatWords::*which) {
    taps.push_back(wave::hexadecimal(part + name, f_bits(shape->cell), [beat, cell, which, form = shape->cell] {
      const Beat at = beat();
      return brings_words(at) ? Number(arriving_words(at, cell, form).*which) : std::nullopt;
    }));
  };
  word(".a", &BeatWords::a);
  word(".f", &BeatWords::f);
  if (shape->degree > 1) word(".aa", &BeatWords::aa);
  return taps;
}

}  // namespace

std::vector<Tap> host_taps(const LineHost& host, const isa::Program& program) {
  return {activity_tap("host", [&host] { return host.activity(); }),
          wave::number("host.line", row_bits, [&host, &program] { return row_of(host.line(), program); })};
}

std::vector<Tap> chain_taps(const std::string& suffix, const ChainParts& parts, const isa::Program& program,
                            WordShape shape) {
  const std::string link = "link" + suffix;
  const std::string entry = "entry" + suffix;
  const std::string refresh = "refresh" + suffix;
  std::vector<Tap> taps{
      activity_tap(link, [parts] { return parts.link.activity(); }),
      wave::number(link + ".line", row_bits,
                   [parts, &program]() -> Number {
                     const std::optional<std::uint32_t> line = parts.link.line();
                     return line ? row_of(*line, program) : std::nullopt;
                   }),
      wave::number(link + ".fill", 32,
                   [parts] { return Number(static_cast<std::uint64_t>(parts.words.num_available())); }),
      activity_tap(entry, [parts] { return parts.queue.activity(); }),
      wave::number(entry + ".line", row_bits, [parts, &program] {
        const Packet* const at = parts.entry.read().packet;
        return at == nullptr ? std::nullopt : row_of(at->segment, program);
      })};
  wave::add(packet_taps(
                entry, [parts] { return parts.entry.read(); }, 0, program, shape),
            taps);
  const auto shown = [parts](auto read) {
    return [parts, read]() -> Number { return parts.refresh.read().valid ? Number(read()) : std::nullopt; };
  };
  taps.push_back(
      wave::text(refresh + ".state", [parts] { return std::string(parts.refresh.read().valid ? "showing" : ""); }));
  taps.push_back(wave::number(refresh + ".line", row_bits, shown([parts, &program] {
                                return row_of(parts.collector.line_of(parts.number), program);
                              })));
  taps.push_back(
      wave::hexadecimal(refresh + ".colour", 32, shown([parts]() -> Number { return parts.refresh.read().colour; })));
  return taps;
}

std::vector<Tap> cell_taps(wave::Pixel pixel, std::span<const ChainParts> chains, const isa::Program& program,
                           WordShape shape) {
  const std::string part = wave::pixel_part_name(pixel);
  const std::uint32_t line = wave::segment_of(pixel, program);
  const ChainParts parts = chains[line % chains.size()];
  const std::uint32_t cell = pixel.x - program.segments[line].region.x;
  const ReadBeat beat = [parts, cell, line] {
    const Chain& chain = parts.chain.chain();
    const Beat at = chain.clocks_to(cell) == 0 ? parts.entry.read() : chain.beat_in(cell);
    return at.packet != nullptr && at.packet->segment == line ? at : Beat{};
  };
  std::vector<Tap> taps = packet_taps(part, beat, cell, program, shape.in_cells ? std::optional(shape) : std::nullopt);
  const auto held = [parts, cell, line](auto read) {
    return [parts, cell, line, read]() -> Number {
      const Chain& chain = parts.chain.chain();
      return chain.segment_of(cell) == line ? Number(read(chain)) : std::nullopt;
    };
  };
  taps.push_back(
      wave::hexadecimal(part + ".sum", sum_bits, held([cell](const Chain& chain) { return chain.sum(cell); })));
  taps.push_back(
      wave::bit(part + ".enable", held([cell](const Chain& chain) -> Number { return chain.enabled(cell); })));
  wave::add(wave::field_taps(part, program,
                             [held, cell](isa::Field field) {
                               return held([cell, field](const Chain& chain) { return chain.read(cell, field); })();
                             }),
            taps);
  return taps;
}

}  // namespace csgsim::scan_line
