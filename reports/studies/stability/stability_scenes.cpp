#include "reports/studies/stability/stability_scenes.hpp"

#include "cases/scene/initial_state.hpp"
#include "native/base/random.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <variant>

namespace crossgrain::studies {
namespace {

using scene::Scene;

/// Multiples of 6 and 2, so that middle and corner of the Brillouin zone's edge are there, and many
/// wave vectors between; the height is more than three diameters.
constexpr std::size_t packing_columns = 60, packing_rows = 4;
constexpr double compression = 1e-4;

bool has_prescribed_lid(const Scene& scene) {
    return std::holds_alternative<scene::PrescribedPlate>(scene.plates.lid);
}

/// Plates at rest that hold the pressure of the compressed lattice: two bonds of overlap o press a
/// grain of the lowest row down with sqrt(3) k o.
void add_plates(const Scene& model, double overlap, double row, Scene& packing) {
    const double reach =
        model.plates.touches == scene::PlateContact::surface ? model.grains.diameter / 2 : 0.0;
    const double indent =
        std::numbers::sqrt3 * model.contact.stiffness * overlap / model.plates.stiffness;
    packing.plates = model.plates;
    packing.plates.bottom = scene::PrescribedPlate{.height = indent - reach};
    packing.plates.lid = scene::PrescribedPlate{
        .height = row * static_cast<double>(packing_rows - 1) - indent + reach};
}

}  // namespace

scene::Scene packing_scene(const Scene& model, ContactState state) {
    const bool closed = state == ContactState::closed;
    const double d = model.grains.diameter;
    // Open: apart by more than the rounding of positions.
    const double spacing = closed ? d * (1 - compression) : d * (1 + 1e-12);
    const double row = spacing * std::numbers::sqrt3 / 2;
    const double speed = closed ? 1e-6 : 0.1;
    Scene packing;
    packing.name = model.name + (closed ? "/closed" : "/open");
    packing.grains = model.grains;
    packing.contact = model.contact;
    packing.periodic_x = spacing * static_cast<double>(packing_columns);
    packing.seed = 1;
    if (has_prescribed_lid(model)) {
        add_plates(model, closed ? d * compression : 0.0, row, packing);
    } else {
        packing.periodic_y = row * static_cast<double>(packing_rows);
    }
    for (std::size_t i = 0; i < packing_columns * packing_rows; ++i) {
        const std::size_t j = i / packing_columns;
        const double offset = j % 2 == 0 ? 0.25 : 0.75;
        packing.initial.x.push_back(spacing * (static_cast<double>(i % packing_columns) + offset));
        packing.initial.y.push_back(row * static_cast<double>(j));
        const auto [gx, gy] = normal_pair(packing.seed, RandomStream::initial_velocity, i);
        packing.initial.vx.push_back(speed * gx);
        packing.initial.vy.push_back(speed * gy);
    }
    return packing;
}

scene::ContactLaw with_restitution(const Scene& model, double restitution) {
    const double m = model.grains.mass;
    const double t_col = scene::contact_time(model);
    // Taguchi, below Eq. 1.
    const double rate = restitution == 1 ? 0.0 : -std::log(restitution) / t_col;
    const double omega = std::numbers::pi / t_col;
    scene::ContactLaw law = model.contact;
    law.damping = m * rate;
    law.stiffness = m * (omega * omega + rate * rate) / 2;
    return law;
}

analytic::ClosedPacking closed_packing(const Scene& packing) {
    const auto& law = packing.contact;
    const double reach =
        packing.plates.touches == scene::PlateContact::surface ? packing.grains.diameter / 2 : 0.0;
    analytic::ClosedPacking result{.x = packing.initial.x,
                                   .y = packing.initial.y,
                                   .period_x = packing.periodic_x,
                                   .period_y = packing.periodic_y,
                                   .diameter = packing.grains.diameter,
                                   .mass = packing.grains.mass,
                                   .stiffness = law.stiffness,
                                   .damping = law.damping,
                                   .damping_acts_on =
                                       law.damping_acts_on == scene::Damping::full_vector
                                           ? analytic::Damping::full_vector
                                           : analytic::Damping::normal_only,
                                   .plate_stiffness = packing.plates.stiffness};
    if (packing.plates.bottom) result.bottom = packing.plates.bottom->height + reach;
    if (const auto* lid = std::get_if<scene::PrescribedPlate>(&packing.plates.lid)) {
        result.lid = lid->height - reach;
    }
    return result;
}

bool can_be_narrowed(const Scene& model) {
    return model.plates.bottom.has_value() && model.periodic_x.has_value();
}

scene::Scene narrow_scene(const Scene& model) {
    constexpr std::size_t parts = 4;
    if (!can_be_narrowed(model)) throw std::invalid_argument("narrow_scene: not a bed");
    Scene narrow = model;
    narrow.periodic_x = *model.periodic_x / static_cast<double>(parts);
    const std::size_t count = model.grain_count() / parts;
    if (auto* lid = std::get_if<scene::FreeLid>(&narrow.plates.lid)) {
        lid->mass /= static_cast<double>(parts);
    }
    if (has_prescribed_lid(model)) {
        scene::generate_initial_state(narrow,
                                      scene::Packing{.count = count, .velocity_spread = 0.1});
    } else {
        const auto columns =
            static_cast<std::size_t>(*narrow.periodic_x / model.grains.diameter) - 1;
        scene::generate_initial_state(narrow, scene::Lattice{.count = count,
                                                             .columns = columns,
                                                             .velocity_spread = 0.1,
                                                             .lid_gap = 0.5});
    }
    return narrow;
}

}  // namespace crossgrain::studies
