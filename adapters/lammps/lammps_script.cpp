#include "adapters/lammps/lammps_script.hpp"

#include "adapters/dump/data_writer.hpp"

#include <fmt/format.h>

#include <iterator>
#include <numbers>
#include <utility>
#include <variant>

namespace crossgrain::adapters {

namespace {

class Script {
  public:
    explicit Script(const scene::Scene& scene)
        : scene_(scene), types_(dump::atom_types(scene)),
          // How far behind the plate the wall stands, see add_wall.
          wall_offset_(2 * scene.grains.diameter) {}

    void add_setup();
    void add_state(const std::string& data_name);
    void add_contacts();
    void add_motion();
    void add_plates();
    void add_output(const std::string& dump_name);
    [[nodiscard]] std::string text() const { return fmt::to_string(text_); }

  private:
    template <class... Arguments>
    void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
        text_.push_back('\n');
    }
    [[nodiscard]] std::string position(const std::string& name, const scene::PrescribedPlate& plate,
                                       double offset);
    void add_wall(const std::string& name, const char* face, const std::string& coordinate);
    void add_free_lid();

    const scene::Scene& scene_;
    dump::AtomTypes types_;
    double wall_offset_;
    fmt::memory_buffer text_;
};

void Script::add_setup() {
    line("# {}", scene_.name);
    line("units lj");
    line("dimension 2");
    // Shrink-wrapped where the scene is open: nothing can leave.
    line("boundary {} {} p", scene_.periodic_x ? 'p' : 's', scene_.periodic_y ? 'p' : 's');
    line("atom_style sphere");
    if (types_.lid > 0) line("atom_modify map array");
    line("newton off");
    line("comm_modify vel yes");
    // A few grains in the open may fly far apart: bins over all that space would fill the memory.
    constexpr std::size_t few = 64;
    line("neighbor {:.17g} {}", scene_.grains.diameter / 4,
         scene_.grain_count() <= few ? "nsq" : "bin");
    line("neigh_modify delay 0 every 1 check yes");
}

void Script::add_state(const std::string& data_name) {
    line("read_data {}", data_name);
    line("set type {} mass {:.17g}", types_.grain, scene_.grains.mass);
    if (types_.frozen > 0) line("set type {} mass {:.17g}", types_.frozen, scene_.grains.mass);
    line("group grains type {}", types_.grain);
    if (types_.lid > 0) {
        line("set type {} mass {:.17g}", types_.lid,
             std::get<scene::FreeLid>(scene_.plates.lid).mass);
        line("group lid type {}", types_.lid);
    }
    line("group moving type {}{}", types_.grain,
         types_.lid > 0 ? fmt::format(" {}", types_.lid) : "");
}

void Script::add_contacts() {
    const auto& law = scene_.contact;
    const bool full = law.damping_acts_on == scene::Damping::full_vector;
    // `granular` takes the dashpot as it is and the tangential one as a multiple of it. Its Coulomb
    // limit is lifted out of the way: that of gran/hooke must stay finite and bites near F_n = 0.
    line("pair_style granular");
    line("pair_coeff * * hooke {:.17g} {:.17g} damping velocity tangential linear_nohistory {} "
         "1e30{}",
         law.stiffness, law.damping, full ? 1 : 0,
         law.clipping == scene::Clipping::none ? "" : " limit_damping");
    if (types_.frozen > 0) line("neigh_modify exclude type {0} {0}", types_.frozen);
    if (types_.lid > 0) {
        line("neigh_modify exclude type {} {}", types_.grain, types_.lid);
        if (types_.frozen > 0) line("neigh_modify exclude type {} {}", types_.frozen, types_.lid);
    }
}

void Script::add_motion() {
    line("timestep {:.17g}", scene_.dt);
    // Not nve/sphere: spins do not act on anything in the scenes that are expressed.
    line("fix motion moving nve");
    if (scene_.gravity > 0) line("fix weight moving gravity {:.17g} vector 0 -1 0", scene_.gravity);
}

/// Coordinate of a wall at `offset` from a prescribed plate, as an argument of fix wall.
std::string Script::position(const std::string& name, const scene::PrescribedPlate& plate,
                             double offset) {
    if (plate.amplitude == 0) return fmt::format("{:.17g}", plate.height + offset);
    // The same order of operations as scene::height_at, so that the phase agrees to the last digit.
    line("variable {} equal {:.17g}+{:.17g}*cos({:.17g}*(step*{:.17g}))", name,
         plate.height + offset, plate.amplitude, 2.0 * std::numbers::pi / plate.period, scene_.dt);
    return "v_" + name;
}

/// An elastic plate. A wall of LAMMPS pushes a grain's centre away, with stiffness 2 epsilon, as
/// long as it is nearer than the cutoff, and stops the run when the centre gets behind the wall. So
/// the wall stands behind the plate and reaches just to the plate (or a radius further, when the
/// plate touches the surface).
void Script::add_wall(const std::string& name, const char* face, const std::string& coordinate) {
    const bool surface = scene_.plates.touches == scene::PlateContact::surface;
    const double reach = surface ? scene_.grains.diameter / 2 : 0.0;
    line("fix {} grains wall/harmonic {} {} {:.17g} 1 {:.17g}", name, face, coordinate,
         scene_.plates.stiffness / 2, wall_offset_ + reach);
}

void Script::add_free_lid() {
    const std::size_t id = scene_.grain_count() + 1;
    line("variable lid equal y[{}]+{:.17g}", id, wall_offset_);
    add_wall("lid", "yhi", "v_lid");
    // What the wall pushes it gets back, in the same step: this fix must follow the wall's.
    line("variable push equal f_lid[1]");
    line("fix push lid addforce 0 v_push 0");
}

void Script::add_plates() {
    const auto& plates = scene_.plates;
    if (plates.bottom) {
        add_wall("bottom", "ylo", position("bottom", *plates.bottom, -wall_offset_));
    }
    if (const auto* prescribed = std::get_if<scene::PrescribedPlate>(&plates.lid)) {
        add_wall("lid", "yhi", position("lid", *prescribed, wall_offset_));
    } else if (scene_.has_free_lid()) {
        add_free_lid();
    }
}

void Script::add_output(const std::string& dump_name) {
    line("dump frames all custom {} {} id type xu yu vx vy", scene_.frame_every, dump_name);
    line("dump_modify frames sort id format float %.17g");
    line("thermo_style custom step");
    line("thermo_modify lost error");
    line("run {}", scene_.steps);
}

}  // namespace

std::string lammps_script(const scene::Scene& scene, const std::string& data_name,
                          const std::string& dump_name) {
    Script script(scene);
    script.add_setup();
    script.add_state(data_name);
    script.add_contacts();
    script.add_motion();
    script.add_plates();
    script.add_output(dump_name);
    return script.text();
}

}  // namespace crossgrain::adapters
