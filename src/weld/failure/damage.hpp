// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/archive.hpp"
#include "model/model.hpp"
#include "weld/tie/ties.hpp"

namespace nugget::weld {

/// How a weld as a whole loses its force after its failure function has reached 1 (DMGOPT 10 to 12 of _DAMAGE-FAILURE,
/// DGTYP of _DA; see docs/theory/failure.md#damage-of-the-whole-weld and docs/theory/failure.md#connections). One
/// damage w for all elements and points of the weld.
struct DamageLaw {
  enum class Growth {
    immediate,  ///< it fails
    strain,     ///< w over the plastic strain since the onset, 1 at RS
    time,       ///< w = time since the onset / RS
    surface,    ///< the load is kept on the failure surface
    energy,     ///< the load fades linearly over the displacement since the onset and does the work GFAD on the way
  };
  Growth growth = Growth::immediate;
  double rupture = 0.0;        ///< RS: plastic strain [1]; `time`: time after the onset
  double beta = 0.0;           ///< BETA [1]: exp(-beta w) of the force is left; 0: 1 - w
  double onset_strain = 0.0;   ///< EFAIL: mean plastic strain that begins the damage too [1]; 0: it does not
  double fading_energy = 0.0;  ///< GFAD [energy]
  bool freezes_yield = false;  ///< no stress grows after the onset (DMGOPT 11, 12)
  double mode = 0.0;  ///< FMODE: sqrt of the share of shear and torsion from which on it fails at once; 0: never
  double cap = 0.0;   ///< FFCAP: failure value at which the damaged weld fails; 0: none
};

/// Of a weld as it was tied.
DamageLaw damage_law(const model::Model& model, const Weld& weld);
/// Of MAT_100 with DMGOPT 10 to 12; for other options growth is `immediate`.
DamageLaw damage_law(const model::WeldDamage& damage);
/// Of MAT_100_DA.
DamageLaw damage_law(const model::ConnectionProperties& properties, const model::ConnectionProperties::Record& record,
                     const model::WeldDamage& damage);

/// The damage of one weld.
class Damage {
 public:
  explicit Damage(const DamageLaw& law) : law_(law) {}

  /// The weld as it is in a cycle.
  struct WeldState {
    double time = 0.0;
    double plastic_strain = 0.0;  ///< mean over its points
    double energy = 0.0;          ///< work done on its elements so far
    bool at_surface = false;      ///< the failure function says that it fails
    double value = 0.0;           ///< failure function of the load that it carries
    double sliding = 0.0;         ///< share of shear force and torsion in `value`
    double load = 0.0;            ///< the load that it would carry undamaged, over that on the failure surface
  };
  enum class State { intact, damaged, failed };
  State update(const WeldState& now);

  /// What is left of the force of the undamaged weld.
  double integrity() const;
  double damage() const { return damage_; }  ///< w, 0 to 1
  bool begun() const { return begun_; }
  const WeldState& onset() const { return onset_; }
  const DamageLaw& law() const { return law_; }

  void archive(Archive& a);

 private:
  bool begins(const WeldState& now) const;
  double grown(const WeldState& now);

  DamageLaw law_;
  bool begun_ = false;
  WeldState onset_;
  double damage_ = 0.0, work_ = 0.0;
};

}  // namespace nugget::weld
