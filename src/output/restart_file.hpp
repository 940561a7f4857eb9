// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "output/result_file.hpp"
#include "system/parcel.hpp"

// The restart files of a run, `restart` and, of the time before, `restart.previous`:
//     NUGGETRS, length of the head (8 bytes), head (JSON), state, length of all this, its checksum, NUGGETRE
// A file is written under another name and takes its own when the disk has it all.
namespace nugget::output {

/// What a restart file says of the run beside its state.
struct RestartHead {
  std::string version;              ///< of the program
  std::uint64_t program = 0;        ///< checksum of its executable file
  std::string deck;                 ///< as it was named
  std::string folder;               ///< from which it was named
  std::uint64_t deck_checksum = 0;  ///< of all its files
  std::string date;                 ///< output::Header::date
  bool skip_unsupported = false;    ///< option of the run, as the following
  double until = 0.0;
  long max_cycles = 0;
  std::string checkpoint;
  std::string weld_law;  ///< library, as it was named
  std::string weld_tie;
  std::string units;
  std::string drop_weld;
  int load_case = 0;
  std::string precision = "double";  ///< or `single`
  bool subcycle = false;
  double time = 0.0;  ///< of the model
  long cycle = 0;
};

/// Checksum of the program that runs.
std::uint64_t checksum_of_program();
/// Where this code is in a library that another program has loaded (Python): that file counts as the program. To be
/// said before the checksum is asked for.
void take_for_program(std::filesystem::path library);

/// Writes a restart file into a folder. Throws WriteError; what was there before stays then. `ranks`: null, or those of
/// which this is the first; the others write with a RestartSender. What they give goes into the file as it comes, in
/// pieces: nobody holds the state of another rank.
class RestartWriter final : public Archive {
 public:
  RestartWriter(std::filesystem::path folder, const RestartHead& head, Ranks* ranks = nullptr);
  ~RestartWriter() override;
  /// To be called when all is put in: makes the file `restart`, and the one that was, `restart.previous`.
  void finish();

 private:
  void bytes(void* data, std::size_t size) override;
  void pass(int rank, std::size_t size) override;
  void pass_piece(int rank) override;
  void put(std::string_view text);

  std::filesystem::path folder_;
  std::optional<ResultFile> file_;
  std::uint64_t sum_, length_ = 0;
  std::vector<std::optional<system::Parcel>> from_;  ///< by rank; of this one none
};

/// What another rank than the first has of a restart file, on its way to that.
class RestartSender final : public Archive {
 public:
  explicit RestartSender(Ranks& ranks) : Archive(false, ranks.rank()), to_first_(ranks, std::vector<int>{0}) {}
  /// To be called when all is put in.
  void finish() { to_first_.close(); }

 private:
  void bytes(void* data, std::size_t size) override;
  void begin_piece() override { in_piece_ = true; }
  void end_piece() override;
  void pass(int, std::size_t) override {}
  void pass_piece(int) override {}

  system::Parcel to_first_;
  std::string piece_;
  bool in_piece_ = false;
};

/// A restart file that is whole. Throws ArchiveError where it is not, or not of this program, with what to do. It is
/// read piece by piece, once for its checksum and once for what it holds.
class RestartReader final : public Archive {
 public:
  explicit RestartReader(std::filesystem::path path);
  const RestartHead& head() const { return head_; }
  const std::filesystem::path& path() const { return path_; }
  std::uint64_t checksum() const { return sum_; }  ///< of the file

 private:
  void bytes(void* data, std::size_t size) override;
  void pass(int rank, std::size_t size) override;
  void expect(std::size_t size) const;
  /// Bytes of the file from `place` on, as many as `to` has room for.
  void read(std::uint64_t place, std::span<char> to) const;
  std::uint64_t number(std::uint64_t place) const;
  std::uint64_t checksum_up_to(std::uint64_t end);
  [[noreturn]] void refuse(const std::string& why) const;

  std::filesystem::path path_;
  struct File {
    int descriptor = -1;
    File() = default;
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File();
  } file_;
  RestartHead head_;
  std::uint64_t next_ = 0, end_ = 0, sum_ = 0;
  std::string piece_;              ///< of the file, read ahead
  std::uint64_t piece_begin_ = 0;  ///< where in the file it stands
};

/// Of a folder the newest restart file that is whole. Throws ArchiveError where there is none; `warning` says what is
/// wrong with a newer one.
std::unique_ptr<RestartReader> open_restart(const std::filesystem::path& folder, std::string& warning);

}  // namespace nugget::output
