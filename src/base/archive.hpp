// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <span>
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
///
/// Over several ranks all of them call it at the same state, and what one process would write is written
/// (docs/decisions/0147): of values of which each rank holds those of its share, `parts` and `each_part` let the rank
/// give that has them and, where they are read, those take them that want them. All else the first rank gives, and
/// every rank takes.
class Archive {
 public:
  static constexpr int everyone = -1;  ///< in place of a rank: all have the same
  /// Of values by place, whether by node, element or otherwise: who holds those of a place. A process alone leaves both
  /// empty, and holds all.
  struct Holders {
    std::function<int(std::size_t place)> giver;   ///< the rank that gives them; `everyone`: any may
    std::function<bool(std::size_t place)> taker;  ///< whether this rank wants them
  };

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

  /// Values that stand by place, `each` to a place.
  template <class T>
  void parts(std::span<T> values, std::size_t each, const Holders& holders) {
    static_assert(plain<T>);
    if (each == 0) return;
    each_run(values.size() / each, values.size() / each, holders, [&](std::size_t begin, std::size_t end, Part p) {
      const std::size_t size = (end - begin) * each * sizeof(T);
      if (!p.here) return pass(p.giver, size);
      const Giving giving(*this, p);
      put_plain(values.data() + begin * each, (end - begin) * each);
    });
  }
  /// The same of a list by place, one value to each; it takes the length that is read.
  template <class T, class Allocator>
  void parts(std::vector<T, Allocator>& list, const Holders& holders) {
    put_size(list);
    parts(std::span(list), 1, holders);
  }
  /// What each place has is archived by `body(place, here)`, and may be of any length. `here`: it is this rank's; where
  /// it is not, which happens in reading only, `body` reads it and drops it. Up to `together` places go in one piece.
  template <class Body>
  void each_part(std::size_t places, std::size_t together, const Holders& holders, const Body& body) {
    each_run(places, together, holders, [&](std::size_t begin, std::size_t end, Part p) {
      if (!reading_ && !p.here) return pass_piece(p.giver);
      const Giving giving(*this, p);
      if (giving_) begin_piece();
      for (std::size_t i = begin; i < end; ++i) body(i, p.here);
      if (giving_) end_piece();
    });
  }

  /// A name between parts of the state. Throws ArchiveError where another one is read.
  void section(std::string_view name) {
    std::string here(name);
    put(here);
    if (here != name) throw ArchiveError("'" + std::string(name) + "' was expected where another part begins");
  }

 protected:
  /// `rank`: of several that write together; `everyone` where a process writes alone, or reads.
  explicit Archive(bool reading, int rank = everyone) : reading_(reading), rank_(rank) {}
  /// Keeps `size` bytes from `data` on, or fills them.
  virtual void bytes(void* data, std::size_t size) = 0;
  /// Whether these bytes are of this one of several ranks that write, and not of everyone.
  bool giving() const { return giving_; }
  /// Between these two they are a piece whose length only this rank knows.
  virtual void begin_piece() {}
  virtual void end_piece() {}
  /// What another rank gives, or wants in this process's place, goes by: `size` bytes; one of its pieces.
  virtual void pass(int rank, std::size_t size);
  virtual void pass_piece(int rank);

 private:
  template <class T>
  static constexpr bool has_archive = requires(T& value, Archive& a) {
    value.archive(a);
  };
  template <class T>
  static constexpr bool plain = std::is_trivially_copyable_v<T> && !has_archive<T>;

  /// Of a place: the rank that gives its values, and whether they are on their way from or to this process.
  struct Part {
    int giver = everyone;
    bool here = true;
    bool operator==(const Part&) const = default;
  };
  class Giving {
   public:
    Giving(Archive& a, const Part& p) : a_(a), before_(a.giving_) {
      a.giving_ = before_ || (!a.reading_ && p.giver != everyone);
    }
    ~Giving() { a_.giving_ = before_; }
    Giving(const Giving&) = delete;
    Giving& operator=(const Giving&) = delete;

   private:
    Archive& a_;
    bool before_;
  };
  Part part(const Holders& holders, std::size_t place) const {
    if (reading_) return {everyone, !holders.taker || holders.taker(place)};
    if (!holders.giver) return {};
    const int giver = holders.giver(place);
    return {giver, giver == everyone || giver == rank_};
  }
  /// Calls `visit(begin, end, part)` for places in a row of one part, `most` at a time.
  template <class Visit>
  void each_run(std::size_t places, std::size_t most, const Holders& holders, const Visit& visit) {
    for (std::size_t begin = 0, end; begin < places; begin = end) {
      const Part here = part(holders, begin);
      const std::size_t last = std::min(places, begin + most);
      for (end = begin + 1; end < last && part(holders, end) == here;) ++end;
      visit(begin, end, here);
    }
  }

  /// Bytes between members go as 0, where the compiler can: what was in the memory before is no part of the state, and
  /// two files of one state are the same.
  template <class T>
  void put_plain(T* values, std::size_t count) {
#if __has_builtin(__builtin_clear_padding)
    if constexpr (!std::is_arithmetic_v<T> && !std::is_enum_v<T>) {
      constexpr std::size_t together = sizeof(T) < 4096 ? 4096 / sizeof(T) : 1;
      alignas(T) std::byte copies[together * sizeof(T)];
      for (std::size_t begin = 0; !reading_ && begin < count; begin += together) {
        const std::size_t some = std::min(together, count - begin);
        std::memcpy(copies, static_cast<const void*>(values + begin), some * sizeof(T));
        for (std::size_t i = 0; i < some; ++i) __builtin_clear_padding(reinterpret_cast<T*>(copies + i * sizeof(T)));
        bytes(copies, some * sizeof(T));
      }
      if (!reading_) return;
    }
#endif
    bytes(values, count * sizeof(T));
  }
  template <class T>
  void put(T& value) {
    if constexpr (has_archive<T>) {
      value.archive(*this);
    } else {
      static_assert(plain<T> && !std::is_pointer_v<T>, "give this class a function archive(Archive&)");
      put_plain(&value, 1);
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
      put_plain(list.data(), list.size());
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
  int rank_;
  bool giving_ = false;
};

inline void Archive::pass(int, std::size_t) {
  throw std::logic_error("values are asked for that other ranks have, of which this archive does not know");
}
inline void Archive::pass_piece(int rank) {
  pass(rank, 0);
}

}  // namespace nugget
