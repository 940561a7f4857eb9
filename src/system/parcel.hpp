// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "base/archive.hpp"
#include "base/ranks.hpp"

namespace nugget::system {

/// What goes to other ranks, each with what stands before it.
enum class Carried {
  histories,  ///< what histories of nodes and contacts show, nothing of elements
  energies,   ///< what energies are summed up from
  end,        ///< and the states of welds and adhesives, which the end of a run reports
  results,    ///< states, for result files
  whole,      ///< nodes, and elements with their stable steps: what the step of the assembled elements follows from
  restart     ///< what every rank has room for, and one knows: a restart file is written of it and of what `parts` give
};

/// Numbers on their way to other ranks, or, where it reads, from one, in the same order, whatever goes at a time. They
/// go in pieces of a mebibyte or what is given at once, so that no rank holds at a time what another one has.
class Parcel {
 public:
  /// Writes, to these ranks; `close` at the end.
  Parcel(Ranks& ranks, std::vector<int> to) : ranks_(ranks), to_(std::move(to)) {}
  /// Reads what that rank writes.
  Parcel(Ranks& ranks, int from) : ranks_(ranks), from_(from) {}

  bool reading() const { return from_ >= 0; }
  template <class T>
  void operator()(T* values, std::size_t count) {
    const std::size_t size = count * sizeof(T);
    if (size == 0) return;
    for (std::size_t done = 0; reading() && done < size;) {
      if (place_ == piece_.size()) next_piece();
      const std::size_t now = std::min(size - done, piece_.size() - place_);
      std::memcpy(reinterpret_cast<std::byte*>(values) + done, piece_.data() + place_, now);
      place_ += now;
      done += now;
    }
    if (reading()) return;
    const std::size_t end = piece_.size();
    piece_.resize(end + size);
    std::memcpy(piece_.data() + end, values, size);
    if (piece_.size() >= piece_size) send_piece();
  }
  void close();

 private:
  static constexpr std::size_t piece_size = std::size_t{1} << 20;
  void next_piece();
  void send_piece();

  Ranks& ranks_;
  std::vector<int> to_;
  int from_ = -1;
  std::vector<std::byte> piece_, leaving_;  ///< being filled or read; the one before it
  std::uint64_t leaving_size_ = 0;
  std::size_t place_ = 0;
};

/// What a class archives, on the same way.
class ParcelArchive final : public Archive {
 public:
  explicit ParcelArchive(Parcel& parcel) : Archive(parcel.reading()), parcel_(parcel) {}

 private:
  void bytes(void* data, std::size_t size) override { parcel_(static_cast<std::byte*>(data), size); }
  Parcel& parcel_;
};

}  // namespace nugget::system
