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
  Shared shared_due(const system::State& state, bool last) override;
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
    Shared of_ranks{};        ///< what other ranks give to it
    void archive(Archive& a);
  };
  /// d3plot, to which a thread of its own writes the pieces of states. Of those that wait for the disk this process
  /// holds no more than its share of a state: alone a whole one.
  struct StateFile {
    StateFile(const std::filesystem::path& directory, output::D3plotGeometry geometry, output::OpenMode mode)
        : file(directory, std::move(geometry), mode) {
      file.forget_mesh();
    }
    void write(const Snapshot& now);
    void archive(Archive& a);
    output::D3plot file;
    output::WriterThread writer;  ///< ends before the file does
  };
  bool due(const Channel& channel, const system::State& state) const;
  /// `last`: the run ends.
  bool writes(const Channel& channel, const system::State& state, bool last) const {
    return last || due(channel, state) || (state_asked_ && channel.of_states);
  }
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

/// On other ranks than the first: gives their share of what that writes of elements and nodes.
class ResultShares : public Recorder {
 public:
  bool due(const system::State&) override { return false; }
  void write(const Snapshot&, bool) override {}
  void give(const Snapshot& now, Shared what) override;
};

}  // namespace nugget::impact
