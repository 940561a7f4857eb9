// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace nugget {

/// What was read does not fit the objects that it is read into.
struct ArchiveError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// State on its way into a file, or back. A class that changes while the model moves has one function for both ways,
///     void archive(Archive& a) {
///       a(velocity_, force_, pairs_);
///       a.built(model_, nodes_);
///     }
/// that names each of its members: handed to `a` what changes, to `built` what follows from the deck or is made anew in
/// every cycle (tools/check_archives.py looks for members that are forgotten). Objects are read into those that were
/// built from the same deck, so a list of objects keeps its length; lists of plain values take the length that is read.
/// Plain values go byte by byte: only the program that wrote them reads them.
class Archive {
 public:
  virtual ~Archive() = default;
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  bool reading() const { return reading_; }

  template <class... T>
  void operator()(T&... values) {
    (put(values), ...);
  }

  /// Names members that are not kept. Does nothing.
  template <class... T>
  void built(const T&...) {}

  /// A name between parts of the state. Throws ArchiveError where another one is read.
  void section(std::string_view name) {
    std::string here(name);
    put(here);
    if (here != name) throw ArchiveError("'" + std::string(name) + "' was expected where another part begins");
  }

 protected:
  explicit Archive(bool reading) : reading_(reading) {}
  /// Keeps `size` bytes from `data` on, or fills them.
  virtual void bytes(void* data, std::size_t size) = 0;

 private:
  template <class T>
  static constexpr bool has_archive = requires(T& value, Archive& a) {
    value.archive(a);
  };
  template <class T>
  static constexpr bool plain = std::is_trivially_copyable_v<T> && !has_archive<T>;

  template <class T>
  void put(T& value) {
    if constexpr (has_archive<T>) {
      value.archive(*this);
    } else {
      static_assert(plain<T> && !std::is_pointer_v<T>, "give this class a function archive(Archive&)");
      bytes(&value, sizeof value);
    }
  }
  template <class T>
  void put(std::atomic<T>& value) {
    T now = value.load();
    put(now);
    value.store(now);
  }
  template <class T>
  void put(std::unique_ptr<T>& object) {
    const bool here = object != nullptr;
    bool there = here;
    put(there);
    if (here != there) throw ArchiveError("an object is missing, or one too many");
    if (object) put(*object);
  }
  void put(std::string& text) {
    put_size(text);
    bytes(text.data(), text.size());
  }
  template <class T, class Allocator>
  void put(std::vector<T, Allocator>& list) {
    static_assert(!std::is_same_v<T, bool>, "a list of bits has no bytes of its own: use char");
    put_size(list);
    if constexpr (plain<T>)
      bytes(list.data(), list.size() * sizeof(T));
    else
      for (T& value : list) put(value);
  }
  template <class T>
  void put(std::deque<T>& list) {
    put_size(list);
    for (T& value : list) put(value);
  }
  template <class Key, class Value>
  void put(std::map<Key, Value>& entries) {
    std::size_t size = entries.size();
    put(size);
    if (!reading_) {
      for (auto& [key, value] : entries) {
        Key name = key;
        put(name);
        put(value);
      }
      return;
    }
    entries.clear();
    for (std::size_t i = 0; i < size; ++i) {
      Key name{};
      put(name);
      put(entries[std::move(name)]);
    }
  }

  /// Lists of objects were built with their right length.
  template <class List>
  void put_size(List& list) {
    using T = typename List::value_type;
    std::size_t size = list.size();
    put(size);
    if (size == list.size()) return;
    constexpr bool objects = has_archive<T> || requires(T value) {
      value.get_deleter();
    };
    if constexpr (objects)
      throw ArchiveError("there are " + std::to_string(size) + " objects where " + std::to_string(list.size()) +
                         " were built");
    else
      list.resize(size);
  }

  bool reading_;
};

}  // namespace nugget
