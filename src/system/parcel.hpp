// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstring>
#include <vector>

#include "base/archive.hpp"

namespace nugget::system {

/// What goes to other ranks, each with what stands before it.
enum class Carried {
  histories,  ///< what histories of nodes and contacts show, nothing of elements
  energies,   ///< what energies are summed up from
  results,    ///< states and forces, for result files
  whole       ///< stable steps as well: a run could go on from it
};

/// Numbers on their way to another rank, or, where it reads, from one, in the same order.
class Parcel {
 public:
  Parcel(std::vector<std::byte>& data, bool reading) : data_(data), reading_(reading) {}
  bool reading() const { return reading_; }
  template <class T>
  void operator()(T* values, std::size_t count) {
    const std::size_t size = count * sizeof(T);
    if (size == 0) return;
    if (reading_) {
      std::memcpy(static_cast<void*>(values), data_.data() + place_, size);
    } else {
      data_.resize(place_ + size);
      std::memcpy(data_.data() + place_, values, size);
    }
    place_ += size;
  }

 private:
  std::vector<std::byte>& data_;
  bool reading_;
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
