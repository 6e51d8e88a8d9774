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
    void add_run();

  private:
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

void Script::add_contacts() {
    const auto& law = scene().contact;
    add_pair_property("kn", law.stiffness);
    add_pair_property("kt", 0);
    add_pair_property("gamman_abs", law.damping);
    add_pair_property("gammat_abs", has_tangential_dashpot(law) ? law.damping : 0);
    add_pair_property("coefficientFriction", 1e30);  // out of the way
    line("pair_style gran model hooke/stiffness tangential no_history{} absolute_damping on",
         law.clipping == scene::Clipping::none ? "" : " limitForce on");
    line("pair_coeff * *");
    add_exclusions();
}

/// Style of the fix that moves the grains. Without a tangential dashpot nothing turns a grain. With
/// `dimension 2`, nve/sphere takes the moment of inertia m R^2 / 2 of a disc.
const char* integration(const scene::ContactLaw& law) {
    const bool spins = law.spins == scene::Spins::on && has_tangential_dashpot(law);
    return spins ? "nve/sphere" : "nve";
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
    script.add_setup("granular", "communicate single vel yes");
    script.add_state(data_name);
    script.add_contacts();
    script.add_motion(integration(scene.contact));
    script.add_plates();
    script.add_dump(dump_name, "\"%d %d %.17g %.17g %.17g %.17g\"");
    script.add_run();
    return script.text();
}

}  // namespace crossgrain::adapters
