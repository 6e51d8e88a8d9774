// The rules compiled: for each of the 128 states of a site a decision tree with its outcomes. Both
// engines work from these trees alone.
#pragma once

#include "native/lga/model.hpp"
#include "native/lga/probability.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace crossgrain::lga {

struct Outcome {
    std::uint8_t movers = 0;  ///< bits 0..5
    std::uint8_t rests = 0;   ///< up to 7; all but one are relocated
    /// Directions of the neighbours that the rests beyond one try first, bits 0..5; as many as
    /// there are excess rests, or none (Relocation::random_walk).
    std::uint8_t origins = 0;

    [[nodiscard]] constexpr int excess() const noexcept { return rests > 1 ? rests - 1 : 0; }
    friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// Which of a site's random numbers a decision compares: one number per stage, shared by the
/// decisions of different configurations.
using Stage = int;
inline constexpr Stage first_collision_stage = 0;  ///< which of several applicable collisions
inline constexpr Stage first_row_stage = 16;       ///< which of its rows
inline constexpr Stage first_origin_stage = 32;    ///< which origins the excess rests return to
inline constexpr Stage stages = 64;

/// A place in the trees: a decision, or an outcome.
struct Branch {
    bool is_outcome = true;
    int index = 0;  ///< into decisions or outcomes
    friend bool operator==(const Branch&, const Branch&) = default;
};

/// `yes` if u < below * 2^-24, u the uniform number of the stage in [0, 1).
struct Decision {
    Stage stage = 0;
    std::uint32_t below = 0;
    Branch yes, no;
    friend bool operator==(const Decision&, const Decision&) = default;
};

struct CollisionTable {
    std::vector<Decision> decisions;
    std::vector<Outcome> outcomes;
    /// By packed state: movers in bits 0..5, the rest particle in bit 6.
    std::array<Branch, site_states> roots;
};

/// Throws CaseError when a rule does not conserve mass and momentum, has more than one rest before
/// it, a probability outside [0, 1] or rows that together exceed 1.
///
/// Rests beyond one, with Relocation::origin_first: of the particles that stopped, as many as there
/// are excess rests are chosen at random (each set equally likely), and each excess rest goes back
/// to the site its particle came from. "The two particles stay at rest on the NN sites where they
/// originally came from" (section II).
[[nodiscard]] CollisionTable compile(const Model& model);

}  // namespace crossgrain::lga
