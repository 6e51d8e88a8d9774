#include "adapters/liggghts/liggghts_script.hpp"

#include "adapters/lammps_family/family_script.hpp"

#include <fmt/format.h>

#include <variant>

namespace crossgrain::adapters {

namespace {

using lammps_family::has_tangential_dashpot;

class Script : public lammps_family::FamilyScript {
  public:
    using FamilyScript::FamilyScript;

    void add_contacts();
    void add_plates();
    void add_backing();
    void add_run();

  private:
    void add_properties(double stiffness, double damping, double friction);
    [[nodiscard]] std::string add_tangential_dashpot();
    [[nodiscard]] std::string add_friction();
    void add_pair_property(const char* name, double value);
    void add_plate_force(const char* name, char forbidden);
};

/// The same value for every pair of types.
void Script::add_pair_property(const char* name, double value) {
    const int count = types().count();
    std::string values;
    for (int pair = 0; pair < count * count; ++pair)
        values += fmt::format(" {:.17g}", value);
    line("fix {0} all property/global {0} peratomtypepair {1}{2}", name, count, values);
}

/// Damping coefficients are taken as they are, or per unit of the pair's effective mass.
bool is_absolute(const scene::ContactLaw& law) {
    return law.damping_scale == scene::DampingScale::absolute;
}

void Script::add_contacts() {
    const auto& law = scene().contact;
    const bool absolute = is_absolute(law);
    const std::string tangential = law.friction ? add_friction() : add_tangential_dashpot();
    line("pair_style gran model hooke/stiffness tangential {}{} absolute_damping {}", tangential,
         law.clipping == scene::Clipping::none ? "" : " limitForce on", absolute ? "on" : "off");
    line("pair_coeff * *");
    add_exclusions();
    // Only a grain that fix freeze holds counts as infinitely heavy in an effective mass.
    if (!absolute && types().frozen > 0) {
        line("group frozen type {}", types().frozen);
        line("fix hold frozen freeze");
    }
}

/// Stiffness and damping along the tangent, and the coefficient of friction, with those of the
/// normal.
void Script::add_properties(double stiffness, double damping, double friction) {
    const auto& law = scene().contact;
    const bool absolute = is_absolute(law);
    add_pair_property("kn", law.stiffness);
    add_pair_property("kt", stiffness);
    add_pair_property(absolute ? "gamman_abs" : "gamman", law.damping);
    add_pair_property(absolute ? "gammat_abs" : "gammat", damping);
    add_pair_property("coefficientFriction", friction);
}

/// Taguchi's dashpot along the contact, with the Coulomb limit out of the way.
std::string Script::add_tangential_dashpot() {
    const auto& law = scene().contact;
    add_properties(0, has_tangential_dashpot(law) ? law.damping : 0, 1e30);
    return "no_history";
}

std::string Script::add_friction() {
    const auto& friction = *scene().contact.friction;
    add_properties(friction.stiffness, friction.damping, friction.coefficient);
    if (friction.force == scene::TangentialForce::dashpot) return "no_history";
    // Otherwise the spring of a pair that has parted stays as it was, and is there when the pair
    // meets again: it is set to zero only when a pair is seen that does not touch, and without this
    // only pairs that touch are seen. No pair may move apart by more than these 5 % in one step.
    line("neigh_modify contact_distance_factor 1.05");
    return friction.damping > 0 ? "history" : "history tangential_damping off";
}

/// fix nve/sphere takes the moment of inertia of a disc in 2 dimensions and of a sphere in 3.
int dimensions(const scene::ContactLaw& law) {
    const bool sphere =
        law.friction && law.friction->inertia_factor == lammps_family::sphere_inertia;
    return sphere ? 3 : 2;
}

/// Style of the fix that moves the grains. Without a tangential force nothing turns a grain.
const char* integration(const scene::ContactLaw& law) {
    const bool turning = law.friction || has_tangential_dashpot(law);
    return law.spins == scene::Spins::on && turning ? "nve/sphere" : "nve";
}

/// Springs on the centres of grains that are behind a plane.
void Script::add_backing() {
    if (!scene().backing) return;
    const auto& planes = *scene().backing;
    line("variable backing atom {0:.17g}*(({1:.17g}-x)*(x<{1:.17g})+({2:.17g}-x)*(x>{2:.17g}))",
         planes.stiffness, planes.left, planes.right);
    line("fix backing grains addforce v_backing 0 0");
}

/// A spring on every grain that is on the `forbidden` side ('<' or '>') of the position `name`.
void Script::add_plate_force(const char* name, char forbidden) {
    line("variable {0}force atom {1:.17g}*((v_{0}-y)*(y{2}v_{0}))", name, scene().plates.stiffness,
         forbidden);
    line("fix {0}force grains addforce 0 v_{0}force 0", name);
}

/// Plates are forces on the grains: primitive walls of LIGGGHTS touch the surface only, and they
/// neither vibrate nor move freely.
void Script::add_plates() {
    const auto& plates = scene().plates;
    const bool surface = plates.touches == scene::PlateContact::surface;
    const double reach = surface ? scene().grains.diameter / 2 : 0.0;
    if (plates.bottom) {
        line("variable bottom equal {}", height_formula(*plates.bottom, reach));
        add_plate_force("bottom", '<');
    }
    if (const auto* prescribed = std::get_if<scene::PrescribedPlate>(&plates.lid)) {
        line("variable lid equal {}", height_formula(*prescribed, -reach));
        add_plate_force("lid", '>');
    } else if (std::holds_alternative<scene::FreeLid>(plates.lid)) {
        line("variable lid equal y[{}]-{:.17g}", scene().grain_count() + 1, reach);
        add_plate_force("lid", '>');
        line("compute push grains reduce sum v_lidforce");
        line("variable push equal -c_push");
        line("fix push lid addforce 0 v_push 0");
    }
}

void Script::add_run() {
    line("thermo_style custom step atoms");
    // Lost atoms are an error only here, and only when thermo is printed: otherwise they are
    // silently gone and the exit status is 0.
    line("thermo_modify lost error");
    line("thermo {}", scene().frame_every);
    line("run {}", scene().steps);
}

}  // namespace

std::string liggghts_script(const scene::Scene& scene, const std::string& data_name,
                            const std::string& dump_name) {
    Script script(scene);
    script.add_setup("granular", "communicate single vel yes", dimensions(scene.contact));
    script.add_state(data_name);
    script.add_contacts();
    script.add_motion(integration(scene.contact));
    script.add_plates();
    script.add_backing();
    script.add_dump(dump_name, scene.has_friction() ? "\"%d %d %.17g %.17g %.17g %.17g %.17g\""
                                                    : "\"%d %d %.17g %.17g %.17g %.17g\"");
    script.add_run();
    return script.text();
}

}  // namespace crossgrain::adapters
