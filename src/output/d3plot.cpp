// SPDX-License-Identifier: Apache-2.0
#include "output/d3plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "base/index.hpp"
#include "output/ascii.hpp"
#include "output/d3plot_layout.hpp"

namespace nugget::output {
namespace {

static_assert(std::endian::native == std::endian::little,
              "readers detect the byte order, but the tests know only this one");

constexpr std::size_t block = 512 * d3plot_word;                    // files are filled up to whole blocks
constexpr std::size_t family_member = 7 * 512 * 512 * d3plot_word;  // LS-DYNA's default size of a file
constexpr float format_version = 960.0F;                            // below 971: one word a rigid wall

using Family = D3plotGeometry::Family;

int file_type(Family family) {
  return family == Family::d3plot ? 1 : family == Family::d3eigv ? 11 : 21;
}

/// The nearest number that a word can hold.
float in_range(double value) {
  constexpr double largest = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(value, -largest, largest));
}

/// Puts numbers one after the other into words that are there.
class Put {
 public:
  explicit Put(char* word) : word_(word) {}
  void real(double value) {
    const float number = in_range(value);
    std::memcpy(word_, &number, d3plot_word);
    word_ += d3plot_word;
  }
  void reals(std::initializer_list<double> values) {
    for (const double value : values) real(value);
  }
  void reals(const std::array<double, 6>& values) {
    for (const double value : values) real(value);
  }
  void vector(const Vec3d& v) { reals({v.x, v.y, v.z}); }
  void stress(const StressRecord& record, int histories) {
    reals(record.stress);
    real(record.plastic_strain);
    for (std::size_t i = 0; i < at(histories); ++i) real(i < record.history.size() ? record.history[i] : 0.0);
  }

 private:
  char* word_;
};

/// In the deletion table: the part's number while the element is active, then 0.
double deletion(int part, bool alive) {
  return alive ? part + 1.0 : 0.0;
}

/// A growing stretch of 4-byte words.
class Words {
 public:
  void integer(std::int64_t value) { raw(static_cast<std::int32_t>(value)); }
  void real(double value) { raw(in_range(value)); }
  void vectors(const std::vector<Vec3d>& values) {
    for (const Vec3d& v : values) real(v.x), real(v.y), real(v.z);
  }
  void text(const std::string& value, std::size_t characters) { bytes_ += fixed_width(value, characters); }
  void fill_block() { bytes_.resize((bytes_.size() + block - 1) / block * block, '\0'); }
  std::string& bytes() { return bytes_; }

