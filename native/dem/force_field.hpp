// The accelerations of all degrees of freedom: contacts of grains, plates, gravity, and the free
// lid (Taguchi, Eqs. 1 and 2). The order of summation is part of the contract: certificates to the
// last digits rest on it.
#pragma once

#include "native/dem/contact_law.hpp"
#include "native/dem/lattice_neighbours.hpp"
#include "native/dem/motion.hpp"
#include "native/dem/neighbour_list.hpp"
#include "native/dem/plates.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace crossgrain::dem {

/// Half a diameter: the second shell of a dense packing stays out, rebuilds stay rare.
constexpr double scalar_skin_in_diameters = 0.5;

class ForceField {
  public:
    ForceField(const Parameters& p, const State& s)
        : p_(p), frozen_(s.frozen),
          skin_(p.skin > 0 ? p.skin : scalar_skin_in_diameters * p.diameter),
          near_(p.diameter, skin_, p.period_x, p.period_y) {
        if (p.contacts == Contacts::lattice_neighbours) lattice_.emplace(p, s.x, s.y);
    }

    /// a(q, v, t), see Motion. Throws TrajectoryError if a position is not finite.
    template <class PairLaw>
    void accelerations(const PairLaw& law, const std::vector<double>& q,
                       const std::vector<double>& v, double t, std::vector<double>& a) {
        std::fill(a.begin(), a.end(), 0.0);
        add_pair_forces(law, x_part(q), y_part(q), x_part(v), y_part(v), x_part(a), y_part(a));
        add_plate_forces(q, t, a);
        divide_by_mass(a);
        ++evaluations_;
    }

    /// To be called at the end of every step.
    void look_for_missed_contacts(const std::vector<double>& q, double t) {
        if (lattice_) lattice_->watch(x_part(q), y_part(q), t);
    }

    [[nodiscard]] const Parameters& parameters() const noexcept { return p_; }
    [[nodiscard]] MissedContacts missed_contacts() const {
        return lattice_ ? lattice_->missed() : MissedContacts{};
    }
    [[nodiscard]] std::int64_t evaluations() const noexcept { return evaluations_; }
    [[nodiscard]] std::int64_t neighbour_builds() const noexcept { return near_.builds(); }
    [[nodiscard]] double skin() const noexcept { return skin_; }

  private:
    template <class PairLaw>
    void add_pair_forces(const PairLaw& law, std::span<const double> x, std::span<const double> y,
                         std::span<const double> vx, std::span<const double> vy,
                         std::span<double> fx, std::span<double> fy) {
        if (!lattice_) near_.update(x, y);
        const double d = p_.diameter;
        for (const Pair& pair : lattice_ ? lattice_->pairs() : near_.pairs()) {
            const std::size_t i = pair.i;
            const std::size_t j = pair.j;
            const double dx = x[i] - x[j] + pair.shift_x;
            const double dy = y[i] - y[j] + pair.shift_y;
            const double r_squared = dx * dx + dy * dy;
            if (r_squared >= d * d) continue;
            const double r = std::sqrt(r_squared);
            const Force f = law(d - r, dx / r, dy / r, vx[i] - vx[j], vy[i] - vy[j]);
            fx[i] += f.x;
            fy[i] += f.y;
            fx[j] -= f.x;
            fy[j] -= f.y;
        }
    }

    void add_plate_forces(const std::vector<double>& q, double t, std::vector<double>& f) const {
        const auto y = y_part(q);
        const auto fy = y_part(f);
        if (p_.bottom) {
            push_from_bottom(p_.bottom->position(t), p_.plate_stiffness, p_.plate_reach, y, fy);
        }
        if (const auto* plate = std::get_if<MovingPlate>(&p_.lid)) {
            push_from_lid(plate->position(t), p_.plate_stiffness, p_.plate_reach, y, fy);
        } else if (std::holds_alternative<InertialLid>(p_.lid)) {
            f.back() = push_from_lid(q.back(), p_.plate_stiffness, p_.plate_reach, y, fy);
        }
    }

    void divide_by_mass(std::vector<double>& a) const {
        const auto ax = x_part(a);
        const auto ay = y_part(a);
        for (std::size_t i = 0; i < ax.size(); ++i) {
            ax[i] /= p_.mass;
            ay[i] = ay[i] / p_.mass - p_.gravity;
        }
        for (const std::size_t i : frozen_)
            ax[i] = ay[i] = 0;
        const auto* lid = std::get_if<InertialLid>(&p_.lid);
        a.back() = lid ? a.back() / lid->mass - p_.gravity : 0;
    }

    Parameters p_;
    std::vector<std::size_t> frozen_;
    double skin_;
    NeighbourList near_;
    std::optional<LatticeNeighbours> lattice_;
    std::int64_t evaluations_ = 0;
};

/// The force field with its law resolved: what the schemes integrate.
template <class PairLaw>
class LawfulSystem {
  public:
    LawfulSystem(ForceField& field, const PairLaw& law) : field_(field), law_(law) {}
    void accelerations(const std::vector<double>& q, const std::vector<double>& v, double t,
                       std::vector<double>& a) {
        field_.accelerations(law_, q, v, t, a);
    }
    [[nodiscard]] double diameter() const noexcept { return field_.parameters().diameter; }
    /// (1/t): no mode of the dashpots decays faster; a grain has six contacts at most.
    [[nodiscard]] double largest_dashpot_rate() const noexcept {
        return 12 * field_.parameters().damping / field_.parameters().mass;
    }

  private:
    ForceField& field_;
    const PairLaw& law_;
};

}  // namespace crossgrain::dem
