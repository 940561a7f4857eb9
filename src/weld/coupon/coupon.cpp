// SPDX-License-Identifier: Apache-2.0
#include "weld/coupon/coupon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "base/append.hpp"
#include "deck/text.hpp"
#include "model/weld_section.hpp"
#include "weld/placement/deck_text.hpp"

namespace nugget::weld {
namespace {

using Line = std::vector<double>;

/// How a coupon is pulled. Millimetres, metres per second.
struct Pull {
  double stroke = 0.0, speed = 0.0;
  double duration() const { return 1e-3 * stroke / (0.9 * speed); }  ///< [s]; the ramp's mean is a half
};
constexpr int first_weld_node = 90001;
constexpr double ramp = 0.2;  // share of the duration in which the velocity rises

Pull pull_of(const CouponTest& test) {
  switch (test.kind) {
    case CouponKind::lap_shear: return {4.0, 0.4};
    case CouponKind::coach_peel: return {40.0, 1.5};
    case CouponKind::cross_tension: return {24.0, 1.0};
    case CouponKind::ks2: break;
  }
  const double normal = std::sin(test.angle * std::numbers::pi / 180.0);
  return {4.0 + 10.0 * normal, 0.4 + 0.4 * normal};
}

/// A beam, or what RPBHX of *CONTROL_SPOTWELD_BEAM puts in its place.
bool becomes_bricks_later(WeldForm form) {
  return named(form).bricks <= 8;
}

double square(double x) {
  return x * x;
}

/// Mesh lines from a to b, b left out, about `size` apart.
void spread(Line& to, double a, double b, double size) {
  const int count = std::max(1, static_cast<int>(std::lround(std::abs(b - a) / size)));
  for (int i = 0; i < count; ++i) to.push_back(a + i * (b - a) / count);
}

/// Lines around 0 in an odd number of elements, which are nearly as large as the weld: it stands over the centre of
/// one.
Line patch(double side, double size) {
  const int pairs = std::max(1, static_cast<int>(std::lround(0.5 * (side / size - 1.0))));
  const int cells = 2 * pairs + 1;
  Line x;
  for (int i = 0; i <= cells; ++i) x.push_back(-0.5 * side + i * side / cells);
  return x;
}

/// The mesh of a coupon in millimetres, the weld at the origin, the sheets' common face at z = 0.
class CouponMesh {
 public:
  CouponMesh(const CouponCard& card, const CouponTest& test) : millimetre_(card.units.millimetre) {
    lower_ = -0.5 * card.sheets[0].thickness / millimetre_;
    upper_ = 0.5 * card.sheets[1].thickness / millimetre_;
    size_ = 0.95 * card.diameter / millimetre_;
    switch (test.kind) {
      case CouponKind::lap_shear: make_lap_shear(); break;
      case CouponKind::coach_peel: make_coach_peel(); break;
      case CouponKind::cross_tension: make_cross_tension(); break;
      case CouponKind::ks2: turn_ = (90.0 - test.angle) * std::numbers::pi / 180.0; make_ks2();
    }
    if (card.weld_nodes != 0)
      nodes_ += node_line(first_weld_node, {});
    else if (!becomes_bricks_later(card.form))
      add_bricks(
          model::weld_section(named(card.form).bricks, 0.25 * std::numbers::pi * square(card.diameter / millimetre_)));
    else
      add_beam();
  }

  std::string text() const {
    return "*NODE\n$#   nid               x               y               z\n" + nodes_ +
           "*ELEMENT_SHELL\n$#   eid     pid      n1      n2      n3      n4\n" + shells_ + weld_;
  }
  int node_of_moving_grip() const { return of_grip_; }

 private:
  using Place = std::function<Vec3d(double)>;

  void add_beam() {
    nodes_ += node_line(first_weld_node, {0, 0, lower_});
    nodes_ += node_line(first_weld_node + 1, {0, 0, upper_});
    weld_ = fmt::format("*ELEMENT_BEAM\n$#   eid     pid      n1      n2      n3\n{:8d}{:8d}{:8d}{:8d}{:8d}\n",
                        coupon_weld_element, coupon_weld, first_weld_node, first_weld_node + 1, 0);
  }

