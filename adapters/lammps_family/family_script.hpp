// What the input scripts of LAMMPS and of its fork LIGGGHTS have in common: all but the contact
// law, the plates and a few words that the fork renamed. Holds only what the scene needs: no
// gravity, lid or third type unless it has them.
#pragma once

#include "adapters/dump/data_writer.hpp"
#include "cases/scene/scene.hpp"

#include <fmt/format.h>

#include <iterator>
#include <optional>
#include <string>
#include <utility>

namespace crossgrain::adapters::lammps_family {

/// Whether the law has a dashpot along the contact (full-vector damping with eta > 0).
[[nodiscard]] bool has_tangential_dashpot(const scene::ContactLaw& law);

/// The moments of inertia, in units of m r^2, that fix nve/sphere knows.
inline constexpr double disc_inertia = 0.5, sphere_inertia = 0.4;

/// Why plates cannot touch the surfaces of grains that differ; nothing if there is no such reason.
[[nodiscard]] std::optional<std::string> unequal_reach(const scene::Scene& scene);

/// Why tangential springs would be mixed up; nothing if there is no such reason. They are stored
/// under the partner's tag: two images of one partner within the reach of the neighbour list share
/// one spring.
[[nodiscard]] std::optional<std::string> shared_springs(const scene::Scene& scene);

/// Why the neighbour search cannot span the scene at its start; nothing if it can. A few grains are
/// searched without bins.
[[nodiscard]] std::optional<std::string> too_far_apart(const scene::Scene& scene);

/// A script in the making; each code adds its own lines between the common ones.
class FamilyScript {
  public:
    /// `scene` must outlive the script.
    explicit FamilyScript(const scene::Scene& scene)
        : scene_(scene), types_(dump::atom_types(scene)) {}

    /// `ghost_velocities`: the command that makes ghost atoms carry velocities.
    /// In 3 dimensions all grains stay in the plane z = 0, and nothing is periodic along z.
    void add_setup(const char* atom_style, const char* ghost_velocities, int dimensions = 2);
    /// Atoms, masses, and the groups grains, lid (if there is one) and moving.
    void add_state(const std::string& data_name);
    /// Pairs that do not touch each other: two frozen grains, the lid's atom and any grain.
    void add_exclusions();
    /// Also gravity and drag. `integration`: the style of the fix that moves grains and lid, e.g.
    /// "nve".
    void add_motion(const char* integration);
    /// `number_format`: arguments of dump_modify that make all numbers have 17 digits.
    void add_dump(const std::string& dump_name, const char* number_format);
    [[nodiscard]] std::string text() const { return fmt::to_string(text_); }

  protected:
    template <class... Arguments>
    void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
        text_.push_back('\n');
    }
    /// Formula of an equal-style variable: the height at `offset` from a prescribed plate. A plain
    /// number when the plate is at rest.
    [[nodiscard]] std::string height_formula(const scene::PrescribedPlate& plate,
                                             double offset) const;
    [[nodiscard]] const scene::Scene& scene() const noexcept { return scene_; }
    [[nodiscard]] const dump::AtomTypes& types() const noexcept { return types_; }

  private:
    void add_masses();

    const scene::Scene& scene_;
    dump::AtomTypes types_;
    fmt::memory_buffer text_;
};

}  // namespace crossgrain::adapters::lammps_family
