// Coefficient of restitution and duration of the bounce of isolated grains on an elastic plate,
// from the free flights before and after the contact.
//
// With the gap g = (y - reach) - y_plate above the bottom, g = y_lid - (y + reach) below the lid,
// reach = 0 for plates that touch centres and d/2 for plates that touch surfaces, both free flights
// are extrapolated to g = 0 (reduced units):
//   restitution    e   = -g'_out / g'_in         (1 for the elastic plates of a scene)
//   contact time   t_c = t_out - t_in            (pi sqrt(mu/k); mu = m for a plate at rest,
//                                                 mu = m M/(m + M) for a free lid)
//   momentum error (m v + M V)_out - (m v + M V)_in, divided by mu |g'_in|  (free lid only)
//
// Hypotheses: no gravity, every grain meets one plate once and nothing else, the first frame is
// before and the last frame after the contact. A grain meets the plate it approaches faster. Plates
// are at rest or free; a free lid can meet one grain only, else its flight is not free.
#pragma once

#include "cases/measure/estimator.hpp"

#include <optional>
#include <vector>

namespace crossgrain::measure {

/// Measurements: `plate_restitution` (1), `plate_contact_time` (t): means over the grains with
/// standard error (0 for one grain), n is the number of grains; `plate_momentum_error` (1) for a
/// free lid; `complete_bounces`: number of grains that came, touched and left, n is the number of
/// grains. If any grain is not complete only `complete_bounces` is reported. Nothing for scenes
/// with gravity, frozen grains, a moving plate, or without plates.
class PlateBounce final : public Estimator {
  public:
    explicit PlateBounce(const scene::Scene& scene);
    void add(const scene::Frame& frame) override;
    void finish(Results& results) override;

  private:
    enum class Plate { bottom, lid };
    struct Flight {
        double time = 0;
        double gap = 0, gap_rate = 0;
        double momentum = 0;  ///< of grain and free lid
    };
    struct Bounce {
        double restitution = 0;
        double contact_time = 0;
        double momentum_error = 0;
    };
    struct GrainFlights {
        Flight bottom, lid;
    };

    [[nodiscard]] std::vector<GrainFlights> flights(const scene::Frame& frame) const;
    [[nodiscard]] static Plate target(const GrainFlights& first);
    [[nodiscard]] static std::optional<Bounce> bounce(const Flight& in, const Flight& out,
                                                      double reduced_mass);

    bool applicable_ = false;
    scene::Plates plates_;
    double reach_ = 0;
    double mass_ = 0;
    double lid_mass_ = 0;                     ///< 0 without a free lid
    std::vector<GrainFlights> first_, last_;  ///< shape (grains)
};

}  // namespace crossgrain::measure