 private:
  template <class T>
  void raw(T value) {
    static_assert(sizeof(T) == d3plot_word);
    char bytes[d3plot_word];
    std::memcpy(bytes, &value, d3plot_word);
    bytes_.append(bytes, d3plot_word);
  }
  std::string bytes_;
};

/// The solids that are thick shells, or those that are not.
std::vector<D3plotElement<8>> solids_of(const D3plotGeometry& g, bool thick) {
  std::vector<D3plotElement<8>> chosen;
  for (std::size_t e = 0; e < g.solids.size(); ++e)
    if (g.is_thick(e) == thick) chosen.push_back(g.solids[e]);
  return chosen;
}
int numbering_words(const D3plotGeometry& g) {
  return static_cast<int>(16 + g.node_ids.size() + g.solids.size() + g.beams.size() + g.shells.size() +
                          3 * g.parts.size());
}

template <class Elements>
void mark_parts(const Elements& elements, std::vector<bool>& used) {
  for (const auto& element : elements) used[element.part] = true;
}

template <class Elements>
int count_parts(const D3plotGeometry& g, const Elements& elements) {
  std::vector<bool> used(g.parts.size(), false);
  mark_parts(elements, used);
  return static_cast<int>(std::count(used.begin(), used.end(), true));
}

/// Control section: 64 words.
void control(Words& out, const D3plotGeometry& g) {
  const int solid_parts = count_parts(g, solids_of(g, false)), thick_parts = count_parts(g, solids_of(g, true)),
            beam_parts = count_parts(g, g.beams);
  // Each part counts once; one without elements goes with the shells.
  const int shell_parts = static_cast<int>(g.parts.size()) - solid_parts - thick_parts - beam_parts;
  out.text(g.title, 40);
  out.integer(g.seconds_since_1970);
  out.integer(file_type(g.family));
  out.integer(0);  // source version
  out.text("R11", d3plot_word);
  out.real(format_version);
  out.integer(4);  // NDIM: three dimensions, connectivity unpacked
  out.integer(static_cast<std::int64_t>(g.node_ids.size()));
  out.integer(6);  // ICODE
  out.integer(global_words(g));
  out.integer(0);                                                            // IT: no temperatures
  out.integer(1);                                                            // IU: coordinates
  for (int flag = 0; flag < 2; ++flag) out.integer(holds_modes(g) ? 0 : 1);  // IV, IA
  out.integer(static_cast<std::int64_t>(g.solids.size() - count_thick_shells(g)));
  out.integer(solid_parts);
  out.integer(0), out.integer(0);  // NUMDS, NUMST
  out.integer(solid_words(g));
  out.integer(static_cast<std::int64_t>(g.beams.size()));
  out.integer(beam_parts);
  out.integer(beam_words(g));
  out.integer(static_cast<std::int64_t>(g.shells.size()));
  out.integer(shell_parts);
  out.integer(shell_words(g));
  out.integer(g.solid_histories + (g.strains ? 6 : 0));  // NEIPH: extra words of solids, strains last
  out.integer(g.shell_histories);                        // NEIPS
  out.integer(-10000 - g.layers);                        // MAXINT, with the element deletion table
  out.integer(0), out.integer(0);                        // NMSPH, NGPSPH
  out.integer(numbering_words(g));
  out.integer(static_cast<std::int64_t>(count_thick_shells(g)));
  out.integer(thick_parts);
  out.integer(thick_shell_words(g));
  for (int flag = 0; flag < 4; ++flag)  // IOSHL: stress, plastic strain, resultants, thickness are there
    out.integer(g.shell_stresses || flag == 3 ? 1000 : 999);
  for (int unused = 47; unused < 51; ++unused) out.integer(0);
  out.integer(static_cast<std::int64_t>(g.parts.size()));  // NMMAT
  for (int unused = 52; unused < 64; ++unused) out.integer(0);
}

/// Connectivity counts from 1; `blanks` zeros stand between nodes and part (a beam's orientation node and two spares).
template <class Elements>
void connectivity(Words& out, const Elements& elements, int blanks = 0) {
  for (const auto& element : elements) {
    for (const int node : element.nodes) out.integer(node + 1);
    for (int i = 0; i < blanks; ++i) out.integer(0);
    out.integer(element.part + 1);
  }
}

template <class Elements>
void ids(Words& out, const Elements& elements) {
  for (const auto& element : elements) out.integer(element.id);
}

/// User numbers, in the form for arbitrary part ids (NSORT < 0).
void numbering(Words& out, const D3plotGeometry& g) {
  const auto nodes = static_cast<std::int64_t>(g.node_ids.size()),
             thick_shells = static_cast<std::int64_t>(count_thick_shells(g)),
             solids = static_cast<std::int64_t>(g.solids.size()) - thick_shells,
             beams = static_cast<std::int64_t>(g.beams.size()), shells = static_cast<std::int64_t>(g.shells.size()),
             parts = static_cast<std::int64_t>(g.parts.size());
  const std::int64_t thick_begin = 1 + nodes + solids + beams + shells, elements_end = thick_begin + thick_shells;
  out.integer(-1);                          // NSORT
  out.integer(1 + nodes);                   // NSRH
  out.integer(1 + nodes + solids);          // NSRB
  out.integer(1 + nodes + solids + beams);  // NSRS
  out.integer(thick_begin);                 // NSRT
  out.integer(nodes);
  out.integer(solids);
  out.integer(beams);
  out.integer(shells);
  out.integer(thick_shells);
  out.integer(elements_end);              // NSRMA
  out.integer(elements_end + parts);      // NSRMU
  out.integer(elements_end + 2 * parts);  // NSRMP
  out.integer(parts);
  out.integer(g.nodal_rigid_bodies);
  out.integer(parts);
  for (const int id : g.node_ids) out.integer(id);
  ids(out, solids_of(g, false));
  ids(out, g.beams);
  ids(out, g.shells);
  ids(out, solids_of(g, true));

  std::vector<std::size_t> ascending(g.parts.size()), rank(g.parts.size());
  std::iota(ascending.begin(), ascending.end(), std::size_t{0});
  std::sort(ascending.begin(), ascending.end(), [&](auto i, auto j) { return g.parts[i].id < g.parts[j].id; });
  for (std::size_t k = 0; k < ascending.size(); ++k) rank[ascending[k]] = k;
  for (const std::size_t i : ascending) out.integer(g.parts[i].id);
  ids(out, g.parts);
  for (const std::size_t k : rank) out.integer(static_cast<std::int64_t>(k) + 1);
}

void titles(Words& out, const D3plotGeometry& g) {
  out.real(d3plot_end_of_states);
  out.integer(90001);
  out.integer(static_cast<std::int64_t>(g.parts.size()));
  for (const D3plotPart& part : g.parts) {
    out.integer(part.id);
    out.text(part.title, 72);
  }
  out.integer(90000);
  out.text(g.title, 72);
  out.real(d3plot_end_of_states);
}

template <class Elements>
void check_elements(const D3plotGeometry& g, const Elements& elements, const char* kind) {
  const auto outside = [](int index, std::size_t size) { return index < 0 || at(index) >= size; };
  int last = std::numeric_limits<int>::min();
  for (const auto& element : elements) {
    if (element.id <= last)
      throw std::logic_error(fmt::format("d3plot: ids of {}s do not ascend at {}", kind, element.id));
    last = element.id;
    for (const int node : element.nodes)
      if (outside(node, g.node_ids.size()))
        throw std::logic_error(fmt::format("d3plot: {} {} has no such node", kind, last));
    if (outside(element.part, g.parts.size()))
      throw std::logic_error(fmt::format("d3plot: {} {} has no part", kind, last));
  }
}

void check(const D3plotGeometry& g) {
  if (g.node_ids.size() != g.x.size()) throw std::logic_error("d3plot: as many node ids as coordinates are wanted");
  if (!std::is_sorted(g.node_ids.begin(), g.node_ids.end(), std::less_equal<>()))
    throw std::logic_error("d3plot: node ids do not ascend");
  if (!g.thick.empty() && g.thick.size() != g.solids.size())
    throw std::logic_error("d3plot: of each solid is wanted whether it is a thick shell");
  if (g.layers < 1) throw std::logic_error("d3plot: a shell has at least one layer");
  check_elements(g, g.solids, "solid");
  check_elements(g, g.beams, "beam");
  check_elements(g, g.shells, "shell");
}

void check_size(std::size_t size, std::size_t wanted, const char* name) {
  if (size != wanted)
    throw std::logic_error(fmt::format("d3plot: {} has {} entries instead of {}", name, size, wanted));
}

void check(const D3plotGeometry& g, const D3plotState& s) {
  const std::size_t nodes = g.node_ids.size();
  check_size(s.x.size(), nodes, "x");
  check_size(s.v.size(), holds_modes(g) ? 0 : nodes, "v");
  check_size(s.a.size(), holds_modes(g) ? 0 : nodes, "a");
  check_size(s.solids.size(), g.solids.size(), "solids");
  check_size(s.thick_shells.size(), count_thick_shells(g), "thick_shells");
  check_size(s.thick_layers.size(), count_thick_shells(g) * at(g.layers), "thick_layers");
  check_size(s.beams.size(), g.beams.size(), "beams");
  check_size(s.beam_points.size(), g.beams.size() * at(g.beam_points), "beam_points");
  check_size(s.shells.size(), g.shells.size(), "shells");
  check_size(s.shell_layers.size(), g.shells.size() * at(g.layers_of_shells()), "shell_layers");
  if (!s.solid_alive.empty()) check_size(s.solid_alive.size(), g.solids.size(), "solid_alive");
  if (!s.beam_alive.empty()) check_size(s.beam_alive.size(), g.beams.size(), "beam_alive");
  if (!s.shell_alive.empty()) check_size(s.shell_alive.size(), g.shells.size(), "shell_alive");
}

}  // namespace