  void add_bricks(const model::WeldSection& section) {
    const int points = static_cast<int>(section.point.size()), below = first_weld_node, above = below + points;
    for (int i = 0; i < points; ++i) {
      const auto& [s, t] = section.point[static_cast<std::size_t>(i)];
      nodes_ += node_line(below + i, {s, t, lower_}) + node_line(above + i, {s, t, upper_});
    }
    weld_ = brick_header + brick_lines(section, coupon_weld_element, coupon_weld, below, above);
  }

  /// KS-2 is turned about x until the load is along z.
  std::string node_line(int id, const Vec3d& x) const {
    const double c = std::cos(turn_), s = std::sin(turn_);
    const Vec3d at = millimetre_ * Vec3d{x.x, c * x.y - s * x.z, s * x.y + c * x.z};
    return fmt::format("{:8d}{:16.9g}{:16.9g}{:16.9g}\n", id, at.x, at.y, at.z);
  }

  /// A sheet swept over the points of `path`, each moved along the vectors of `across`; elements whose middle `grip`
  /// names belong to the grip.
  void sheet(bool moves, const std::vector<Vec3d>& path, const std::vector<Vec3d>& across,
             const std::function<bool(const Vec3d&)>& grip) {
    const auto id = [&](std::size_t i, std::size_t j) {
      return (moves ? 20001 : 10001) + static_cast<int>(i * across.size() + j);
    };
    for (std::size_t i = 0; i < path.size(); ++i)
      for (std::size_t j = 0; j < across.size(); ++j) nodes_ += node_line(id(i, j), path[i] + across[j]);
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      for (std::size_t j = 0; j + 1 < across.size(); ++j) {
        const bool held =
            grip(0.25 * (path[i] + path[i + 1] + path[i] + path[i + 1]) + 0.5 * (across[j] + across[j + 1]));
        const int part = held ? (moves ? coupon_moving_grip : coupon_held_grip) : moves ? coupon_upper : coupon_lower;
        append(shells_, "{:8d}{:8d}{:8d}{:8d}{:8d}{:8d}\n", ++last_shell_, part, id(i, j), id(i + 1, j),
               id(i + 1, j + 1), id(i, j + 1));
        if (held && moves) of_grip_ = id(i, j);
      }
  }

  static std::vector<Vec3d> places(const Line& line, const Place& place) {
    std::vector<Vec3d> x;
    for (const double v : line) x.push_back(place(v));
    return x;
  }

  void make_lap_shear() {
    const Line middle = patch(40.0, size_);
    Line x;
    spread(x, -80.0, -50.0, size_);
    spread(x, -50.0, -20.0, size_);
    x.insert(x.end(), middle.begin(), middle.end());
    const auto grip = [](const Vec3d& p) { return std::abs(p.x) > 50.0; };
    for (const bool moves : {false, true}) {
      const double side = moves ? -1.0 : 1.0, z = moves ? upper_ : lower_;
      sheet(moves,
            places(x,
                   [=](double v) {
                     return Vec3d{side * v, 0, z};
                   }),
            places(middle,
                   [=](double v) {
                     return Vec3d{0, side * v, 0};
                   }),
            grip);
    }
  }

  void make_coach_peel() {
    const Line middle = patch(40.0, size_);
    Line arm;
    spread(arm, -80.0, -60.0, size_);
    spread(arm, -60.0, 0.0, size_);
    const auto grip = [](const Vec3d& p) { return std::abs(p.z) > 60.0; };
    for (const bool moves : {false, true}) {
      const double side = moves ? -1.0 : 1.0, z = moves ? upper_ : lower_;
      std::vector<Vec3d> path = places(arm, [=](double h) { return Vec3d{-20.0, 0, side * h + z}; });
      for (const double v : middle) path.push_back({v, 0, z});
      sheet(moves, path, places(middle, [=](double v) { return Vec3d{0, side * v, 0}; }), grip);
    }
  }

  void make_cross_tension() {
    const Line middle = patch(48.0, size_);
    Line s;
    spread(s, -60.0, -40.0, size_);
    spread(s, -40.0, -24.0, size_);
    const Line wing = s;
    s.insert(s.end(), middle.begin(), middle.end());
    for (std::size_t i = wing.size(); i-- > 0;) s.push_back(-wing[i]);
    const auto grip = [](const Vec3d& p) { return std::max(std::abs(p.x), std::abs(p.y)) > 40.0; };
    sheet(false,
          places(s,
                 [&](double v) {
                   return Vec3d{v, 0, lower_};
                 }),
          places(middle,
                 [](double v) {
                   return Vec3d{0, v, 0};
                 }),
          grip);
    sheet(true,
          places(s,
                 [&](double v) {
                   return Vec3d{0, v, upper_};
                 }),
          places(middle,
                 [](double v) {
                   return Vec3d{-v, 0, 0};
                 }),
          grip);
  }

