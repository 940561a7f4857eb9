// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/parts.hpp"

namespace nugget::model {

/// *DAMPING_STRUCTURAL: stiffness K (1 + i g).
struct StructuralDamping {
  double factor = 0.0;   ///< g, the loss factor, where there is no curve
  Index curve = none;    ///< g over the frequency of the excitation [cycles/time] or number of the mode
  bool by_mode = false;  ///< the curve is over the number of the mode
  bool given() const { return factor > 0.0 || curve != none; }
};

/// At which frequencies a response is wanted [cycles/time].
struct Frequencies {
  std::vector<double> frequency;  ///< ascending; where `near_modes` is given only the ends of the range
  /// FSPACE 2, 3: known only when the modes are. So many in all, which gather at the natural ones within the range; 0:
  /// these alone.
  std::optional<int> near_modes;
};

/// *FREQUENCY_DOMAIN_FRF: steady response to one harmonic excitation of unit amplitude, over frequency; of _SUBCASE to
/// several, one at a time.
struct FrequencyResponse : Frequencies {
  enum class Quantity { velocity, acceleration, displacement, force };

  struct Excitation {
    enum class Kind {
      force,     ///< on each of `nodes`
      torque,    ///< on each of `nodes`, about `direction`
      pressure,  ///< on `pressed`
      base,      ///< all supports move together
      enforced   ///< `nodes` move, the supports stand still
    } kind = Kind::force;
    Quantity quantity = Quantity::velocity;  ///< of the base or of the enforced nodes, which has amplitude 1
    std::vector<Index> nodes;
    Vec3d direction;                  ///< unit vector
    bool turning = false;             ///< of the base: it turns about `direction`, by angles; not for enforced nodes
    Vec3d axis;                       ///< a point of the axis about which it turns
    std::vector<Segment> pressed;     ///< each carries a pressure of amplitude 1, against its normal
    std::vector<CornerShares> share;  ///< of their forces; see share_pressure
    Place place;                      ///< of the card
    bool moves() const { return kind == Kind::base || kind == Kind::enforced; }
  };

  struct Response {
    std::vector<Index> nodes;
    std::vector<Vec3d> directions;  ///< unit vectors
    bool rotation = false;          ///< rotations about them (moments, where the quantity is a force)
    Quantity quantity = Quantity::displacement;
    bool relative = false;  ///< to the base
    Place place;            ///< of the card
  };

  struct Case {
    std::string title;
    Excitation excitation;
    Response response;
  };
  std::vector<Case> cases;  ///< one, but for _SUBCASE

  /// Which of the modes take part, from the lowest on.
  struct Selection {
    double highest = 0.0;     ///< FNMAX: none above this natural frequency [cycles/time]; 0: no such end
    int first = 1, last = 0;  ///< MDMIN, MDMAX; last 0: no such end
    double lowest = 0.0;      ///< FNMIN: none below this natural frequency
  } modes;

  /// Mode r has 2 zeta omega_r + mass + stiffness omega_r^2 in place of c / m.
  struct Damping {
    double ratio = 0.0;      ///< zeta of all modes, where there is no curve
    Index curve = none;      ///< zeta over natural frequency [cycles/time] or number of mode; end values hold outside
    bool by_mode = false;    ///< the curve is over the number of the mode
    double mass = 0.0;       ///< alpha of Rayleigh's damping [1/time]
    double stiffness = 0.0;  ///< beta [time]
    bool of_parts = false;   ///< DMPFLG 1: dashpots and *DAMPING_PART_... instead of all of the above
  } damping;

  bool direct = false;    ///< no modes, one solution for each frequency
  bool by_parts = false;  ///< OUTPUT 1: LS-DYNA's files hold real and imaginary part
};

/// *FREQUENCY_DOMAIN_SSD: steady response to harmonic loads together, each with its amplitude and phase over frequency;
/// of _SUBCASE to several such groups, one at a time. `frequency`: of *DATABASE_FREQUENCY_ASCII_NODOUT_SSD.
struct SteadyState : Frequencies {
  struct Load {
    FrequencyResponse::Excitation excitation;
    double scale = 1.0;
    Index first = none, second = none;  ///< curves over frequency: amplitude and phase [degree], or real and imaginary
  };
  struct Case {
    std::string id, title;  ///< of _SUBCASE
    std::vector<Load> loads;
  };
  std::vector<Case> cases;  ///< one, but for _SUBCASE
  bool by_parts = false;    ///< the curves are real and imaginary part
  bool direct = false;      ///< _DIRECT: no modes, one solution for each frequency
  bool relative = false;    ///< responses to the base's motion are relative to it
  FrequencyResponse::Selection modes;
  FrequencyResponse::Damping damping;

  /// *DATABASE_FREQUENCY_BINARY_D3SSD: the motion of all nodes.
  struct States : Frequencies {
    enum class Part { amplitude, real, imaginary } part = Part::amplitude;
  };
  std::optional<States> states;

  /// _ERP: power that panels would radiate if each point of them did so as part of a large flat piston. `frequency`: of
  /// *DATABASE_FREQUENCY_BINARY_D3ERP; none: that of the other requests.
  struct RadiatedPower : Frequencies {
    double density = 0.0, sound_speed = 0.0;  ///< of the fluid
    double loss_factor = 1.0;                 ///< share of that power that is radiated, where there is no curve
    Index loss_curve = none;                  ///< the same over frequency; end values hold outside
    double reference = 0.0;                   ///< power of 0 decibels; 0: none is given
    struct Panel {
      std::string name;  ///< kind and number of what the deck names
      std::vector<Segment> segments;
    };
    std::vector<Panel> panels;
  };
  std::optional<RadiatedPower> radiated_power;

  /// Of all outputs. Where the radiated power has none of its own, it stands at those of nodout_ssd, or else of d3ssd.
  const Frequencies& frequencies_of_power() const {
    if (!radiated_power->frequency.empty()) return *radiated_power;
    return frequency.empty() && states ? static_cast<const Frequencies&>(*states) : *this;
  }
};

}  // namespace nugget::model
