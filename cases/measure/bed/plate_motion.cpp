#include "cases/measure/bed/plate_motion.hpp"

#include <cmath>
#include <numbers>

namespace crossgrain::measure {

PlateState plate_state(const scene::PrescribedPlate& plate, double t) {
    const double omega = 2.0 * std::numbers::pi / plate.period;
    const double angle = omega * t + scene::phase_angle(plate);
    return {scene::height_at(plate, t), -plate.amplitude * omega * std::sin(angle)};
}

std::optional<PlateState> bottom_state(const scene::Plates& plates, double t) {
    if (!plates.bottom) return std::nullopt;
    return plate_state(*plates.bottom, t);
}

std::optional<PlateState> lid_state(const scene::Plates& plates, const scene::Frame& frame) {
    if (const auto* plate = std::get_if<scene::PrescribedPlate>(&plates.lid)) {
        return plate_state(*plate, frame.time);
    }
    if (std::holds_alternative<scene::FreeLid>(plates.lid)) return frame.lid;
    return std::nullopt;
}

std::optional<double> driving_period(const scene::Plates& plates) {
    if (plates.bottom && plates.bottom->amplitude > 0) return plates.bottom->period;
    const auto* lid = std::get_if<scene::PrescribedPlate>(&plates.lid);
    if (lid && lid->amplitude > 0) return lid->period;
    return std::nullopt;
}

}  // namespace crossgrain::measure
