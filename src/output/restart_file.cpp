// SPDX-License-Identifier: Apache-2.0
#include "output/restart_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <system_error>

#include "base/checksum.hpp"
#include "base/index.hpp"
#include "deck/file_text.hpp"

namespace nugget::output {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view begin_mark = "NUGGETRS", end_mark = "NUGGETRE";
constexpr std::size_t word = sizeof(std::uint64_t);
constexpr std::size_t write_size = 1 << 20;  // bytes of a write, or a read
constexpr std::size_t at_once = 1 << 14;     // of those that ranks send each other

std::string_view raw(const std::uint64_t& number) {
  return {reinterpret_cast<const char*>(&number), word};
}

Json to_json(const RestartHead& h) {
  Json json{{"version", h.version},
            {"program", h.program},
            {"deck", h.deck},
            {"folder", h.folder},
            {"deck_checksum", h.deck_checksum},
            {"date", h.date},
            {"skip_unsupported", h.skip_unsupported},
            {"until", h.until},
            {"max_cycles", h.max_cycles},
            {"checkpoint", h.checkpoint},
            {"weld_law", h.weld_law},
            {"weld_tie", h.weld_tie},
            {"units", h.units},
            {"drop_weld", h.drop_weld},
            {"load_case", h.load_case},
            {"time", h.time},
            {"cycle", h.cycle}};
  if (h.precision != "double") json["precision"] = h.precision;
  if (h.subcycle) json["subcycle"] = true;
  return json;
}

RestartHead from_json(const Json& j) {
  RestartHead h;
  j.at("version").get_to(h.version);
  j.at("program").get_to(h.program);
  j.at("deck").get_to(h.deck);
  j.at("folder").get_to(h.folder);
  j.at("deck_checksum").get_to(h.deck_checksum);
  j.at("date").get_to(h.date);
  j.at("skip_unsupported").get_to(h.skip_unsupported);
  j.at("until").get_to(h.until);
  j.at("max_cycles").get_to(h.max_cycles);
  j.at("checkpoint").get_to(h.checkpoint);
  j.at("weld_law").get_to(h.weld_law);
  j.at("weld_tie").get_to(h.weld_tie);
  j.at("units").get_to(h.units);
  j.at("drop_weld").get_to(h.drop_weld);
  j.at("load_case").get_to(h.load_case);
  j.at("time").get_to(h.time);
  j.at("cycle").get_to(h.cycle);
  h.precision = j.value("precision", h.precision);
  h.subcycle = j.value("subcycle", h.subcycle);
  return h;
}

/// Makes the names in a folder last. Best effort: not every file system can.
void sync_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

void take_name(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) throw WriteError(to, error.message());
}

/// The file with this code.
fs::path& program_file() {
  static fs::path file("/proc/self/exe");
  return file;
}

}  // namespace

void take_for_program(fs::path library) {
  program_file() = std::move(library);
}

std::uint64_t checksum_of_program() {
  static const std::uint64_t sum = [] {
    deck::FileText program;
    return program.open(program_file()).empty() ? checksum(program.view()) : 0;
  }();
  return sum;
}

RestartWriter::RestartWriter(fs::path folder, const RestartHead& head, Ranks* ranks)
    : Archive(false, ranks != nullptr ? ranks->rank() : everyone),
      folder_(std::move(folder)),
      file_(std::in_place, folder_ / "restart.part", OpenMode::draft),
      sum_(checksum_of_nothing) {
  for (int r = 0; ranks != nullptr && r < ranks->count(); ++r) {
    from_.emplace_back();
    if (r != ranks->rank()) from_.back().emplace(*ranks, r);
  }
  const std::string text = to_json(head).dump(-1, ' ', false, Json::error_handler_t::replace);
  put(begin_mark);
  put(raw(text.size()));
  put(text);
}

RestartWriter::~RestartWriter() {
  if (!file_) return;  // finished
  file_.reset();
  std::error_code ignored;
  fs::remove(folder_ / "restart.part", ignored);
}

void RestartWriter::bytes(void* data, std::size_t size) {
  put({static_cast<const char*>(data), size});
}

void RestartWriter::pass(int rank, std::size_t size) {
  if (from_.empty()) return Archive::pass(rank, size);
  std::array<char, at_once> piece;
  for (std::size_t done = 0; done < size; done += piece.size()) {
    const std::size_t now = std::min(piece.size(), size - done);
    (*from_[at(rank)])(piece.data(), now);
    put({piece.data(), now});
  }
}

void RestartWriter::pass_piece(int rank) {
  if (from_.empty()) return Archive::pass_piece(rank);
  std::uint64_t size = 0;
  (*from_[at(rank)])(&size, 1);
  pass(rank, size);
}

void RestartWriter::put(std::string_view text) {
  sum_ = checksum(text, sum_);
  length_ += text.size();
  for (; !text.empty(); text.remove_prefix(std::min(text.size(), write_size))) {
    file_->buffer() += text.substr(0, write_size);
    if (file_->buffer().size() >= write_size) file_->commit();
  }
}

void RestartWriter::finish() {
  const std::uint64_t length = length_, sum = sum_;
  put(raw(length));
  put(raw(sum));
  put(end_mark);
  file_->commit();
  file_->sync();
  const fs::path name = folder_ / "restart";
  if (fs::exists(name)) take_name(name, folder_ / "restart.previous");
  take_name(folder_ / "restart.part", name);
  file_.reset();
  sync_folder(folder_);
}

