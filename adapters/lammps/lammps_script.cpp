#include "adapters/lammps/lammps_script.hpp"

#include "adapters/lammps_family/family_script.hpp"

#include <fmt/format.h>

#include <variant>

namespace crossgrain::adapters {

namespace {

class Script : public lammps_family::FamilyScript {
  public:
    explicit Script(const scene::Scene& scene)
        : FamilyScript(scene),
          // How far behind the plate the wall stands, see add_wall.
          wall_offset_(2 * scene.grains.diameter) {}

    void add_contacts();
    void add_plates();
    void add_run();

  private:
    [[nodiscard]] std::string position(const std::string& name, const scene::PrescribedPlate& plate,
                                       double offset);
    void add_wall(const std::string& name, const char* face, const std::string& coordinate);
    void add_free_lid();

    double wall_offset_;
};

void Script::add_contacts() {
    const auto& law = scene().contact;
    const bool full = law.damping_acts_on == scene::Damping::full_vector;
    // `granular` takes the dashpot as it is and the tangential one as a multiple of it. Its Coulomb
    // limit is lifted out of the way: that of gran/hooke must stay finite and bites near F_n = 0.
    line("pair_style granular");
    line("pair_coeff * * hooke {:.17g} {:.17g} damping velocity tangential linear_nohistory {} "
         "1e30{}",
         law.stiffness, law.damping, full ? 1 : 0,
         law.clipping == scene::Clipping::none ? "" : " limit_damping");
    add_exclusions();
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

void Script::add_run() {
    line("thermo_style custom step");
    line("thermo_modify lost error");
    line("run {}", scene().steps);
}

}  // namespace

std::string lammps_script(const scene::Scene& scene, const std::string& data_name,
                          const std::string& dump_name) {
    Script script(scene);
    script.add_setup("sphere", "comm_modify vel yes");
    script.add_state(data_name);
    script.add_contacts();
    // Not nve/sphere: spins do not act on anything in the scenes that are expressed.
    script.add_motion("nve");
    script.add_plates();
    script.add_dump(dump_name, "float %.17g");
    script.add_run();
    return script.text();
}

}  // namespace crossgrain::adapters