std::string D3plotGeometry::stem() const {
  return (family == Family::d3plot ? "d3plot" : family == Family::d3eigv ? "d3eigv" : "d3ssd") + suffix;
}

void shell_layers(std::span<const StressRecord> points, std::span<StressRecord> layers) {
  std::fill(layers.begin(), layers.end(), StressRecord{});
  if (points.empty()) return;
  if (layers.size() != 3) {
    std::copy_n(points.begin(), std::min(points.size(), layers.size()), layers.begin());
    return;
  }
  const std::size_t n = points.size();
  const StressRecord &a = points[(n - 1) / 2], &b = points[n / 2];
  for (std::size_t i = 0; i < 6; ++i) layers[0].stress[i] = 0.5 * (a.stress[i] + b.stress[i]);
  layers[0].plastic_strain = 0.5 * (a.plastic_strain + b.plastic_strain);
  for (std::size_t i = 0; i < a.history.size(); ++i) layers[0].history[i] = 0.5 * (a.history[i] + b.history[i]);
  layers[1] = points.front();
  layers[2] = points.back();
}

D3plotLayout::D3plotLayout(const D3plotGeometry& g)
    : layers_(at(g.layers)),
      beam_points_(at(g.beam_points)),
      parts_(g.parts.size() + at(g.nodal_rigid_bodies)),
      walls_(at(g.rigid_walls)),
      solid_histories_(g.solid_histories),
      shell_histories_(g.shell_histories),
      strains_(g.strains),
      shell_stresses_(g.shell_stresses) {
  const std::size_t thick = count_thick_shells(g), bricks = g.solids.size() - thick;
  all_ = 1 + at(global_words(g));
  const auto add = [this](Stretch s, std::size_t count, int words) {
    count_[s] = count;
    words_[s] = at(words);
    begin_[s] = all_;
    all_ += count * at(words);
  };
  add(coordinates, g.node_ids.size(), 3);
  for (const Stretch s : {velocities, accelerations}) add(s, g.node_ids.size(), holds_modes(g) ? 0 : 3);
  add(solids, bricks, solid_words(g));
  add(thick_shells, thick, thick_shell_words(g));
  add(beams, g.beams.size(), beam_words(g));
  add(shells, g.shells.size(), shell_words(g));
  add(solid_deletion, bricks, 1);
  add(thick_deletion, thick, 1);
  add(shell_deletion, g.shells.size(), 1);
  add(beam_deletion, g.beams.size(), 1);
}