  /// Two channels, web on web: webs of 36, 50 along the channel, flanges of 20 of which the outer 12 are in the grip.
  void make_ks2() {
    const Line web = patch(36.0, size_), along = patch(50.0, size_);
    Line flange;
    spread(flange, 20.0, 8.0, size_);
    spread(flange, 8.0, 0.0, size_);
    const double to_grip = 8.0;
    for (const bool moves : {false, true}) {
      const double side = moves ? 1.0 : -1.0, z = moves ? upper_ : lower_;
      std::vector<Vec3d> path;
      for (const double h : flange) path.push_back({-18.0, 0, z + side * h});
      for (const double v : web) path.push_back({v, 0, z});
      for (std::size_t i = flange.size(); i-- > 0;) path.push_back({18.0, 0, z + side * flange[i]});
      sheet(moves, path,
            places(along,
                   [=](double v) {
                     return Vec3d{0, -side * v, 0};
                   }),
            [=](const Vec3d& p) { return std::abs(p.z - z) > to_grip; });
    }
  }

  double millimetre_, lower_ = 0.0, upper_ = 0.0, size_ = 0.0, turn_ = 0.0;
  std::string nodes_, shells_, weld_;
  int last_shell_ = 0, of_grip_ = 0;
};

class CouponDeck {
 public:
  CouponDeck(const CouponCard& card, const CouponTest& test) : card_(card), test_(test), next_(card.used) {}

  std::string text() {
    const CouponMesh mesh(card_, test_);
    std::string s = head();
    s += controls(mesh.node_of_moving_grip());
    s += sheets();
    s += weld();
    s += grips();
    return s + mesh.text() + "*END\n";
  }

 private:
  double seconds(double value) const { return 1e6 * value * card_.units.microsecond; }
  double megapascal() const { return card_.units.steel_young / 210000.0; }
  static std::string reals(std::initializer_list<double> values) {
    std::string s;
    for (const double v : values) s += real_field(v);
    return s + '\n';
  }
  static std::string columns(std::initializer_list<int> values) {
    std::string s;
    for (const int v : values) s += fmt::format("{:10d}", v);
    return s;
  }
  static std::string ints(std::initializer_list<int> values) { return columns(values) + '\n'; }

  std::string head() const {
    const auto mm = [&](double length) { return length / card_.units.millimetre; };
    return fmt::format(
        "*KEYWORD\n*TITLE\n{} of a spot weld, made by nugget coupon\n$ Units: {}. Sheets of {:.4g} (part 1, held) and "
        "{:.4g} mm (part 2, pulled), weld of {:.4g} mm\n$ (part 3). The angle is that between the load and the "
        "sheets.\n*INCLUDE\n{}",
        test_.title(), card_.units.name, mm(card_.sheets[0].thickness), mm(card_.sheets[1].thickness),
        mm(card_.diameter), deck::name_lines(card_.included));
  }

  std::string controls(int node) const {
    const double end = seconds(pull_of(test_).duration());
    std::string s = "*CONTROL_TERMINATION\n$#  endtim\n" + reals({end});
    s += "$ The mass of small elements, the weld's above all, is raised to this step: it adds little to what is pulled "
         "slowly.\n*CONTROL_TIMESTEP\n$#  dtinit    tssfac      isdo    tslimt     dt2ms\n" +
         fmt::format("{:10.1f}{:10.1f}{:10d}{:10.1f}", 0.0, 0.9, 0, 0.0) + reals({seconds(-6e-7)});
    s += "*CONTROL_ENERGY\n$#    hgen      rwen    slnten     rylen\n" + ints({2, 2, 2, 2});
    s += "*CONTROL_HOURGLASS\n$#     ihq        qh\n" + fmt::format("{:10d}{:10.2f}\n", 4, 0.01);
    s += "$ istupd = 1: the sheets thin as they stretch.\n*CONTROL_SHELL\n$#  wrpang     esort     irnxx    istupd\n" +
         fmt::format("{:10.1f}{:10d}{:10d}{:10d}\n", 20.0, 0, -1, 1);
    s += "$ spotstp = 1: a weld that finds no sheet is an error.\n*CONTROL_CONTACT\n$#  slsfac\n       0.1\n"
         "$#  usrstr\n         0\n$#   sfric\n       0.0\n$#  ignore    frceng   skiprwg    outseg   spotstp\n" +
         ints({0, 0, 0, 0, 1});
    for (const auto& [name, states] :
         {std::pair{"GLSTAT", 100.0}, std::pair{"SWFORC", 1000.0}, std::pair{"BNDOUT", 1000.0},
          std::pair{"NODOUT", 1000.0}, std::pair{"BINARY_D3PLOT", 20.0}})
      s += fmt::format("*DATABASE_{}\n$#      dt\n{}", name, reals({end / states}));
    return s + "$ A node of the moving grip.\n*DATABASE_HISTORY_NODE\n$#     id1\n" + ints({node});
  }