void RestartSender::bytes(void* data, std::size_t size) {
  if (!giving()) return;
  auto* const text = static_cast<char*>(data);
  if (in_piece_)
    piece_.append(text, size);
  else
    for (std::size_t done = 0; done < size; done += at_once) to_first_(text + done, std::min(at_once, size - done));
}

void RestartSender::end_piece() {
  in_piece_ = false;
  std::uint64_t size = piece_.size();
  to_first_(&size, 1);
  bytes(piece_.data(), piece_.size());
  piece_.clear();
}

RestartReader::File::~File() {
  if (descriptor >= 0) ::close(descriptor);
}

void RestartReader::refuse(const std::string& why) const {
  throw ArchiveError(path_.string() + ": " + why);
}

void RestartReader::read(std::uint64_t place, std::span<char> to) const {
  for (std::size_t done = 0; done < to.size();) {
    const ssize_t n = ::pread(file_.descriptor, to.data() + done, to.size() - done, static_cast<off_t>(place + done));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) refuse(n < 0 ? std::generic_category().message(errno) : "it became shorter while it was read");
    done += static_cast<std::size_t>(n);
  }
}

std::uint64_t RestartReader::number(std::uint64_t place) const {
  std::uint64_t n = 0;
  read(place, {reinterpret_cast<char*>(&n), word});
  return n;
}

std::uint64_t RestartReader::checksum_up_to(std::uint64_t end) {
  std::uint64_t sum = checksum_of_nothing;
  for (std::uint64_t done = 0; done < end; done += piece_.size()) {
    piece_.resize(std::min<std::uint64_t>(write_size, end - done));
    read(done, piece_);
    sum = nugget::checksum(piece_, sum);
  }
  piece_.clear();
  return sum;
}

RestartReader::RestartReader(fs::path path) : Archive(true), path_(std::move(path)) {
  file_.descriptor = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status {};
  if (file_.descriptor < 0 || ::fstat(file_.descriptor, &status) != 0) refuse(std::generic_category().message(errno));
  if (S_ISDIR(status.st_mode)) refuse("it is a folder");
  const auto size = static_cast<std::uint64_t>(status.st_size);
  const std::size_t tail = 2 * word + end_mark.size(), head = begin_mark.size() + word;
  std::string mark(std::min<std::uint64_t>(size, begin_mark.size()), ' ');
  read(0, mark);
  if (mark != begin_mark) refuse("this is no restart file of nugget");
  mark.resize(end_mark.size());
  if (size >= head + tail) read(size - mark.size(), mark);
  if (size < head + tail || mark != end_mark || number(size - tail) != size - tail)
    refuse("the restart file is not whole: it was cut off while or after it was written");
  end_ = size - tail;
  sum_ = checksum_up_to(end_);
  if (number(end_ + word) != sum_) refuse("the restart file is damaged: its checksum does not fit");
  const std::uint64_t length = number(begin_mark.size());
  next_ = head + length;
  if (length > end_ || next_ > end_) refuse("the restart file is damaged: its head is longer than the file");
  std::string text(length, ' ');
  read(head, text);
  try {
    head_ = from_json(Json::parse(text));
  } catch (const Json::exception& error) {
    refuse(std::string("its head cannot be read: ") + error.what());
  }
  if (head_.program != checksum_of_program())
    refuse("it was written by another build of the program (nugget " + head_.version +
           "): go on with that one, or run the deck again");
}

void RestartReader::expect(std::size_t size) const {
  if (size > end_ - next_) refuse("the state ends too early");
}

void RestartReader::bytes(void* data, std::size_t size) {
  expect(size);
  auto* to = static_cast<char*>(data);
  while (size > 0) {
    if (next_ < piece_begin_ || next_ >= piece_begin_ + piece_.size()) {
      piece_.resize(std::min<std::uint64_t>(write_size, end_ - next_));
      piece_begin_ = next_;
      read(next_, piece_);
    }
    const std::size_t here = static_cast<std::size_t>(next_ - piece_begin_), now = std::min(size, piece_.size() - here);
    std::memcpy(to, piece_.data() + here, now);
    to += now;
    size -= now;
    next_ += now;
  }
}

void RestartReader::pass(int, std::size_t size) {
  expect(size);
  next_ += size;
}

std::unique_ptr<RestartReader> open_restart(const fs::path& folder, std::string& warning) {
  const fs::path newest = folder / "restart", before = folder / "restart.previous";
  if (!fs::exists(newest) && !fs::exists(before))
    throw ArchiveError("there is no restart file in " + folder.string() +
                       ": one is written when a run is interrupted (Ctrl-C), and as --checkpoint says");
  if (!fs::exists(before)) return std::make_unique<RestartReader>(newest);
  try {
    return std::make_unique<RestartReader>(newest);
  } catch (const ArchiveError& error) {
    try {
      auto older = std::make_unique<RestartReader>(before);
      warning = error.what();
      return older;
    } catch (const ArchiveError& of_older) {
      throw ArchiveError(std::string(error.what()) + "; nor will the one before it do: " + of_older.what());
    }
  }
}

}  // namespace nugget::output
