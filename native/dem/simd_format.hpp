// How the simd kernel keeps grains in memory. A neighbour is read with one or two 128-bit loads and
// transposed in registers, which is 2.5 times faster than gathering its four numbers.
#pragma once

#include "native/dem/system.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

namespace crossgrain::dem {

/// Positions are multiples of a unit of length, modulo 2^32 of them: differences of neighbours come
/// out right across the period, at 3e-8 of a length instead of the 8e-6 of a float near x = 100.
struct MixedFormat {
    using Position = std::int32_t;
    using Real = float;
    struct alignas(16) Record {
        std::int32_t x, y;
        float vx, vy;
    };
};

struct DoubleFormat {
    using Position = double;
    using Real = double;
    struct alignas(32) Record {
        double x, y, vx, vy;
    };
};

/// Begins at a cache line: vectors of records never straddle two.
template <class T>
struct CacheLineAllocator {
    using value_type = T;
    static constexpr std::size_t bytes = 64;
    static constexpr std::align_val_t line{bytes};
    CacheLineAllocator() = default;
    template <class Other>
    explicit CacheLineAllocator(const CacheLineAllocator<Other>&) {}
    T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), line)); }
    void deallocate(T* p, std::size_t) noexcept { ::operator delete(p, line); }
    bool operator==(const CacheLineAllocator&) const = default;
};

template <class Format>
using Records = std::vector<typename Format::Record, CacheLineAllocator<typename Format::Record>>;

/// Grains that are computed together, one per lane of a vector.
struct GroupShape {
    std::size_t lanes = 0;   ///< grains
    std::size_t blocks = 1;  ///< of 128 bits in a vector

    /// Which of the group's records the lane belongs to. Records are transposed within blocks only,
    /// so that neighbouring records are in neighbouring blocks.
    [[nodiscard]] constexpr std::size_t place_of_lane(std::size_t lane) const {
        const std::size_t in_block = lanes / blocks;
        return blocks * (lane % in_block) + lane / in_block;
    }
    /// The inverse, for all grains: where in arrays of vectors a grain at a place is.
    [[nodiscard]] constexpr std::size_t slot_of_place(std::size_t place) const {
        // Both are powers of two.
        const std::size_t in_group = place & (lanes - 1);
        const int per_block = std::countr_zero(lanes) - std::countr_zero(blocks);
        return place - in_group + ((in_group & (blocks - 1)) << per_block) +
               (in_group >> std::countr_zero(blocks));
    }
};

/// Full neighbour list, padded per group of as many grains as a vector has lanes. Row r of group g
/// has the r-th neighbour of each of its grains, as a byte offset into the records; grains with
/// fewer neighbours have the dummy record, which is far from all, instead. Neighbours that can
/// touch first come first, as of the step at which rows were last ordered (simd_row_order-inl.hpp):
/// a row matters only when it is due.
struct PaddedList {
    std::vector<std::uint32_t> first_row;                                   ///< shape (groups + 1)
    std::vector<std::uint32_t, CacheLineAllocator<std::uint32_t>> offsets;  ///< shape (rows, lanes)
    std::vector<float> due;  ///< shape (rows + groups): steps from that one, which is step 1, to
                             ///< the first in which a pair of a row, or of one behind it, can
                             ///< touch; infinity behind the last row of a group
    std::vector<std::uint8_t> crosses;  ///< shape (groups): a pair reaches across the period
};

/// What a step needs to know, in the units of the format.
template <class Format>
struct StepConstants {
    using Real = typename Format::Real;
    Real diameter = 0, stiffness = 0, damping = 0;
    Real inverse_mass = 0, gravity = 0, dt = 0;
    Real unit_x = 1, unit_y = 1;          ///< length of one unit of position
    Real steps_x = 0, steps_y = 0;        ///< dt in units of position: dt/unit
    Real period = 0, inverse_period = 0;  ///< of DoubleFormat; 0 when open
    Real plate_stiffness = 0;
    bool has_bottom = false, has_lid = false;
};

/// Grains up to which one number of lid overlap is summed: the partition of the sum, and with it
/// its rounding, is the same for any number of threads.
constexpr std::size_t grains_per_block = 512;

/// One step of the groups [first_group, last_group).
template <class Format>
struct StepTask {
    using Real = typename Format::Real;
    const StepConstants<Format>* constants = nullptr;
    const PaddedList* list = nullptr;
    const typename Format::Record* in = nullptr;  ///< shape (padded grains + 1), the dummy last
    typename Format::Record* out = nullptr;
    Real* own_x = nullptr;  ///< shape (padded grains) in the order of lanes: v_{n+1/2}, or a_n
                            ///< between two calls
    Real* own_y = nullptr;
    std::size_t first_group = 0, last_group = 0;
    std::size_t grains = 0;    ///< without padding
    std::size_t ahead = 0;     ///< records so far ahead are called for; none if it is `grains`
    bool past_caches = false;  ///< records are stored so
    float step = 1;            ///< since rows were ordered, which was before step 1
    typename Format::Position bottom = 0;  ///< touches a grain whose y is below
    typename Format::Position lid = 0;     ///< touches a grain whose y is above
    double* lid_overlap = nullptr;        ///< shape (blocks): sum of overlaps, in units of position
    Real acceleration_limit_squared = 0;  ///< by all contacts of a grain
    std::int64_t* rows = nullptr;         ///< adds up the rows looked at
    bool* exceeded = nullptr;  ///< set when an acceleration is beyond the limit or no number
};

/// Orders the rows of the groups [first_group, last_group).
template <class Format>
struct RowOrderTask {
    const StepConstants<Format>* constants = nullptr;
    const typename Format::Record* now = nullptr;  ///< shape (padded grains + 1)
    PaddedList* list = nullptr;
    std::size_t first_group = 0, last_group = 0;
    double acceleration = 0;  ///< A dt^2: contacts accelerate no grain by more than A > 0
    float horizon = 0;        ///< steps after which rows will have been ordered anew
};

/// Where the grains of [first_group, last_group) have come since the list was made, and how fast
/// they go.
template <class Format>
struct SurveyTask {
    using Real = typename Format::Real;
    const StepConstants<Format>* constants = nullptr;
    const typename Format::Record* now = nullptr;
    const typename Format::Record* listed = nullptr;  ///< when the list was made
    std::size_t first_group = 0, last_group = 0;
    Real centre_x = 0, centre_y = 0;  ///< common displacement that does not count
};

/// Answer of a survey; lengths and velocities.
struct Survey {
    struct Range {
        double low = 0, high = 0;
        [[nodiscard]] double middle() const { return (low + high) / 2; }
        [[nodiscard]] double largest() const { return std::max(std::abs(low), std::abs(high)); }
        void include(const Range& other) {
            low = std::min(low, other.low);
            high = std::max(high, other.high);
        }
    };
    Range x, y;                           ///< displacements
    Range vx, vy;                         ///< velocities
    double largest_distance_squared = 0;  ///< of a displacement from the centre asked for
    bool finite = true;                   ///< all velocities are numbers

    void include(const Survey& other) {
        x.include(other.x);
        y.include(other.y);
        vx.include(other.vx);
        vy.include(other.vy);
        largest_distance_squared =
            std::max(largest_distance_squared, other.largest_distance_squared);
        finite = finite && other.finite;
    }
};

}  // namespace crossgrain::dem
