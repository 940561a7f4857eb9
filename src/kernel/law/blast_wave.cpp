// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/blast_wave.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace nugget::kernel {
namespace {

/// log10 of a quantity as a polynomial of U = a + b log10 Z, up to a scaled distance Z.
struct Fit {
  double until = 0.0, a = 0.0, b = 0.0;
  std::array<double, 12> coefficient{};
};
/// The pieces of a quantity, of which the last one that is there counts beyond its end.
struct Quantity {
  std::array<Fit, 3> piece{};

  double at(double z) const {
    std::size_t i = 0;
    while (i + 1 < piece.size() && z > piece[i].until && piece[i + 1].until > 0.0) ++i;
    const Fit& fit = piece[i];
    const double u = fit.a + fit.b * std::log10(z);
    double sum = 0.0;
    for (std::size_t k = fit.coefficient.size(); k-- > 0;) sum = sum * u + fit.coefficient[k];
    return std::pow(10.0, sum);
  }
};
/// Times and impulses over the cube root of the mass [ms/kg^(1/3), kPa ms/kg^(1/3)], pressures [kPa].
struct Fits {
  Quantity arrival, duration, incident, reflected, incident_impulse, reflected_impulse;
};

constexpr Fits of_sphere{
    // arrival
    {{{{40,
        -0.253273111999,
        1.37407043777,
        {0.0720707787637, 1.36456871214, -0.0570035692784, -0.182832224796, 0.0118851436014, 0.0432648687627,
         -0.0007997367834, -0.00436073555033}}}}},
    // duration
    {{{{0.888,
        2.26367268496,
        5.11588554305,
        {-0.686608550419, 0.164953518069, 0.127788499497, 0.00291430135946, 0.00187957449227, 0.0173413962543,
         0.00269739758043, -0.00361976502798, -0.00100926577934}},
       {2.28,
        -1.33361206714,
        9.2996288611,
        {0.23031841078, -0.0297944268969, 0.0306329542941, 0.0183405574074, -0.0173964666286, -0.00106321963576,
         0.0056206003128, 0.0001618217499, -0.0006860188944}},
       {40,
        -3.13005805346,
        3.1524725364,
        {0.621036276475, 0.0967031995552, -0.00801302059667, 0.00482705779732, 0.00187587272287, -0.00246738509321,
         -0.000841116668, 0.0006193291052}}}}},
    // incident pressure
    {{{{40,
        -0.214362789151,
        1.35034249993,
        {2.611368669, -1.69012801396, 0.00804973591951, 0.336743114941, -0.00516226351334, -0.0809228619888,
         -0.00478507266747, 0.00793030472242, 0.0007684469735}}}}},
    // reflected pressure
    {{{{40,
        -0.214362789151,
        1.35034249993,
        {3.22958031387, -2.21400538997, 0.035119031446, 0.657599992109, 0.0141818951887, -0.243076636231,
         -0.0158699803158, 0.0492741184234, 0.00227639644004, -0.00397126276058}}}}},
    // incident impulse
    {{{{0.792,
        2.34723921354,
        3.24299066475,
        {2.38830516757, -0.443749377691, 0.168825414684, 0.0348138030308, -0.010435192824}},
       {40,
        -1.75305660315,
        2.30629231803,
        {1.55197227115, -0.40463292088, -0.0142721946082, 0.00912366316617, -0.0006750681404, -0.00800863718901,
         0.00314819515931, 0.00152044783382, -0.0007470265899}}}}},
    // reflected impulse
    {{{{40, -0.204004553231, 1.37882996018, {2.55875660396, -0.903118886091, 0.101771877942, -0.0242139751146}}}}},
};
constexpr Fits of_half_sphere{
    // arrival
    {{{{40,
        -0.202425716178,
        1.37784223635,
        {-0.0591634288046, 1.35706496258, 0.052492798645, -0.196563954086, -0.0601770052288, 0.0696360270891,
         0.0215297490092, -0.0161658930785, -0.00232531970294, 0.00147752067524}}}}},
    // duration
    {{{{1.01,
        1.92946154068,
        5.25099193925,
        {-0.614227603559, 0.130143717675, 0.134872511954, 0.0391574276906, -0.00475933664702, -0.00428144598008}},
       {2.78,
        -2.12492525216,
        9.2996288611,
        {0.315409245784, -0.0297944268976, 0.030632954288, 0.0183405574086, -0.0173964666211, -0.00106321963633,
         0.00562060030977, 0.0001618217499, -0.0006860188944}},
       {40,
        -3.53626218091,
        3.46349745571,
        {0.686906642409, 0.0933035304009, -0.0005849420883, -0.00226884995013, -0.00295908591505, 0.00148029868929}}}}},
    // incident pressure
    {{{{40,
        -0.214362789151,
        1.35034249993,
        {2.78076916577, -1.6958988741, -0.154159376846, 0.514060730593, 0.0988534365274, -0.293912623038,
         -0.0268112345019, 0.109097496421, 0.00162846756311, -0.0214631030242, 0.0001456723382, 0.00167847752266}}}}},
    // reflected pressure
    {{{{40,
        -0.240657322658,
        1.36637719229,
        {3.40283217581, -2.21030870597, -0.218536586295, 0.895319589372, 0.24989009775, -0.569249436807, -0.11791682383,
         0.224131161411, 0.0245620259375, -0.0455116002694, -0.0019093073888, 0.00361471193389}}}}},
    // incident impulse
    {{{{0.955,
        2.06761908721,
        3.0760329666,
        {2.52455620925, -0.502992763686, 0.171335645235, 0.0450176963051, -0.0118964626402}},
       {40,
        -1.94708846747,
        2.40697745406,
        {1.67281645863, -0.384519026965, -0.0260816706301, 0.00595798753822, 0.014544526107, -0.00663289334734,
         -0.00284189327204, 0.0013644816227}}}}},
    // reflected impulse
    {{{{40, -0.246208804814, 1.33422049854, {2.70588058103, -0.949516092853, 0.112136118689, -0.0250659183287}}}}},
};

/// b of Friedlander's curve whose area is `share` of peak times duration: (b - 1 + exp(-b)) / b^2 = share.
double decay(double share) {
  const auto area = [](double b) {
    return std::abs(b) < 1e-4 ? 0.5 - b / 6.0 + b * b / 24.0 : (b - 1.0 + std::exp(-b)) / (b * b);
  };
  double low = -50.0, high = 1.0;
  while (area(high) > share) high *= 2.0;
  for (double middle = 0.5 * (low + high); middle > low && middle < high; middle = 0.5 * (low + high))
    (area(middle) > share ? low : high) = middle;
  return 0.5 * (low + high);
}

}  // namespace