void D3plotLayout::put(char* to, const D3plotTotals& s) const {
  check_size(s.parts.size(), parts_, "parts");
  check_size(s.wall_forces.size(), walls_, "wall_forces");
  Put out(to);
  out.reals({s.time, s.kinetic, s.internal, s.total});
  out.vector(s.velocity);
  for (const D3plotPartState& part : s.parts) out.real(part.internal);
  for (const D3plotPartState& part : s.parts) out.real(part.kinetic);
  for (const D3plotPartState& part : s.parts) out.vector(part.velocity);
  for (const D3plotPartState& part : s.parts) out.real(part.mass);
  for (const D3plotPartState& part : s.parts) out.real(part.hourglass);
  for (const double force : s.wall_forces) out.real(force);
}

void D3plotLayout::put(char* to, const Vec3d& vector) {
  Put(to).vector(vector);
}

void D3plotLayout::put(char* to, const SolidRecord& record) const {
  Put out(to);
  out.stress(record, solid_histories_);
  if (strains_) out.reals(record.strain);
}

void D3plotLayout::put(char* to, const ThickShellRecord& r, std::span<const StressRecord> layers) const {
  Put out(to);
  for (const StressRecord& layer : layers) out.stress(layer, shell_histories_);
  if (strains_) {
    out.reals(r.inner_strain);
    out.reals(r.outer_strain);
  }
  out.real(r.internal_energy);
}

