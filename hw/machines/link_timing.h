#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hw/machines/accounts.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// Where the host's end of a link spent its clocks: each is in one of these.
struct LinkAccount {
  std::uint64_t words = 0;    ///< that went into the FIFO, those included that a jump left there in vain
  std::uint64_t sending = 0;  ///< clocks in which a word was on the link
  std::uint64_t blocked = 0;  ///< clocks in which a word that had been sent found no room
  std::uint64_t waiting = 0;  ///< clocks before a request, and from a request to the first word
  std::uint64_t done = 0;     ///< clocks after the last word

  constexpr bool operator==(const LinkAccount&) const = default;
};

/// As it is told.
PartAccount part_of(const LinkAccount& account, std::string name);

/// Works out when words get through a link, without stepping. Words are counted from the last request on. Edges are
/// numbered from the frame's first, 0; clock c is from edge c to c + 1.
class LinkTiming {
 public:
  explicit LinkTiming(const Link& link);

  /// A request has come to the host at that edge. The FIFO is empty then.
  void request(std::uint64_t edge);

  /// The edge at which the next word goes into the FIFO, from the next on it can be read. The word `fifo_depth` before
  /// it has to be read already.
  std::uint64_t send();

  /// Sends the next word if it goes into the FIFO before that edge. Words that nobody has read leave no room.
  bool send_before(std::uint64_t edge, std::uint64_t& stored);

  /// The oldest word in the FIFO is read at that edge.
  void read(std::uint64_t edge);

  /// What the host's end does from the last word on until that edge: sending, or, if no words are left, nothing.
  void stop(std::uint64_t edge, bool words_left);

  [[nodiscard]] const LinkAccount& account() const { return account_; }

  // Since the last request.
  [[nodiscard]] std::uint64_t sent() const { return sent_; }  ///< words that went into the FIFO
  [[nodiscard]] std::uint64_t words_read() const { return read_; }
  /// Before that edge, clocks that the word on the link has still to be there; 0 if it waits for room.
  [[nodiscard]] std::uint32_t clocks_left(std::uint64_t edge) const {
    const std::uint64_t over = since_ + link_.word_clocks + 1;
    return over > edge ? static_cast<std::uint32_t>(over - edge) : 0;
  }

 private:
  [[nodiscard]] std::uint64_t room_edge() const;
  void store(std::uint64_t edge);
  [[nodiscard]] std::size_t after(std::size_t place) const { return place + 1 == read_edges_.size() ? 0 : place + 1; }

  Link link_;
  std::uint64_t since_ = 0;  ///< the next word is on the link from that edge on
  std::uint64_t sent_ = 0;
  std::uint64_t read_ = 0;
  std::vector<std::uint64_t> read_edges_;  ///< of the last words read, a ring
  std::size_t sent_place_ = 0;             ///< in the ring, of the next word to be sent
  std::size_t read_place_ = 0;             ///< in the ring, of the next word to be read
  LinkAccount account_;
};

}  // namespace csgsim::machines
