#include "adapters/lammps_family/family_script.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>
#include <vector>

namespace crossgrain::adapters::lammps_family {

namespace {

/// Searched without bins: in the open they may fly far apart, and bins over all that space would
/// fill the memory.
bool has_few_grains(const scene::Scene& scene) {
    constexpr std::size_t few = 64;
    return scene.grain_count() <= few;
}

double skin(const scene::Scene& scene) {
    return scene.skin.value_or(scene.grains.diameter / 4);
}

constexpr double most_bins = 1e8;

/// Bins of the neighbour search along one axis, when grains move by `travel` at most.
double bins_along(const scene::Scene& scene, const std::optional<double>& period,
                  const std::vector<double>& positions, double travel) {
    double length = period.value_or(0);
    if (!period && !positions.empty()) {
        const auto [low, high] = std::minmax_element(positions.begin(), positions.end());
        length = *high - *low + 2 * travel;
    }
    return 2 * length / (scene.grains.diameter + skin(scene)) + 1;
}

double bins(const scene::Scene& scene, double travel) {
    return bins_along(scene, scene.periodic_x, scene.initial.x, travel) *
           bins_along(scene, scene.periodic_y, scene.initial.y, travel);
}

/// In free flight; forces change it little where grains are so far apart that it matters.
double travel(const scene::Scene& scene) {
    double fastest = 0;
    for (std::size_t i = 0; i < scene.grain_count(); ++i)
        fastest = std::max(fastest, std::hypot(scene.initial.vx[i], scene.initial.vy[i]));
    return fastest * scene.dt * static_cast<double>(scene.steps);
}

}  // namespace

std::optional<std::string> too_far_apart(const scene::Scene& scene) {
    if (has_few_grains(scene) || bins(scene, 0) <= most_bins) return std::nullopt;
    return fmt::format(
        "the neighbour search would need {:.3g} bins over the whole scene, more than "
        "{:g} (grains that are nearer to each other would be expressible)",
        bins(scene, 0), most_bins);
}

bool has_tangential_dashpot(const scene::ContactLaw& law) {
    return law.damping_acts_on == scene::Damping::full_vector && law.damping > 0;
}

std::optional<std::string> unequal_reach(const scene::Scene& scene) {
    const auto& plates = scene.plates;
    const bool any = plates.bottom || !std::holds_alternative<std::monostate>(plates.lid);
    if (!any || !scene.grains.differ() || plates.touches == scene::PlateContact::centre) {
        return std::nullopt;
    }
    return "plates reach equally far into all grains, and these differ (plates that touch centres "
           "would be expressible)";
}

std::optional<std::string> shared_springs(const scene::Scene& scene) {
    const auto& friction = scene.contact.friction;
    if (!friction || friction->force != scene::TangentialForce::spring) return std::nullopt;
    const double least = 2 * (scene::largest_diameter(scene.grains) + skin(scene));
    for (const auto& [axis, period] :
         {std::pair{'x', scene.periodic_x}, std::pair{'y', scene.periodic_y}}) {
        if (!period || *period >= least) continue;
        return fmt::format(
            "the period {:g} along {} is below {:g}, twice the reach of the "
            "neighbour list: two images of a grain would share one tangential spring",
            *period, axis, least);
    }
    return std::nullopt;
}

void FamilyScript::add_setup(const char* atom_style, const char* ghost_velocities, int dimensions) {
    line("# a scene of crossgrain");  // not its name: no text from outside gets into a script
    line("units lj");
    line("dimension {}", dimensions);
    // Shrink-wrapped where the scene is open: nothing can leave.
    line("boundary {} {} {}", scene_.periodic_x ? 'p' : 's', scene_.periodic_y ? 'p' : 's',
         dimensions == 2 ? 'p' : 'f');
    line("atom_style {}", atom_style);
    if (types_.lid > 0) line("atom_modify map array");
    const bool few = has_few_grains(scene_);
    // Atoms are sorted by bins as well, which so few do not need.
    if (few && bins(scene_, travel(scene_)) > most_bins) line("atom_modify sort 0 0.0");
    line("newton off");
    line("{}", ghost_velocities);
    line("neighbor {:.17g} {}", skin(scene_), few ? "nsq" : "bin");
    line("neigh_modify delay 0 every 1 check yes");
}

void FamilyScript::add_state(const std::string& data_name) {
    line("read_data {}", data_name);
    add_masses();
    line("group grains type {}", types_.grain);
    if (types_.lid > 0) {
        line("set type {} mass {:.17g}", types_.lid,
             std::get<scene::FreeLid>(scene_.plates.lid).mass);
        line("group lid type {}", types_.lid);
    }
    line("group moving type {}{}", types_.grain,
         types_.lid > 0 ? fmt::format(" {}", types_.lid) : "");
}

/// By numbers: a density in the data file would round them.
void FamilyScript::add_masses() {
    if (scene_.grains.differ()) {
        for (std::size_t i = 0; i < scene_.grain_count(); ++i)
            line("set atom {} mass {:.17g}", i + 1, scene_.grains.masses[i]);
        return;
    }
    line("set type {} mass {:.17g}", types_.grain, scene_.grains.mass);
    if (types_.frozen > 0) line("set type {} mass {:.17g}", types_.frozen, scene_.grains.mass);
}

void FamilyScript::add_exclusions() {
    if (types_.frozen > 0) line("neigh_modify exclude type {0} {0}", types_.frozen);
    if (types_.lid > 0) {
        line("neigh_modify exclude type {} {}", types_.grain, types_.lid);
        if (types_.frozen > 0) line("neigh_modify exclude type {} {}", types_.frozen, types_.lid);
    }
}

void FamilyScript::add_motion(const char* integration) {
    line("timestep {:.17g}", scene_.dt);
    line("fix motion moving {}", integration);
    if (scene_.gravity > 0) line("fix weight moving gravity {:.17g} vector 0 -1 0", scene_.gravity);
    if (scene_.drag > 0) line("fix drag grains viscous {:.17g}", scene_.drag);
}

std::string FamilyScript::height_formula(const scene::PrescribedPlate& plate, double offset) const {
    const std::string mean = fmt::format("{:.17g}", plate.height + offset);
    if (plate.amplitude == 0) return mean;
    // The same order of operations as scene::height_at, so that the phase agrees to the last digit.
    const std::string phase =
        plate.phase == 0 ? "" : fmt::format("+{:.17g}", scene::phase_angle(plate));
    return fmt::format("{}+{:.17g}*cos({:.17g}*(step*{:.17g}){})", mean, plate.amplitude,
                       2.0 * std::numbers::pi / plate.period, scene_.dt, phase);
}

void FamilyScript::add_dump(const std::string& dump_name, const char* number_format) {
    line("dump frames all custom {} {} id type xu yu vx vy{}", scene_.frame_every, dump_name,
         scene_.has_friction() ? " omegaz" : "");
    line("dump_modify frames sort id format {}", number_format);
}

}  // namespace crossgrain::adapters::lammps_family