void D3plotLayout::put(char* to, const BeamRecord& r, std::span<const BeamPointRecord> points) const {
  Put out(to);
  out.reals({r.axial, r.shear_s, r.shear_t, r.moment_s, r.moment_t, r.torsion});
  for (const BeamPointRecord& p : points)
    out.reals({p.stress_rs, p.stress_tr, p.stress_axial, p.plastic_strain, p.axial_strain});
}

void D3plotLayout::put(char* to, const ShellRecord& r, std::span<const StressRecord> layers) const {
  Put out(to);
  for (const StressRecord& layer : layers) out.stress(layer, shell_histories_);
  if (shell_stresses_) out.reals({r.mx, r.my, r.mxy, r.qx, r.qy, r.nx, r.ny, r.nxy});
  out.real(r.thickness);
  out.reals({0.0, 0.0});  // two words that depend on the element formulation
  if (shell_stresses_ && strains_) {
    out.reals(r.inner_strain);
    out.reals(r.outer_strain);
  }
  out.real(r.internal_energy);
}

void D3plotLayout::put_deletion(char* to, int part, bool alive) {
  Put(to).real(deletion(part, alive));
}

D3plot::D3plot(std::filesystem::path directory, D3plotGeometry geometry, OpenMode mode)
    : directory_(std::move(directory)), geometry_(std::move(geometry)), layout_(geometry_) {
  const D3plotGeometry& g = geometry_;
  check(g);
  if (mode == OpenMode::append) return;
  Words out;
  control(out, g);
  out.vectors(g.x);
  connectivity(out, solids_of(g, false));
  connectivity(out, solids_of(g, true));
  connectivity(out, g.beams, 3);
  connectivity(out, g.shells);
  numbering(out, g);
  titles(out, g);
  out.fill_block();
  ResultFile root(directory_ / geometry_.stem());
  root.buffer() = std::move(out.bytes());
  root.commit();
}

void D3plot::write(const D3plotState& s) {
  const D3plotGeometry& g = geometry_;
  check(g, s);
  std::string words(layout_.all_words() * d3plot_word, '\0');
  const auto each = [&](D3plotLayout::Stretch stretch, const auto& put) {
    const std::size_t size = layout_.words(stretch) * d3plot_word;
    char* to = words.data() + layout_.begin(stretch) * d3plot_word;
    for (std::size_t i = 0; i < layout_.count(stretch) && size > 0; ++i, to += size) put(to, i);
  };
  const auto vectors = [&](D3plotLayout::Stretch stretch, const std::vector<Vec3d>& of_nodes) {
    each(stretch, [&](char* to, std::size_t n) { D3plotLayout::put(to, of_nodes[n]); });
  };
  const auto deletions = [&](D3plotLayout::Stretch stretch, const std::vector<char>& flags, const auto& element) {
    each(stretch, [&](char* to, std::size_t i) {
      const auto [e, part] = element(i);
      D3plotLayout::put_deletion(to, part, flags.empty() || flags[e] != 0);
    });
  };
  const auto points = at(g.beam_points), layers = at(g.layers), of_shells = at(g.layers_of_shells());
  std::array<std::vector<std::size_t>, 2> solids;  // bricks, thick shells
  for (std::size_t e = 0; e < s.solids.size(); ++e) solids[g.is_thick(e) ? 1 : 0].push_back(e);
  layout_.put(words.data(), s);
  vectors(D3plotLayout::coordinates, s.x);
  vectors(D3plotLayout::velocities, s.v);
  vectors(D3plotLayout::accelerations, s.a);
  each(D3plotLayout::solids, [&](char* to, std::size_t i) { layout_.put(to, s.solids[solids[0][i]]); });
  each(D3plotLayout::thick_shells, [&](char* to, std::size_t i) {
    layout_.put(to, s.thick_shells[i], std::span(s.thick_layers).subspan(i * layers, layers));
  });
  each(D3plotLayout::beams, [&](char* to, std::size_t e) {
    layout_.put(to, s.beams[e], std::span(s.beam_points).subspan(e * points, points));
  });
  each(D3plotLayout::shells, [&](char* to, std::size_t e) {
    layout_.put(to, s.shells[e], std::span(s.shell_layers).subspan(e * of_shells, of_shells));
  });
  const auto part_of = [](const auto& elements) {
    return [&elements](std::size_t e) { return std::pair(e, elements[e].part); };
  };
  const auto part_of_solid = [&](std::size_t kind) {
    return [&, kind](std::size_t i) { return std::pair(solids[kind][i], g.solids[solids[kind][i]].part); };
  };
  deletions(D3plotLayout::solid_deletion, s.solid_alive, part_of_solid(0));
  deletions(D3plotLayout::thick_deletion, s.solid_alive, part_of_solid(1));
  deletions(D3plotLayout::shell_deletion, s.shell_alive, part_of(g.shells));
  deletions(D3plotLayout::beam_deletion, s.beam_alive, part_of(g.beams));
  begin_state();
  put_piece(words);
  end_state();
}

