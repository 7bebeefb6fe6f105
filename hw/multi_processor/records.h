#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hw/division/bit_stream.h"
#include "hw/division/candidates.h"
#include "hw/division/display_model.h"
#include "hw/isa/link_word.h"

/// The model on the control bus: records that each begin at a new word, with the least significant bits first. Per
/// frame: the header, all primitives without their half-spaces, and the nodes of the tree. Per active segment: the
/// number of surviving primitives, then each of them, followed by its half-spaces unless these stay with the display
/// processor. In that case, a node requests a half-space by the primitive's index and the half-space's number among the
/// primitive's survivors.
namespace csgsim::multi_processor {

/// Widths in bits of the numbers in a frame's records; the header gives those that depend on the model.
struct RecordFormat {
  static constexpr unsigned header = 256;

  unsigned depth;  ///< width of a depth step or the end of the range
  unsigned colour;
  unsigned slope;       ///< width of A and B, two's complement
  unsigned constant;    ///< width of C, two's complement
  unsigned halfspaces;  ///< width of the number of a primitive's half-spaces
  unsigned operands;    ///< width of the number of an operator's operands
  unsigned index;       ///< width of the index of a primitive
  unsigned primitives;  ///< width of the number of surviving primitives

  [[nodiscard]] unsigned primitive_record() const;
  [[nodiscard]] unsigned node_record() const { return 2 + operands; }
  [[nodiscard]] unsigned count_record() const { return primitives; }
  [[nodiscard]] unsigned survivor_record() const { return index + halfspaces; }
  // Widths of the numbers that a node reads: the box of a primitive, and everything but the colour of a half-space.
  [[nodiscard]] std::array<unsigned, 6> box_numbers() const;
  [[nodiscard]] std::array<unsigned, 5> halfspace_numbers() const { return {1, 1, slope, slope, constant}; }
  [[nodiscard]] std::array<unsigned, 3> node_numbers() const { return {1, 1, operands}; }
  [[nodiscard]] unsigned halfspace_record() const { return 2 + 2 * slope + constant + colour; }
};

using Records = std::vector<division::Bits>;

/// Records of the frame for a valid model.
Records frame_records(const division::DisplayModel& model);
/// Records of a segment with its surviving primitives and half-spaces.
Records segment_records(const division::DisplayModel& model, const division::Candidates& survivors);
/// Records of a segment with its surviving primitives, without their half-spaces.
Records segment_records_without_halfspaces(const division::DisplayModel& model, const division::Candidates& survivors);

/// Identifies a surviving half-space.
struct HalfspaceId {
  std::uint32_t primitive = 0;
  std::uint32_t number = 0;  ///< among the surviving half-spaces of the primitive

  constexpr bool operator==(const HalfspaceId&) const = default;
};

/// Decodes a request. Throws InputError if the half-space is not among the survivors.
HalfspaceId decode_request(const division::DisplayModel& model, const division::Candidates& survivors,
                           const division::Bits& request);
/// The record of a surviving half-space.
division::Bits halfspace_record(const division::DisplayModel& model, const division::Candidates& survivors,
                                const HalfspaceId& id);

/// Appends the `word_bits` bits of a bus word to `bits`.
void append_word(division::BitWriter& bits, const isa::LinkWord& word, unsigned word_bits);

/// A half-space with its plane, which is not shared with other half-spaces.
struct ReadHalfspace {
  division::Halfspace halfspace;
  division::Plane plane;
};

/// Receiver of records: collects words into records, and records into the model and the survivors of a segment.
class RecordReader {
 public:
  /// `word_bits`: width of a bus word. `memory_word_bits`: width of a word of the memory that holds the records.
  RecordReader(unsigned word_bits, unsigned memory_word_bits)
      : word_bits_(word_bits), memory_word_bits_(memory_word_bits) {}

  /// Expects the records of a frame.
  void begin_frame();
  /// Expects the records of a segment of the received frame. `with_halfspaces`: whether these include the half-spaces,
  /// or the half-spaces stay with the display processor.
  void begin_segment(bool with_halfspaces = true);

  /// Accepts the next word. Throws InputError for a word after the last record, and if the records do not form a valid
  /// model.
  void take(const isa::LinkWord& word);

  /// Whether the frame or the segment has been received completely.
  [[nodiscard]] bool is_complete() const { return next_ == Record::none; }

  /// The frame's model: primitives have no half-spaces; the planes are those of the segment.
  [[nodiscard]] const division::DisplayModel& model() const { return model_; }
  /// Survivors of the segment.
  [[nodiscard]] const division::Candidates& survivors() const { return survivors_; }
  /// Encodes the request for a half-space, in a segment that was sent without half-spaces.
  [[nodiscard]] division::Bits encode_request(const HalfspaceId& id) const;
  /// Decodes the record that is sent in reply to such a request.
  [[nodiscard]] ReadHalfspace decode_halfspace(const division::Bits& record) const;
  /// Format of the received frame.
  [[nodiscard]] const RecordFormat& format() const { return format_; }
  /// Memory words occupied by the records of frame and segment, each starting at a new word.
  [[nodiscard]] std::uint64_t memory_words() const { return frame_words_ + segment_words_; }

 private:
  enum class Record : std::uint8_t { none, header, primitive, node, count, survivor, halfspace };

  void expect_record(Record record);
  void await_next();
  void read_record(division::BitReader& in);
  void read_header(division::BitReader& in);
  void read_primitive(division::BitReader& in);
  void read_node(division::BitReader& in);
  void read_survivor(division::BitReader& in);
  void read_halfspace(division::BitReader& in);
  [[nodiscard]] unsigned bits_of(Record record) const;

  unsigned word_bits_;
  unsigned memory_word_bits_;
  std::uint64_t frame_words_ = 0;  ///< memory words
  std::uint64_t segment_words_ = 0;
  Record next_ = Record::none;
  division::BitWriter gathered_;
  unsigned missing_bits_ = 0;  ///< bits of the current record still to be received
  RecordFormat format_{};
  division::DisplayModel model_;
  division::Candidates survivors_;
  std::uint64_t primitives_ = 0;          ///< number in the frame
  std::uint64_t nodes_ = 0;               ///< number in the frame
  std::uint64_t primitives_to_come_ = 0;  ///< surviving primitives still to be received
  std::uint64_t halfspaces_to_come_ = 0;  ///< half-spaces of the current primitive still to be received
  bool with_halfspaces_ = true;
};

}  // namespace csgsim::multi_processor