  std::string steel() {
    return "$ A steel to begin with, data of no sheet: yield stress 300 MPa, plastic modulus 1500 MPa (etan is over "
           "total strain).\n*MAT_PIECEWISE_LINEAR_PLASTICITY\n"
           "$#     mid        ro         e        pr      sigy      etan      fail      tdel\n" +
           fmt::format("{:10d}", ++next_) +
           reals({card_.units.steel_density, card_.units.steel_young, 0.3, 300.0 * megapascal(),
                  1489.36 * megapascal()}) +
           "$#       c         p      lcss      lcsr        vp\n       0.0       0.0\n$#    eps1\n\n$#     es1\n\n";
  }

  std::string section(double thickness) {
    return "*SECTION_SHELL\n$#   secid    elform      shrf       nip\n" +
           fmt::format("{:10d}{:10d}{:10.4f}{:10d}\n", ++next_, 2, 0.8333, 5) +
           "$#      t1        t2        t3        t4\n" + reals({thickness, thickness, thickness, thickness});
  }

  static std::string part(const char* title, int id, int section, int material) {
    return fmt::format("*PART\n{}\n$#     pid     secid       mid\n", title) + ints({id, section, material});
  }

  std::string sheets() {
    std::string s;
    int steel_id = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const CouponCard::Sheet& sheet = card_.sheets[k];
      section_[k] = sheet.section;
      if (section_[k] == 0 && k == 1 && card_.sheets[0].section == 0 && sheet.thickness == card_.sheets[0].thickness)
        section_[k] = section_[0];
      if (section_[k] == 0) {
        s += section(sheet.thickness);
        section_[k] = next_;
      }
      if (sheet.material == 0 && steel_id == 0) {
        s += steel();
        steel_id = next_;
      }
      s += part(k == 0 ? "lower sheet" : "upper sheet", k == 0 ? coupon_lower : coupon_upper, section_[k],
                sheet.material == 0 ? steel_id : sheet.material);
    }
    return s;
  }

  std::string weld() {
    if (card_.weld_nodes != 0)
      return "$ The weld of the card stands at this node.\n*SET_NODE_LIST\n$#     sid\n" + ints({card_.weld_nodes}) +
             "$#    nid1\n" + ints({first_weld_node});
    const bool of_bricks = !becomes_bricks_later(card_.form);
    return (of_bricks ? bricks() : beam()) + "*SET_PART_LIST\n$#     sid\n" + ints({90001}) + "$#    pid1      pid2\n" +
           ints({coupon_lower, coupon_upper}) + "*CONTACT_SPOTWELD_ID\n     90001weld to sheets\n" +
           "$#   surfa     surfb  surfatyp  surfbtyp\n" + ints({coupon_weld, 90001, 3, 2}) +
           "$#      fs\n\n$#    sfsa\n\n";
  }

  std::string bricks() {
    const int section = ++next_;
    return brick_cards(section, 90001) + "*PART\nspot weld\n$#     pid     secid       mid     eosid      hgid\n" +
           ints({coupon_weld, section, card_.weld_material, 0, 90001});
  }

