// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/row_exchange.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/index.hpp"

namespace nugget::nvh {

RowShares::RowShares(std::size_t rows, const Ranks& ranks) : rows_(rows), count_(ranks.count()), rank_(ranks.rank()) {}

std::size_t RowShares::begin(int rank) const {
  return rows_ * at(rank) / at(count_);
}

int RowShares::owner(std::size_t row) const {
  int rank = static_cast<int>(row * at(count_) / rows_);
  while (row >= end(rank)) ++rank;
  return rank;
}

RowExchange::RowExchange(Ranks& ranks, const RowShares& shares, const std::vector<int>& row)
    : ranks_(&ranks), copies_(row.size()), mine_(at(ranks.count())), theirs_(at(ranks.count())) {
  std::vector<std::vector<int>> asked(mine_.size());
  for (std::size_t k = 0; k < row.size(); ++k) {
    const std::size_t owner = at(shares.owner(at(row[k])));
    mine_[owner].push_back(k);
    asked[owner].push_back(row[k] - static_cast<int>(shares.begin(static_cast<int>(owner))));
  }
  std::vector<std::uint64_t> own(mine_.size()), all(mine_.size() * mine_.size());
  for (std::size_t r = 0; r < own.size(); ++r) own[r] = asked[r].size();
  ranks.gather(std::as_bytes(std::span(own)), std::as_writable_bytes(std::span(all)));
  const std::size_t here = at(ranks.rank());
  for (std::size_t r = 0; r < own.size(); ++r) {
    theirs_[r].resize(all[r * own.size() + here]);
    if (r == here) {
      theirs_[r] = asked[r];
      continue;
    }
    if (!asked[r].empty()) ranks.send(static_cast<int>(r), std::as_bytes(std::span(asked[r])));
    if (!theirs_[r].empty()) ranks.receive(static_cast<int>(r), std::as_writable_bytes(std::span(theirs_[r])));
  }
  ranks.finish();
}

std::vector<std::vector<double>> RowExchange::exchange(To to, const Columns& from) const {
  const std::size_t columns = from.count;
  std::vector<std::vector<double>> sent(mine_.size()), received(mine_.size());
  const auto pack = [&](const auto& rows, std::vector<double>& into) {
    into.reserve(rows.size() * columns);
    for (std::size_t j = 0; j < columns; ++j)
      for (const auto row : rows) into.push_back(from[j][static_cast<std::size_t>(row)]);
  };
  const std::size_t here = at(ranks_->rank());
  for (std::size_t r = 0; r < sent.size(); ++r) {
    if (to == To::owners)
      pack(mine_[r], sent[r]);
    else
      pack(theirs_[r], sent[r]);
    if (r == here) continue;
    received[r].resize(columns * (to == To::owners ? theirs_[r].size() : mine_[r].size()));
    if (!sent[r].empty()) ranks_->send(static_cast<int>(r), std::as_bytes(std::span(sent[r])));
    if (!received[r].empty()) ranks_->receive(static_cast<int>(r), std::as_writable_bytes(std::span(received[r])));
  }
  ranks_->finish();
  received[here] = std::move(sent[here]);
  return received;
}

void RowExchange::fetch(const Columns& x, Columns& copies) const {
  const std::vector<std::vector<double>> arrived = exchange(To::copies, x);
  for (std::size_t r = 0; r < arrived.size(); ++r)
    for (std::size_t j = 0, i = 0; j < copies.count; ++j)
      for (const std::size_t k : mine_[r]) copies[j][k] = arrived[r][i++];
}

void RowExchange::put(const Columns& copies, Columns& x) const {
  const std::vector<std::vector<double>> arrived = exchange(To::owners, copies);
  for (std::size_t r = 0; r < arrived.size(); ++r)
    for (std::size_t j = 0, i = 0; j < x.count; ++j)
      for (const int row : theirs_[r]) x[j][at(row)] = arrived[r][i++];
}

void RowExchange::add(const Columns& copies, Columns& x) const {
  const std::vector<std::vector<double>> arrived = exchange(To::owners, copies);
  for (std::size_t r = 0; r < arrived.size(); ++r)
    for (std::size_t j = 0, i = 0; j < x.count; ++j)
      for (const int row : theirs_[r]) x[j][at(row)] += arrived[r][i++];
}

Columns gather_rows(Ranks& ranks, const RowShares& shares, Columns own) {
  if (ranks.rank() != 0) {
    if (!own.value.empty()) ranks.send(0, std::as_bytes(std::span(own.value)));
    ranks.finish();
    return {};
  }
  Columns whole(shares.rows(), own.count);
  for (int r = 0; r < ranks.count(); ++r) {
    const std::size_t begin = shares.begin(r), rows = shares.end(r) - begin;
    if (r > 0) {  // one at a time: the first rank has no room for two of the whole
      own.rows = rows;
      own.value.resize(rows * own.count);
      if (!own.value.empty()) ranks.receive(r, std::as_writable_bytes(std::span(own.value)));
      ranks.finish();
    }
    for (std::size_t j = 0; j < own.count; ++j)
      std::ranges::copy(own[j], whole[j].begin() + static_cast<std::ptrdiff_t>(begin));
  }
  return whole;
}

}  // namespace nugget::nvh
