#include "adapters/lammps/lammps_script.hpp"

#include "adapters/lammps_family/family_script.hpp"
#include "adapters/program/own_conventions.hpp"

#include <fmt/format.h>

#include <variant>

namespace crossgrain::adapters {

namespace {

using lammps_family::disc_inertia;

bool is_per_mass(const scene::ContactLaw& law) {
    return law.damping_scale == scene::DampingScale::effective_mass;
}

const char* damping_model(const scene::ContactLaw& law) {
    return is_per_mass(law) ? "mass_velocity" : "velocity";
}

class Script : public lammps_family::FamilyScript {
  public:
    explicit Script(const scene::Scene& scene)
        : FamilyScript(scene),
          // How far behind the plate the wall stands, see add_wall.
          wall_offset_(2 * scene.grains.diameter) {}

    void add_contacts();
    void add_plates();
    void add_backing();
    void add_run();

  private:
    void add_frictionless();
    void add_granular_friction();
    void add_gran_hooke();
    [[nodiscard]] std::string position(const std::string& name, const scene::PrescribedPlate& plate,
                                       double offset);
    void add_wall(const std::string& name, const char* face, const std::string& coordinate);
    void add_free_lid();

    double wall_offset_;
};

void Script::add_contacts() {
    switch (pair_style(scene().contact)) {
    case PairStyle::granular:
        scene().has_friction() ? add_granular_friction() : add_frictionless();
        break;
    case PairStyle::gran_hooke:
        add_gran_hooke();
        break;
    }
    add_exclusions();
    // Only a grain that fix freeze holds counts as infinitely heavy in an effective mass.
    if (is_per_mass(scene().contact) && types().frozen > 0) {
        line("group frozen type {}", types().frozen);
        line("fix hold frozen freeze");
    }
}

/// Behind what contacts are told: the whole contact force never attracts.
const char* limit_damping(const scene::ContactLaw& law) {
    return law.clipping == scene::Clipping::none ? "" : " limit_damping";
}

void Script::add_frictionless() {
    const auto& law = scene().contact;
    const bool full = law.damping_acts_on == scene::Damping::full_vector;
    // `granular` takes the dashpot as it is and the tangential one as a multiple of it. Its Coulomb
    // limit is lifted out of the way: that of gran/hooke must stay finite and bites near F_n = 0.
    line("pair_style granular");
    line("pair_coeff * * hooke {:.17g} {:.17g} damping {} tangential linear_nohistory {} 1e30{}",
         law.stiffness, law.damping, damping_model(law), full ? 1 : 0, limit_damping(law));
}

void Script::add_granular_friction() {
    const auto& law = scene().contact;
    const auto& friction = *law.friction;
    // The tangential dashpot is given as a multiple of the normal one.
    const double ratio = friction.damping > 0 ? friction.damping / law.damping : 0;
    const std::string tangential =
        friction.force == scene::TangentialForce::spring
            ? fmt::format("linear_history {:.17g} {:.17g}", friction.stiffness, ratio)
            : fmt::format("linear_nohistory {:.17g}", ratio);
    line("pair_style granular");
    line("pair_coeff * * hooke {:.17g} {:.17g} damping {} tangential {} {:.17g}{}", law.stiffness,
         law.damping, damping_model(law), tangential, friction.coefficient, limit_damping(law));
}

/// Dashpots of gran/hooke are per unit of the effective mass, which is m/2 for every pair of grains
/// that are alike, frozen or not.
void Script::add_gran_hooke() {
    const auto& law = scene().contact;
    const auto& friction = *law.friction;
    const double scale = is_per_mass(law) ? 1.0 : 2.0 / scene().grains.mass;
    const bool spring = friction.force == scene::TangentialForce::spring;
    line("pair_style {} {:.17g} {} {:.17g} {:.17g} {:.17g} {}{}",
         spring ? "gran/hooke/history" : "gran/hooke", law.stiffness,
         spring ? fmt::format("{:.17g}", friction.stiffness) : "NULL", law.damping * scale,
         friction.damping * scale, friction.coefficient, friction.damping > 0 ? 1 : 0,
         limit_damping(law));
    line("pair_coeff * *");
}

/// Coordinate of a wall at `offset` from a prescribed plate, as an argument of fix wall.
std::string Script::position(const std::string& name, const scene::PrescribedPlate& plate,
                             double offset) {
    std::string height = height_formula(plate, offset);
    if (plate.amplitude == 0) return height;
    line("variable {} equal {}", name, height);
    return "v_" + name;
}

/// An elastic plate. A wall of LAMMPS pushes a grain's centre away, with stiffness 2 epsilon, as
/// long as it is nearer than the cutoff, and stops the run when the centre gets behind the wall. So
/// the wall stands behind the plate and reaches just to the plate (or a radius further, when the
/// plate touches the surface).
void Script::add_wall(const std::string& name, const char* face, const std::string& coordinate) {
    const bool surface = scene().plates.touches == scene::PlateContact::surface;
    const double reach = surface ? scene().grains.diameter / 2 : 0.0;
    line("fix {} grains wall/harmonic {} {} {:.17g} 1 {:.17g}", name, face, coordinate,
         scene().plates.stiffness / 2, wall_offset_ + reach);
}

void Script::add_free_lid() {
    const std::size_t id = scene().grain_count() + 1;
    line("variable lid equal y[{}]+{:.17g}", id, wall_offset_);
    add_wall("lid", "yhi", "v_lid");
    // What the wall pushes it gets back, in the same step: this fix must follow the wall's.
    line("variable push equal f_lid[1]");
    line("fix push lid addforce 0 v_push 0");
}

void Script::add_plates() {
    const auto& plates = scene().plates;
    if (plates.bottom) {
        add_wall("bottom", "ylo", position("bottom", *plates.bottom, -wall_offset_));
    }
    if (const auto* prescribed = std::get_if<scene::PrescribedPlate>(&plates.lid)) {
        add_wall("lid", "yhi", position("lid", *prescribed, wall_offset_));
    } else if (scene().has_free_lid()) {
        add_free_lid();
    }
}

/// Planes across x, made like plates that touch centres.
void Script::add_backing() {
    if (!scene().backing) return;
    const auto& planes = *scene().backing;
    const auto add = [&](const char* name, const char* face, double coordinate) {
        line("fix {} grains wall/harmonic {} {:.17g} {:.17g} 1 {:.17g}", name, face, coordinate,
             planes.stiffness / 2, wall_offset_);
    };
    add("left", "xlo", planes.left - wall_offset_);
    add("right", "xhi", planes.right + wall_offset_);
}

/// How grains move. Without friction spins do not act on anything in the scenes that are expressed.
const char* integration(const scene::ContactLaw& law) {
    if (!law.friction) return "nve";
    return law.friction->inertia_factor == disc_inertia ? "nve/sphere disc" : "nve/sphere";
}

void Script::add_run() {
    line("thermo_style custom step");
    line("thermo_modify lost error");
    line("run {}", scene().steps);
}

}  // namespace

PairStyle pair_style(const scene::ContactLaw& law) {
    if (!law.friction || !law.friction->conventions) return PairStyle::granular;
    const auto& asked = *law.friction->conventions;
    const auto granular = scene::conventions_named("lammps-granular").value();
    return same_force(*law.friction, asked, granular) ? PairStyle::granular : PairStyle::gran_hooke;
}

std::string lammps_script(const scene::Scene& scene, const std::string& data_name,
                          const std::string& dump_name) {
    Script script(scene);
    script.add_setup("sphere", "comm_modify vel yes");
    script.add_state(data_name);
    script.add_contacts();
    script.add_motion(integration(scene.contact));
    script.add_plates();
    script.add_backing();
    script.add_dump(dump_name, "float %.17g");
    script.add_run();
    return script.text();
}

}  // namespace crossgrain::adapters
