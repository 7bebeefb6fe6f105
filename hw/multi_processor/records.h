#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hw/division/bit_stream.h"
#include "hw/division/candidates.h"
#include "hw/division/display_model.h"
#include "hw/isa/link_word.h"

/// How the model travels on the control bus: records, of which each begins at a new word. Once a frame the header, then
/// all primitives without their half-spaces, then the nodes of the tree. Once a segment where anything is left the
/// number of primitives that are left; then each, followed by its half-spaces, unless these stay with the display
/// processor. Then a node asks for one by the primitive's index and its number among those that are left of it. Least
/// significant bits come first.
namespace csgsim::multi_processor {

/// Widths in bits of the numbers in a frame's records; the header says those that depend on the model.
struct RecordFormat {
  static constexpr unsigned header = 256;

  unsigned depth;  ///< a depth step or the end of the range
  unsigned colour;
  unsigned slope;       ///< A and B, two's complement
  unsigned constant;    ///< C, two's complement
  unsigned halfspaces;  ///< the number of a primitive's half-spaces
  unsigned operands;    ///< the number of an operator's operands
  unsigned index;       ///< of a primitive
  unsigned primitives;  ///< the number of those that are left

  [[nodiscard]] unsigned primitive_record() const;
  [[nodiscard]] unsigned node_record() const { return 2 + operands; }
  [[nodiscard]] unsigned count_record() const { return primitives; }
  [[nodiscard]] unsigned left_record() const { return index + halfspaces; }
  // Numbers that are looked at: of a primitive its box, of a half-space all but its colour.
  [[nodiscard]] std::array<unsigned, 6> box_numbers() const;
  [[nodiscard]] std::array<unsigned, 5> halfspace_numbers() const { return {1, 1, slope, slope, constant}; }
  [[nodiscard]] std::array<unsigned, 3> node_numbers() const { return {1, 1, operands}; }
  [[nodiscard]] unsigned halfspace_record() const { return 2 + 2 * slope + constant + colour; }
};

using Records = std::vector<division::Bits>;

/// Of a sound model.
Records frame_records(const division::DisplayModel& model);
Records segment_records(const division::DisplayModel& model, const division::Candidates& left);
/// The same without half-spaces.
Records segment_heads(const division::DisplayModel& model, const division::Candidates& left);

/// Which of the half-spaces that are left.
struct HalfspaceName {
  std::uint32_t primitive = 0;
  std::uint32_t number = 0;

  constexpr bool operator==(const HalfspaceName&) const = default;
};

/// Throws InputError for a request for one that is not left.
HalfspaceName requested(const division::DisplayModel& model, const division::Candidates& left,
                        const division::Bits& request);
division::Bits halfspace_record(const division::DisplayModel& model, const division::Candidates& left,
                                const HalfspaceName& name);

/// Adds a word of the bus.
void append(division::BitWriter& gathered, const isa::LinkWord& word, unsigned word_bits);

/// A half-space with what it is of its plane, which is no other's.
struct ReadHalfspace {
  division::Halfspace halfspace;
  division::Plane plane;
};

/// The receiving end: gathers words into records, and these into the model and what a segment leaves of it.
class RecordReader {
 public:
  /// Words of the bus, and of the memory that records are kept in.
  RecordReader(unsigned word_bits, unsigned memory_word_bits)
      : word_bits_(word_bits), memory_word_bits_(memory_word_bits) {}

  /// The words to come are of a frame, or of a segment of the frame that has come. `brings_halfspaces`: they do not
  /// stay with the display processor.
  void begin_frame();
  void begin_segment(bool brings_halfspaces = true);

  /// Throws InputError for a word after the last record, and where they do not make a sound model.
  void take(const isa::LinkWord& word);

  /// The frame, or the segment, has come as a whole.
  [[nodiscard]] bool whole() const { return next_ == Record::none; }

  /// The frame's model: primitives have no half-spaces; the planes are those of the segment.
  [[nodiscard]] const division::DisplayModel& model() const { return model_; }
  /// What the segment leaves.
  [[nodiscard]] const division::Candidates& left() const { return left_; }
  /// Of a segment that does not bring them: the request for a half-space, and what its record says.
  [[nodiscard]] division::Bits request_for(const HalfspaceName& name) const;
  [[nodiscard]] ReadHalfspace halfspace_of(const division::Bits& record) const;
  /// Of the frame that has come.
  [[nodiscard]] const RecordFormat& format() const { return format_; }
  /// That the records of the frame and of the segment take, each from a new one on.
  [[nodiscard]] std::uint64_t memory_words() const { return frame_words_ + segment_words_; }

 private:
  enum class Record : std::uint8_t { none, header, primitive, node, count, left, halfspace };

  void await(Record record);
  void await_next();
  void read(division::BitReader& in);
  void read_header(division::BitReader& in);
  void read_primitive(division::BitReader& in);
  void read_node(division::BitReader& in);
  void read_left(division::BitReader& in);
  void read_halfspace(division::BitReader& in);
  [[nodiscard]] unsigned bits_of(Record record) const;

  unsigned word_bits_;
  unsigned memory_word_bits_;
  std::uint64_t frame_words_ = 0;  ///< of memory
  std::uint64_t segment_words_ = 0;
  Record next_ = Record::none;
  division::BitWriter gathered_;
  unsigned wanted_ = 0;  ///< bits of the record at hand that have not come
  RecordFormat format_{};
  division::DisplayModel model_;
  division::Candidates left_;
  std::uint64_t primitives_ = 0;  ///< of the frame
  std::uint64_t nodes_ = 0;       ///< of the frame
  std::uint64_t to_come_ = 0;     ///< primitives of the segment
  std::uint64_t own_ = 0;         ///< half-spaces to come of the primitive at hand
  bool brings_halfspaces_ = true;
};

}  // namespace csgsim::multi_processor
