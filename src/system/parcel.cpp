// SPDX-License-Identifier: Apache-2.0
#include "system/parcel.hpp"

#include <span>

namespace nugget::system {

void Parcel::next_piece() {
  std::uint64_t size = 0;
  ranks_.receive(from_, std::as_writable_bytes(std::span(&size, 1)));
  ranks_.finish();
  piece_.resize(size);
  ranks_.receive(from_, piece_);
  ranks_.finish();
  place_ = 0;
}

void Parcel::send_piece() {
  ranks_.finish();  // of the one before, which was on its way meanwhile
  std::swap(piece_, leaving_);
  piece_.clear();
  leaving_size_ = leaving_.size();
  for (const int to : to_) {
    ranks_.send(to, std::as_bytes(std::span(&leaving_size_, 1)));
    ranks_.send(to, leaving_);
  }
}

void Parcel::close() {
  if (!piece_.empty()) send_piece();
  ranks_.finish();
}

}  // namespace nugget::system
