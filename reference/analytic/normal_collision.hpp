// Head-on collision of two bodies with a linear spring-dashpot contact, in closed form.
//
// With the overlap delta and reduced mass mu = m1 m2/(m1 + m2) (m1 if m2 is infinite), while the
// contact force acts (reduced units),
//   mu delta'' + eta delta' + k delta = 0,   delta(0) = 0, delta'(0) = v > 0,
// i.e. a damped oscillator, gamma = eta/(2 mu), omega0^2 = k/mu, omega^2 = omega0^2 - gamma^2:
//   delta(t) = (v/omega) exp(-gamma t) sin(omega t).
//
// Attraction kept: contact ends at delta = 0, so t_c = pi/omega and delta'(t_c) = -e v gives
//   e = exp(-gamma t_c).
// (Taguchi, chao-dyn/9405003 (1994), below Eq. 1, where mu = 1/2.) A contact that is not
// underdamped never returns to delta = 0: the bodies stay together.
//
// Attraction cut: the force k delta + eta delta' = -mu delta'' vanishes for good at the first zero
// of delta'', tan(omega t_f) = 2 gamma omega/(gamma^2 - omega^2) with 0 < omega t_f < pi, that is
//   omega t_f = atan2(2 gamma omega, gamma^2 - omega^2) = 2 atan(omega/gamma);
// there sin(omega t_f) = 2 gamma omega/omega0^2 and cos(omega t_f) = (gamma^2 - omega^2)/omega0^2,
// so that delta'(t_f) = -v exp(-gamma t_f), and
//   e = exp(-gamma t_f)                            (Schwager & Poeschel, Granular Matter 9, 465
//                                                   (2007), who call it the cut collision).
// The bodies still overlap by delta = -(eta/k) delta'(t_f) and part freely, which takes eta/k:
//   t_c = t_f + eta/k.
// Critical damping (omega -> 0): t_f = 2/gamma, e = exp(-2). Overdamped, with beta^2 = gamma^2 -
// omega0^2: t_f = 2 atanh(beta/gamma)/beta. All are one continuous function.
#pragma once

namespace crossgrain::analytic {

/// What becomes of the contact force once it would be attractive.
enum class Attraction { kept, cut };

struct NormalContact {
    double stiffness = 0;     ///< k (m/t^2), > 0
    double damping = 0;       ///< eta (m/t), >= 0, on the relative velocity
    double reduced_mass = 0;  ///< mu (m), > 0
};

struct NormalCollision {
    double restitution = 0;   ///< e, in (0, 1]
    double force_time = 0;    ///< t_f (t), from touch to the end of the force
    double contact_time = 0;  ///< t_c (t), from touch to r = d; equals t_f unless cut
};

/// Reduced mass of two bodies; either may be infinite (a frozen grain, a plate).
/// Throws std::domain_error unless both are > 0 and at least one is finite.
[[nodiscard]] double reduced_mass(double m1, double m2);

/// Throws std::domain_error for parameters out of range, and for Attraction::kept if the contact is
/// critically damped or overdamped (eta^2 >= 4 k mu).
[[nodiscard]] NormalCollision normal_collision(const NormalContact& contact, Attraction attraction);

/// The contact that gives restitution e in (0, 1] and contact time t_c > 0 with the attraction
/// kept: gamma = -ln(e)/t_c, k = mu ((pi/t_c)^2 + gamma^2), eta = 2 mu gamma.
/// Throws std::domain_error for arguments out of range.
[[nodiscard]] NormalContact contact_from(double restitution, double contact_time,
                                         double reduced_mass);

}  // namespace crossgrain::analytic