double least_scaled_distance(Burst burst) {
  return burst == Burst::sphere ? 0.147 : 0.178;
}

BlastWave blast_wave(Burst burst, double mass, double distance) {
  const Fits& fits = burst == Burst::sphere ? of_sphere : of_half_sphere;
  const double root = std::cbrt(mass), z = distance / root;
  BlastWave wave;
  wave.arrival = root * fits.arrival.at(z);
  wave.duration = root * fits.duration.at(z);
  wave.incident = fits.incident.at(z);
  wave.reflected = fits.reflected.at(z);
  wave.incident_impulse = root * fits.incident_impulse.at(z);
  wave.reflected_impulse = root * fits.reflected_impulse.at(z);
  wave.incident_decay = decay(wave.incident_impulse / (wave.incident * wave.duration));
  wave.reflected_decay = decay(wave.reflected_impulse / (wave.reflected * wave.duration));
  return wave;
}

double BlastWave::pressure(double time, double cosine, bool negative_phase) const {
  const double t = (time - arrival) / duration;
  if (t < 0.0 || (t > 1.0 && !negative_phase)) return 0.0;
  const double passing = incident * (1.0 - t) * std::exp(-incident_decay * t);
  if (cosine <= 0.0) return passing;
  const double thrown_back = reflected * (1.0 - t) * std::exp(-reflected_decay * t), square = cosine * cosine;
  return thrown_back * square + passing * (1.0 + square - 2.0 * cosine);
}

}  // namespace nugget::kernel
