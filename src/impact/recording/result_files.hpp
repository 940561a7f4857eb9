// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "impact/recording/histories.hpp"
#include "impact/simulation/snapshot.hpp"
#include "output/d3plot.hpp"
#include "output/writer_thread.hpp"

namespace nugget::impact {

/// Writes the files that the deck's *DATABASE_ cards ask for, each at its own interval: ASCII histories, binout0000,
/// d3plot; and glstat as text in any case, since the report draws the energies from it. Throws output::WriteError when
/// the disk is full or may not be written.
class ResultFiles : public Recorder {
 public:
  ResultFiles(const system::System& system, const std::filesystem::path& directory, const output::Header& header);

  bool due(const system::State& state) override;
  bool energies_due(const system::State& state) override;
  void write(const Snapshot& now, bool last) override;
  void finish() override;
  Marks next_marks() const override;
  void ask_for_state() override { state_asked_ = true; }
  /// Sizes of the files and when they are next due. Reading, what was written later is cut off.
  void archive(Archive& a) override;

 private:
  /// One file with its rhythm.
  struct Channel {
    model::Request request;
    std::function<void(const Snapshot&)> write;
    std::function<void(Archive&)> archive_file;
    double next = 0.0;
    bool of_states = false;   ///< d3plot
    bool of_elements = true;  ///< see Recorder::Marks
    bool of_energies = true;  ///< see energies_due
    void archive(Archive& a);
  };
  /// d3plot, to which a thread of its own writes the states.
  struct StateFile {
    StateFile(const std::filesystem::path& directory, output::D3plotGeometry geometry, output::OpenMode mode)
        : file(directory, std::move(geometry), mode), words(file.words()) {}
    void write(const Snapshot& now);
    void archive(Archive& a);
    output::D3plot file;
    output::D3plotWords words;    ///< of the state that is made, then written
    output::WriterThread writer;  ///< ends before the others do
  };
  bool due(const Channel& channel, const system::State& state) const;
  /// A channel for an ASCII file, for binout, or for both, as the request says.
  void add(const HistoryFile& history, const system::System& system);
  std::shared_ptr<output::Binout> binout();  ///< made where it is asked for first

  const model::Model& model_;
  std::filesystem::path directory_;
  output::Header header_;
  std::shared_ptr<output::Binout> binout_;
  std::shared_ptr<StateFile> states_;
  std::vector<Channel> channels_;
  bool state_asked_ = false;
};

}  // namespace nugget::impact
