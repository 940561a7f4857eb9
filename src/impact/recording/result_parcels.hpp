// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/parallel.hpp"
#include "system/parcel.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Results of nodes and elements on their way to the first of several ranks, which writes them in the order of its
/// files: all ranks go through that order, each gives what it answers for, and the first one asks whose turn it is.
/// Nobody holds more of what others give than a mebibyte of each (system::Parcel). One process has nothing to send.
class ResultParcels {
 public:
  static constexpr std::size_t rows_at_a_time = 1024;

  explicit ResultParcels(const system::System& system);

  /// Whether this is the process that writes.
  bool writes() const { return rank_ == 0; }
  /// Who answers for an element, or a node of the system; of what every rank computes the first one.
  int owner(const system::System::ElementLocation& location) const;
  int owner_of_node(std::size_t node) const;
  bool own(int owner) const { return owner == rank_; }

  /// To the first rank, on others.
  system::Parcel& to_first() { return *to_first_; }
  /// From another rank, on the first one.
  system::Parcel& from(int rank) { return *from_[static_cast<std::size_t>(rank)]; }
  /// To be called when all is sent.
  void close();

 private:
  const system::System& system_;
  int rank_ = 0;
  std::optional<system::Parcel> to_first_;
  std::vector<std::optional<system::Parcel>> from_;  ///< by rank
};

/// Rows of a list of `count` on that way, some at a time: `take(rows)` gets them on the process that writes.
///   owner(i)          whose row it is
///   blank(i)          the row with room for all that `carry` puts into a parcel
///   fill(i, row)      what it holds
///   carry(row, parcel)
/// `parcels`: null: rows stay blank.
template <class Row, class Owner, class Blank, class Fill, class Carry, class Take>
void pass_rows(ResultParcels* parcels, std::size_t count, const Owner& owner, const Blank& blank, const Fill& fill,
               const Carry& carry, const Take& take) {
  constexpr std::size_t at_a_time = ResultParcels::rows_at_a_time;
  const bool writes = parcels == nullptr || parcels->writes();
  for (std::size_t begin = 0; begin < count; begin += at_a_time) {
    std::vector<Row> rows;
    std::vector<std::size_t> own;  ///< their places in the list
    for (std::size_t i = begin; i < std::min(count, begin + at_a_time); ++i) {
      const bool is_own = parcels != nullptr && parcels->own(owner(i));
      if (is_own) own.push_back(i);
      if (is_own || writes) rows.push_back(blank(i));
    }
    const auto row_of = [&](std::size_t k) -> Row& { return rows[writes ? own[k] - begin : k]; };
    parallel_for(own.size(), 64, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) fill(own[k], row_of(k));
    });
    if (writes) {
      for (std::size_t k = 0; parcels != nullptr && own.size() < rows.size() && k < rows.size(); ++k)
        if (const int of = owner(begin + k); !parcels->own(of)) carry(rows[k], parcels->from(of));
      take(std::move(rows));
    } else {
      for (Row& row : rows) carry(row, parcels->to_first());
    }
  }
}

}  // namespace nugget::impact
