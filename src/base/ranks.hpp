// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace nugget {

/// Processes that compute one run together, each with the same deck. What carries their messages, MPI, is known to the
/// program `nugget-mpi` only; a run by one process has no Ranks.
class Ranks {
 public:
  virtual ~Ranks() = default;

  virtual int count() const = 0;
  virtual int rank() const = 0;  ///< 0: the first one, which writes files and speaks

  /// Starts a message. Between two ranks messages arrive in the order in which they were started; the data must stay
  /// until `finish`.
  virtual void send(int to, std::span<const std::byte> data) = 0;
  virtual void receive(int from, std::span<std::byte> data) = 0;
  /// Waits for all messages that were started.
  virtual void finish() = 0;

  /// The data of all ranks, in their order, on all of them; everyone gives the same number of bytes.
  virtual void gather(std::span<const std::byte> own, std::span<std::byte> all) = 0;
  /// The data of the first rank, on all of them.
  virtual void broadcast(std::span<std::byte> data) = 0;

  /// What this rank has sent, and how long it has waited for others, so far.
  struct Traffic {
    std::uint64_t messages = 0, bytes = 0;
    double waiting = 0.0;  ///< seconds
  };
  virtual Traffic traffic() const = 0;

 protected:
  Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
};

/// One plain value of each rank, on all of them.
template <class T>
std::vector<T> gather(Ranks& ranks, const T& own) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::vector<T> all(static_cast<std::size_t>(ranks.count()));
  ranks.gather(std::as_bytes(std::span(&own, 1)), std::as_writable_bytes(std::span(all)));
  return all;
}

/// The lists of all ranks, one behind the other in the order of ranks, on all of them.
template <class T>
std::vector<T> gather_lists(Ranks& ranks, const std::vector<T>& own) {
  static_assert(std::is_trivially_copyable_v<T>);
  const std::vector<std::uint64_t> sizes = gather(ranks, static_cast<std::uint64_t>(own.size()));
  std::uint64_t longest = 0;
  for (const std::uint64_t size : sizes) longest = size > longest ? size : longest;
  if (longest == 0) return {};
  std::vector<T> padded(own), all(longest * sizes.size());
  padded.resize(longest);
  ranks.gather(std::as_bytes(std::span(padded)), std::as_writable_bytes(std::span(all)));
  std::vector<T> joined;
  for (std::size_t r = 0; r < sizes.size(); ++r) {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(r * longest);
    joined.insert(joined.end(), first, first + static_cast<std::ptrdiff_t>(sizes[r]));
  }
  return joined;
}

/// A plain value of the first rank takes the place of everyone's.
template <class T>
void broadcast(Ranks& ranks, T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  ranks.broadcast(std::as_writable_bytes(std::span(&value, 1)));
}

}  // namespace nugget
