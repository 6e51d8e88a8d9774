#include "adapters/liggghts/liggghts_script.hpp"

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
    explicit Script(const scene::Scene& scene) : scene_(scene), types_(dump::atom_types(scene)) {}

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
    void add_pair_property(const char* name, double value);
    void add_prescribed_position(const char* name, const scene::PrescribedPlate& plate,
                                 double offset);
    void add_plate_force(const char* name, char forbidden);

    const scene::Scene& scene_;
    dump::AtomTypes types_;
    fmt::memory_buffer text_;
};

void Script::add_setup() {
    line("# {}", scene_.name);
    line("units lj");
    line("dimension 2");
    // Shrink-wrapped where the scene is open: nothing can leave.
    line("boundary {} {} p", scene_.periodic_x ? 'p' : 's', scene_.periodic_y ? 'p' : 's');
    line("atom_style granular");
    if (types_.lid > 0) line("atom_modify map array");
    line("newton off");
    line("communicate single vel yes");
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

/// The same value for every pair of types.
void Script::add_pair_property(const char* name, double value) {
    const int types = types_.count();
    std::string values;
    for (int pair = 0; pair < types * types; ++pair)
        values += fmt::format(" {:.17g}", value);
    line("fix {0} all property/global {0} peratomtypepair {1}{2}", name, types, values);
}

void Script::add_contacts() {
    const auto& law = scene_.contact;
    add_pair_property("kn", law.stiffness);
    add_pair_property("kt", 0);
    add_pair_property("gamman_abs", law.damping);
    add_pair_property("gammat_abs", has_tangential_dashpot(law) ? law.damping : 0);
    add_pair_property("coefficientFriction", 1e30);  // out of the way
    line("pair_style gran model hooke/stiffness tangential no_history{} absolute_damping on",
         law.clipping == scene::Clipping::none ? "" : " limitForce on");
    line("pair_coeff * *");
    if (types_.frozen > 0) line("neigh_modify exclude type {0} {0}", types_.frozen);
    if (types_.lid > 0) {
        line("neigh_modify exclude type {} {}", types_.grain, types_.lid);
        if (types_.frozen > 0) line("neigh_modify exclude type {} {}", types_.frozen, types_.lid);
    }
}

void Script::add_motion() {
    line("timestep {:.17g}", scene_.dt);
    // Without a tangential dashpot nothing turns a grain. With `dimension 2`, nve/sphere takes the
    // moment of inertia m R^2 / 2 of a disc.
    const bool spins =
        scene_.contact.spins == scene::Spins::on && has_tangential_dashpot(scene_.contact);
    line("fix motion moving {}", spins ? "nve/sphere" : "nve");
    if (scene_.gravity > 0) line("fix weight moving gravity {:.17g} vector 0 -1 0", scene_.gravity);
}

/// Equal-style variable `name`: where a prescribed plate touches a grain's centre, `offset` from
/// the plate. The same order of operations as scene::height_at: the phase agrees to the last digit.
void Script::add_prescribed_position(const char* name, const scene::PrescribedPlate& plate,
                                     double offset) {
    if (plate.amplitude == 0) {
        line("variable {} equal {:.17g}", name, plate.height + offset);
        return;
    }
    line("variable {} equal {:.17g}+{:.17g}*cos({:.17g}*(step*{:.17g}))", name,
         plate.height + offset, plate.amplitude, 2.0 * std::numbers::pi / plate.period, scene_.dt);
}

/// A spring on every grain that is on the `forbidden` side ('<' or '>') of the position `name`.
void Script::add_plate_force(const char* name, char forbidden) {
    line("variable {0}force atom {1:.17g}*((v_{0}-y)*(y{2}v_{0}))", name, scene_.plates.stiffness,
         forbidden);
    line("fix {0}force grains addforce 0 v_{0}force 0", name);
}

/// Plates are forces on the grains: primitive walls of LIGGGHTS touch the surface only, and they
/// neither vibrate nor move freely.
void Script::add_plates() {
    const auto& plates = scene_.plates;
    const bool surface = plates.touches == scene::PlateContact::surface;
    const double reach = surface ? scene_.grains.diameter / 2 : 0.0;
    if (plates.bottom) {
        add_prescribed_position("bottom", *plates.bottom, reach);
        add_plate_force("bottom", '<');
    }
    if (const auto* prescribed = std::get_if<scene::PrescribedPlate>(&plates.lid)) {
        add_prescribed_position("lid", *prescribed, -reach);
        add_plate_force("lid", '>');
    } else if (std::holds_alternative<scene::FreeLid>(plates.lid)) {
        line("variable lid equal y[{}]-{:.17g}", scene_.grain_count() + 1, reach);
        add_plate_force("lid", '>');
        line("compute push grains reduce sum v_lidforce");
        line("variable push equal -c_push");
        line("fix push lid addforce 0 v_push 0");
    }
}

void Script::add_output(const std::string& dump_name) {
    line("dump frames all custom {} {} id type xu yu vx vy", scene_.frame_every, dump_name);
    line("dump_modify frames sort id format \"%d %d %.17g %.17g %.17g %.17g\"");
    line("thermo_style custom step atoms");
    // Lost atoms are an error only here, and only when thermo is printed: otherwise they are
    // silently gone and the exit status is 0.
    line("thermo_modify lost error");
    line("thermo {}", scene_.frame_every);
    line("run {}", scene_.steps);
}

}  // namespace

bool has_tangential_dashpot(const scene::ContactLaw& law) {
    return law.damping_acts_on == scene::Damping::full_vector && law.damping > 0;
}

std::string liggghts_script(const scene::Scene& scene, const std::string& data_name,
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
