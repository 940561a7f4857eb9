// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "output/abstat.hpp"
#include "output/bndout.hpp"
#include "output/dcfail.hpp"
#include "output/deforc.hpp"
#include "output/elout.hpp"
#include "output/glstat.hpp"
#include "output/jntforc.hpp"
#include "output/matsum.hpp"
#include "output/nodfor.hpp"
#include "output/nodout.hpp"
#include "output/rbdout.hpp"
#include "output/rcforc.hpp"
#include "output/rwforc.hpp"
#include "output/secforc.hpp"
#include "output/sleout.hpp"
#include "output/spcforc.hpp"
#include "output/swforc.hpp"

namespace nugget::output {

/// `binout0000`, LS-DYNA's binary history file (LSDA), with a branch for each kind of state that is written to it. Ids
/// are 4-byte integers, reals 8-byte. A state and its symbol table reach the disk before the link that makes them
/// known, so a killed run leaves a readable file. The rows of a branch must be the same entities in every state
/// (std::logic_error). Source: the LSDA layout of LSTC's own library; its translator `l2a` and lasso-python read every
/// branch.
class Binout {
 public:
  /// Creates `directory/binout0000`, or continues the file that is there. Throws WriteError.
  Binout(const std::filesystem::path& directory, Header header);

  /// Headings for a branch (`matsum`, `nodout`, `sleout`, `elout/shell`); to be given before its first state.
  void set_legend(const std::string& branch, std::vector<LegendEntry> legend);

  void write(const GlstatState& state);
  void write(const MatsumState& state);
  void write(const NodoutState& state);
  void write(const SwforcState& state);
  void write(const RwforcState& state);
  void write(const SpcforcState& state);
  void write(const BndoutState& state);
  void write(const RbdoutState& state);
  void write(const RcforcState& state);
  void write(const SleoutState& state);
  void write(const DcfailState& state);
  void write(const AbstatState& state);
  void write(const DeforcState& state);
  void write(const JntforcState& state);
  void write(const SecforcState& state);
  void write(const NodforState& state);
  void write(const EloutState& state);
  /// Between two states. Reading, states of later are taken away.
  void archive(Archive& a);

 private:
  /// Where a variable stands in the file, for the symbol table.
  struct Variable {
    char type = 0;
    std::uint64_t offset = 0, count = 0;
  };
  struct Branch {
    int states = 0;
    std::vector<int> ids;
    void archive(Archive& a) { a(states, ids); }
  };

  /// Opens the next state of a branch, before the first one its metadata; true: the caller may add metadata of its own.
  bool begin_state(const std::string& path, std::vector<int> ids);
  void metadata(const std::string& path, const std::string& branch, const std::vector<int>& ids);
  void begin_data(const std::string& path);
  void end_state();
  void write_joint_stiffness(const char* branch, double time, const std::vector<JntforcStiffness>& rows,
                             const std::array<const char*, 16>& names);
  void write_beams(const EloutState& state);
  void write_shells(const EloutState& state);
  void write_solids(const EloutState& state);

  void directory(const std::string& path);
  void text(const std::string& name, const std::string& value);
  void integers(const std::string& name, const std::vector<int>& values);
  void reals(const std::string& name, const std::vector<double>& values);
  void integer(const std::string& name, long value);
  void real(const std::string& name, double value);
  void data(const std::string& name, char type, std::uint64_t count, std::string_view bytes);
  std::string symbol_table() const;

  ResultFile file_;
  Header header_;
  std::map<std::string, std::vector<LegendEntry>> legends_;
  std::map<std::string, Branch> branches_;
  std::string directory_;  ///< of the data being written
  std::map<std::string, std::map<std::string, Variable>>
      variables_;           ///< since the last symbol table, by directory and name
  std::uint64_t link_ = 0;  ///< where the position of the next table goes
};

}  // namespace nugget::output
