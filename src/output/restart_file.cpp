// SPDX-License-Identifier: Apache-2.0
#include "output/restart_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <system_error>

#include "base/checksum.hpp"

namespace nugget::output {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view begin_mark = "NUGGETRS", end_mark = "NUGGETRE";
constexpr std::size_t word = sizeof(std::uint64_t);
constexpr std::size_t write_size = 1 << 20;  // bytes of a write

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

RestartWriter::RestartWriter(fs::path folder, const RestartHead& head)
    : Archive(false),
      folder_(std::move(folder)),
      file_(std::in_place, folder_ / "restart.part", OpenMode::draft),
      sum_(checksum_of_nothing) {
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

void RestartWriter::put(std::string_view text) {
  sum_ = checksum(text, sum_);
  length_ += text.size();
  file_->buffer() += text;
  if (file_->buffer().size() >= write_size) file_->commit();
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

void RestartReader::refuse(const std::string& why) const {
  throw ArchiveError(path_.string() + ": " + why);
}

std::uint64_t RestartReader::number(std::uint64_t place) const {
  std::uint64_t n = 0;
  std::memcpy(&n, text_.view().data() + place, word);
  return n;
}

RestartReader::RestartReader(fs::path path) : Archive(true), path_(std::move(path)) {
  const std::string trouble = text_.open(path_);
  if (!trouble.empty()) refuse(trouble);
  const std::string_view text = text_.view();
  const std::size_t tail = 2 * word + end_mark.size(), head = begin_mark.size() + word;
  if (!text.starts_with(begin_mark)) refuse("this is no restart file of nugget");
  if (text.size() < head + tail || !text.ends_with(end_mark) || number(text.size() - tail) != text.size() - tail)
    refuse("the restart file is not whole: it was cut off while or after it was written");
  end_ = text.size() - tail;
  if (number(end_ + word) != checksum(text.substr(0, end_)))
    refuse("the restart file is damaged: its checksum does not fit");
  const std::uint64_t length = number(begin_mark.size());
  next_ = head + length;
  if (next_ > end_) refuse("the restart file is damaged: its head is longer than the file");
  try {
    head_ = from_json(Json::parse(text.substr(head, length)));
  } catch (const Json::exception& error) {
    refuse(std::string("its head cannot be read: ") + error.what());
  }
  if (head_.program != checksum_of_program())
    refuse("it was written by another build of the program (nugget " + head_.version +
           "): go on with that one, or run the deck again");
}

void RestartReader::bytes(void* data, std::size_t size) {
  if (size > end_ - next_) refuse("the state ends too early");
  if (size == 0) return;  // an empty vector has no place to copy to
  std::memcpy(data, text_.view().data() + next_, size);
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