  std::string beam() {
    std::string s;
    int section = card_.weld_section;
    if (section == 0) {
      section = ++next_;
      s += "*SECTION_BEAM\n$#   secid    elform      shrf        qr       cst\n" +
           fmt::format("{:10d}{:10d}{:10.1f}{:10d}{:10d}\n", section, 9, 1.0, 2, 1) +
           "$#     ts1       ts2       tt1       tt2\n" + reals({card_.diameter, card_.diameter, 0.0, 0.0});
    }
    const int bricks = named(card_.form).bricks;
    if (card_.form != WeldForm::beam)
      s += fmt::format(
               "$ The weld beam becomes {} brick{} of the same cross-section.\n*CONTROL_SPOTWELD_BEAM\n"
               "$#     lct       lcs     t_ort    prtflg     t_ors     rpbhx\n",
               bricks, bricks == 1 ? "" : "s") +
           ints({0, 0, 0, 0, 0, bricks});
    return s + part("spot weld", coupon_weld, section, card_.weld_material);
  }

  /// Codes of *MAT_RIGID: what is held of the translations of the moving grip. The machine guides it along the pull;
  /// pins leave KS-2 free across the pull in the plane of the load (docs/manual/coupon.md#the-coupons).
  int held_translations() const { return test_.kind == CouponKind::ks2 ? 1 : test_.pull() == 1 ? 5 : 4; }

  std::string rigid(const char* title, int pid, int section, int translations) {
    const int material = ++next_;
    return "*MAT_RIGID\n$#     mid        ro         e        pr\n" + fmt::format("{:10d}", material) +
           reals({card_.units.steel_density, card_.units.steel_young, 0.3}) + "$#     cmo      con1      con2\n" +
           fmt::format("{:10.1f}{:10d}{:10d}\n$#     lco\n\n", 1.0, translations, 7) +
           part(title, pid, section, material);
  }

  std::string grips() {
    const Pull pull = pull_of(test_);
    const double end = seconds(pull.duration());
    std::string s =
        "$ The grips are rigid and do not turn. con1: translations that are held, of 1 x, 2 y, 3 z, 4 xy, 5 "
        "yz, 7 all.\n";
    if (test_.kind == CouponKind::ks2)
      s += "$ The load is along z; pins leave the moving grip free along y, so that nothing else acts on the weld.\n";
    s += rigid("held grip", coupon_held_grip, section_[0], 7);
    s += rigid("moving grip", coupon_moving_grip, section_[1], held_translations());
    s += fmt::format("$ Curve 90001 is the velocity, {:.3g} m/s; it rises over the first fifth of the time.\n",
                     pull.speed);
    s += "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n$#     pid       dof       vad      lcid        sf\n" +
         columns({coupon_moving_grip, test_.pull(), 0, 90001}) + reals({pull.speed * card_.units.metre_per_second});
    s += "*DEFINE_CURVE\n$#    lcid\n" + ints({90001}) + "$#                a1                  o1\n";
    constexpr int pieces = 20;
    for (int i = 0; i <= pieces; ++i) {
      const double share = static_cast<double>(i) / pieces;
      s += fmt::format("{:20.10g}{:20.10g}\n", ramp * end * share, 0.5 - 0.5 * std::cos(std::numbers::pi * share));
    }
    return s + fmt::format("{:20.10g}{:20.10g}\n", 2.0 * end, 1.0);
  }

  const CouponCard& card_;
  CouponTest test_;
  int next_;
  std::array<int, 2> section_{};
};

}  // namespace

std::string CouponTest::name() const {
  switch (kind) {
    case CouponKind::lap_shear: return "lap_shear";
    case CouponKind::coach_peel: return "coach_peel";
    case CouponKind::cross_tension: return "cross_tension";
    case CouponKind::ks2: break;
  }
  return fmt::format("ks2_{:02.0f}", angle);
}

std::string CouponTest::title() const {
  switch (kind) {
    case CouponKind::lap_shear: return "lap shear";
    case CouponKind::coach_peel: return "coach peel";
    case CouponKind::cross_tension: return "cross tension";
    case CouponKind::ks2: break;
  }
  return fmt::format("KS-2, {:g} degrees", angle);
}

int CouponTest::pull() const {
  return kind == CouponKind::lap_shear ? 1 : 3;
}

std::vector<CouponTest> coupon_tests() {
  std::vector<CouponTest> tests{
      {CouponKind::lap_shear, 0.0}, {CouponKind::coach_peel, 90.0}, {CouponKind::cross_tension, 90.0}};
  for (const double angle : {0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 90.0}) tests.push_back({CouponKind::ks2, angle});
  return tests;
}

std::string write_coupon(const CouponCard& card, const CouponTest& test) {
  return CouponDeck(card, test).text();
}

}  // namespace nugget::weld