void D3plot::forget_mesh() {
  D3plotGeometry kept;
  kept.family = geometry_.family;
  kept.suffix = geometry_.suffix;
  kept.one_state_a_file = geometry_.one_state_a_file;
  geometry_ = std::move(kept);
}

/// A state goes behind the last one, over its end mark, and never across two files. All but its first word is written
/// before that word replaces the mark: until then readers stop where they did.
void D3plot::begin_state() {
  const bool full = end_mark_ + (layout_.all_words() + 1) * d3plot_word > family_member;
  if (!member_ || full || geometry_.one_state_a_file) {
    if (member_) member_->sync();  // a restart file counts on it, and looks after the last one only
    member_.emplace(member_path(++members_));
    end_mark_ = 0;
  }
  next_ = end_mark_;
  first_word_.clear();
}

void D3plot::put_piece(std::string_view bytes) {
  if (next_ == end_mark_) {
    first_word_ = bytes.substr(0, d3plot_word);
    next_ += d3plot_word;
    bytes.remove_prefix(d3plot_word);
  }
  member_->write_ahead(next_, bytes);
  next_ += bytes.size();
}

void D3plot::end_state() {
  if (next_ != end_mark_ + layout_.all_words() * d3plot_word)
    throw std::logic_error(fmt::format("d3plot: a state of {} bytes has {} instead of {} words", next_ - end_mark_,
                                       (next_ - end_mark_) / d3plot_word, layout_.all_words()));
  Words mark;
  mark.real(d3plot_end_of_states);
  std::string tail(mark.bytes());
  const std::uint64_t used = next_ + tail.size();
  tail.resize(tail.size() + (block - used % block) % block, '\0');
  member_->write_ahead(next_, tail);
  member_->count_up_to(next_ + tail.size());
  member_->write_at(end_mark_, first_word_);
  end_mark_ = next_;
}

std::filesystem::path D3plot::member_path(int number) const {
  return directory_ / fmt::format("{}{:02}", geometry_.stem(), number);
}

void D3plot::archive(Archive& a) {
  a(members_, end_mark_);
  a.built(directory_, geometry_, layout_, next_, first_word_);
  if (a.reading()) {
    member_.reset();
    if (members_ > 0) member_.emplace(member_path(members_), OpenMode::append);
    for (int later = members_ + 1; std::filesystem::remove(member_path(later)); ++later) continue;
  }
  if (!member_) return;
  member_->archive(a);
  if (!a.reading()) return;
  // A later state may have begun over the mark, and in the rest of its block.
  Words mark;
  mark.real(d3plot_end_of_states);
  std::string tail(mark.bytes());
  tail.resize(member_->size() - end_mark_, '\0');
  member_->write_at(end_mark_, tail);
}

}  // namespace nugget::output
