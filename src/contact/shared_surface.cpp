// SPDX-License-Identifier: Apache-2.0
// A surface contact over several ranks: each looks at every so many-th block of tracked nodes. What a block has found
// goes to all, so that every rank adds up the same forces in the order of blocks and hits.
#include <algorithm>
#include <cstring>

#include "contact/surface_contact.hpp"
#include "contact/surface_work.hpp"
#include "system/parcel.hpp"

namespace nugget::contact {
namespace {

/// Before the hits of a block in a message.
struct BlockHead {
  int block = 0, hits = 0;
  ContactEnergies energies;
};

bool has_any(const ContactEnergies& e) {
  return e.springs != 0.0 || e.friction != 0.0 || e.damping != 0.0 || e.deleted != 0.0 || e.drops.count != 0;
}

void append(std::vector<std::byte>& data, const void* from, std::size_t size) {
  if (size == 0) return;
  const std::size_t place = data.size();
  data.resize(place + size);
  std::memcpy(data.data() + place, from, size);
}

template <class T>
void carry_list(system::Parcel& parcel, std::vector<T>& list) {
  std::size_t size = list.size();
  parcel(&size, 1);
  list.resize(size);
  parcel(list.data(), size);
}

}  // namespace

void SurfaceContact::exchange_hits(Ranks& ranks) {
  std::vector<std::byte> found;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    Block& block = blocks_[b];
    if (!computes(b, &ranks)) {
      block.hits.clear();
      block.shares.clear();
      block.parts.clear();
      block.resultant = {};
      block.deepest = 0.0;
      continue;
    }
    // Of a block that has no pairs any more the hits are those of a cycle before.
    const std::size_t hits = block.pairs.empty() ? 0 : block.hits.size();
    if (hits == 0 && !has_any(block.energies)) continue;
    const BlockHead head{static_cast<int>(b), static_cast<int>(hits), block.energies};
    append(found, &head, sizeof head);
    append(found, block.hits.data(), hits * sizeof(Hit));
  }
  const std::vector<std::byte> all = gather_lists(ranks, found);
  with_hits_.clear();
  for (std::size_t place = 0; place < all.size();) {
    BlockHead head;
    std::memcpy(static_cast<void*>(&head), all.data() + place, sizeof head);
    place += sizeof head;
    Block& block = blocks_[head.block];
    if (!computes(at(head.block), &ranks)) {
      block.energies = head.energies;
      block.hits.resize(at(head.hits));
      if (head.hits > 0)
        std::memcpy(static_cast<void*>(block.hits.data()), all.data() + place, block.hits.size() * sizeof(Hit));
      sum_up(block);
      share_out(block, work_of_thread().shares);
    }
    place += at(head.hits) * sizeof(Hit);
    if (head.hits > 0) with_hits_.push_back(head.block);
  }
  std::sort(with_hits_.begin(), with_hits_.end());
}

void SurfaceContact::carry(int rank, int ranks, system::Parcel& parcel) {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (static_cast<int>(b % at(ranks)) != rank) continue;
    Block& block = blocks_[b];
    parcel(&block.asleep_until, 1);
    carry_list(parcel, block.first);
    carry_list(parcel, block.next_check_travel);
    carry_list(parcel, block.deep);
    carry_list(parcel, block.pairs);
    carry_list(parcel, block.touches);
    carry_list(parcel, block.free);
  }
  active_blocks_.clear();
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    if (!blocks_[b].pairs.empty()) active_blocks_.push_back(static_cast<int>(b));
}

}  // namespace nugget::contact
