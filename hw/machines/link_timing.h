// Analytic timing of a link.
// Used by hw/pixel_planes and hw/link.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hw/machines/accounts.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// Clocks of the host's end of a link by activity; each clock counts for exactly one.
struct LinkAccount {
  std::uint64_t words = 0;    ///< words written to the FIFO, including words discarded by a jump
  std::uint64_t sending = 0;  ///< clocks in which a word was on the link
  std::uint64_t blocked = 0;  ///< clocks in which a transmitted word waited for room in the FIFO
  std::uint64_t waiting = 0;  ///< clocks before the first request, and from each request to its first word
  std::uint64_t done = 0;     ///< clocks after the last word

  constexpr bool operator==(const LinkAccount&) const = default;
};

/// Converts the account to that of a part named `part_name`.
PartAccount part_account(const LinkAccount& account, std::string part_name);

/// Computes when words pass a link, without stepping. Words are counted from the last request. Edges are numbered from
/// the frame's first, number 0; clock c lasts from edge c to edge c + 1.
class LinkTiming {
 public:
  explicit LinkTiming(const Link& link);

  /// Records a request that reaches the host at `edge`. The FIFO is then empty.
  void record_request(std::uint64_t edge);

  /// Sends the next word and returns the edge at which it enters the FIFO; it can be read from the next edge on. The
  /// word `fifo_depth` words before it must have been read.
  std::uint64_t send();

  /// Sends the next word only if it enters the FIFO before `edge`; returns whether it does, and sets `stored_edge` to
  /// the edge at which it enters. Unread words occupy room in the FIFO.
  bool try_send_before(std::uint64_t edge, std::uint64_t& stored_edge);

  /// Reads the oldest word in the FIFO at `edge`.
  void read_word(std::uint64_t edge);

  /// Accounts for the host's clocks from the last word until `edge`: if words are left, as sending for the clocks of
  /// one word and as blocked after these; otherwise as done.
  void account_until(std::uint64_t edge, bool words_left);

  [[nodiscard]] const LinkAccount& account() const { return account_; }

  // Numbers of words since the last request.
  [[nodiscard]] std::uint64_t sent() const { return sent_; }  ///< words that entered the FIFO
  [[nodiscard]] std::uint64_t words_read() const { return read_; }
  /// Remaining clocks at `edge` of the word on the link; 0 if the word waits for room.
  [[nodiscard]] std::uint32_t clocks_left(std::uint64_t edge) const {
    const std::uint64_t over = since_ + link_.word_clocks + 1;
    return over > edge ? static_cast<std::uint32_t>(over - edge) : 0;
  }

 private:
  [[nodiscard]] std::uint64_t room_edge() const;
  void store_word(std::uint64_t edge);
  [[nodiscard]] std::size_t next_slot(std::size_t slot) const { return slot + 1 == read_edges_.size() ? 0 : slot + 1; }

  Link link_;
  std::uint64_t since_ = 0;  ///< edge from which the next word is on the link
  std::uint64_t sent_ = 0;
  std::uint64_t read_ = 0;
  std::vector<std::uint64_t> read_edges_;  ///< ring of the edges of the last reads
  std::size_t sent_place_ = 0;             ///< index in the ring of the next word to send
  std::size_t read_place_ = 0;             ///< index in the ring of the next word to read
  LinkAccount account_;
};

}  // namespace csgsim::machines
