// The two loops of the simd kernel, compiled for every instruction set and chosen at run time:
// forces over the neighbour list, and motion over the grains.
//
// A grain has four numbers in each array: its position and what unwraps it (x, y, X, Y), its
// velocities (v_x, v_y, omega, omega r) and the sums of what its contacts exert,
// (F_x, F_y, F_t, F_t overlap/2), from which follows its torque -(r sum F_t - sum F_t overlap/2).
// All four add up with signs that do not depend on the grain, and none of them needs a radius of
// one partner alone: a pair has only r_i + r_j.
#pragma once

#include "native/friction/system.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <string>
#include <vector>

namespace crossgrain::friction {

/// Begins at a cache line: vectors never straddle two.
template <class T>
struct CacheLineAllocator {
    using value_type = T;
    static constexpr std::align_val_t line{64};
    CacheLineAllocator() = default;
    template <class Other>
    explicit CacheLineAllocator(const CacheLineAllocator<Other>&) {}
    T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), line)); }
    void deallocate(T* p, std::size_t) noexcept { ::operator delete(p, line); }
    bool operator==(const CacheLineAllocator&) const = default;
};
template <class T>
using AlignedVector = std::vector<T, CacheLineAllocator<T>>;

/// Pairs come in batches of this many, whatever the width of the vectors.
constexpr std::size_t batch = 8;

/// Neighbour list. Shape of all arrays: (pairs), a multiple of `batch`, if not said otherwise.
struct PairList {
    AlignedVector<std::uint32_t> i, j;  ///< 4 times the place of the grain
    AlignedVector<double> shift_x, shift_y;
    AlignedVector<double> reach;                        ///< r_i + r_j
    AlignedVector<double> damping, tangential_damping;  ///< empty: all as in the constants
    /// `project`: the spring as a vector; `project_and_rescale`: its length along the tangent;
    /// `rotate`: the spring and the last normal.
    std::array<AlignedVector<double>, 4> memory;
    AlignedVector<std::uint8_t> remembers;  ///< shape (pairs / 4): of the vector that begins there
    std::int64_t worked_out = 0;            ///< pairs in vectors of which some touch, all steps
};

struct ForceTask {
    const double* position = nullptr;
    const double* velocity = nullptr;
    double* force = nullptr;  ///< added to
    PairList* pairs = nullptr;
    double stiffness = 0, damping = 0;
    double lowest_normal_force = 0;  ///< 0 cuts the attractive tail, -infinity keeps it
    double friction = 0, tangential_stiffness = 0, tangential_damping = 0;
    double spring_time = 0;  ///< dt; 0 at the start of a run
};

struct MotionTask {
    double* position = nullptr;
    double* velocity = nullptr;
    double* force = nullptr;  ///< in: forces, or accelerations for `open`; out: 0, or accelerations
    const double* own = nullptr;     ///< (1/m, 1/m, -r/I, -r^2/I)
    const double* torque = nullptr;  ///< (0, 0, 1/I, r/I)
    const double* listed = nullptr;  ///< positions when the list was made
    const double* margin = nullptr;  ///< how far from there, per axis
    std::size_t numbers = 0;         ///< 4 times the mobile grains, padded to a multiple of 8
    double dt = 0, gravity = 0, drag = 0;
    double backing_stiffness = 0, left = 0, right = 0;
    bool* left_margin = nullptr;  ///< set when a grain has left its margin or is no number
};

struct StepFunctions {
    std::size_t lanes = 0;  ///< 0: no vectors that serve
    std::string instruction_set;
    void (*add_contact_forces)(const ForceTask&) = nullptr;
    /// From (x_n, v_n, a_n) to (x_{n+1}, v_{n+1/2}): half a kick and the drift.
    void (*open)(const MotionTask&) = nullptr;
    /// With the forces at n+1: two half kicks and the drift to x_{n+2}.
    void (*full)(const MotionTask&) = nullptr;
    /// With the forces at n+1: half a kick to v_{n+1}; leaves a_{n+1}.
    void (*close)(const MotionTask&) = nullptr;
};

/// The functions for this law on this machine.
[[nodiscard]] StepFunctions step_functions(const ContactParameters& contact);

/// Doubles per vector on this machine; 0 when there are fewer than 4.
[[nodiscard]] std::size_t simd_lanes();

}  // namespace crossgrain::friction
