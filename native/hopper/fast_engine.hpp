// The rules of plain_engine.hpp by lists of holes and a table of moves: the same bits sooner.
//
// A hole that cannot be filled stays so until a grain arrives above it. So each level has a list of
// the holes that may have an occupied source: those vacated since the level was last visited, and
// those above which a grain has arrived. Only they are visited, and a move costs the same in a
// hopper of any size.
#pragma once

#include "native/hopper/candidate_table.hpp"
#include "native/hopper/engine.hpp"
#include "native/hopper/filling.hpp"
#include "native/hopper/level_order.hpp"
#include "native/hopper/numbers.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace crossgrain::hopper {

class FastEngine final : public Engine {
  public:
    /// `table` is that of the parameters' rules; several engines may share it. Levels must be
    /// half-levels. Throws CaseError, see check().
    FastEngine(const Parameters& parameters, std::shared_ptr<const CandidateTable> table);

    void advance(std::int64_t iterations) override;
    [[nodiscard]] const Geometry& geometry() const override { return filling_.geometry; }
    [[nodiscard]] std::vector<std::uint8_t> state() const override { return filling_.sites(); }
    [[nodiscard]] const Record& record() const override { return filling_.record; }

    // An iteration in parts, so that independent runs can take turns level by level.
    void begin_iteration();
    /// The n-th level of the sweep.
    void visit_level(std::size_t n);
    void end_iteration() { ++filling_.record.iterations; }

  private:
    struct HoleList {
        std::size_t start = 0;  // in holes_
        std::size_t count = 0, capacity = 0;
        std::uint32_t first_place = 0, last_place = 0;
        std::uint32_t site_of_place = 0;
    };
    /// What a hole does, as decided before any hole of its level is filled.
    struct Plan {
        static constexpr std::uint32_t shared = 0xff, orientation = 3U << 16;
        static constexpr int orientation_shift = 16, from_3_shift = 18, hole_below_shift = 19;

        std::uint32_t place = 0, source = 0;  // source: where the grain comes from
        std::uint32_t tie = 0;
        /// States of the sources 2 and 4, which the holes beside it have as well; new orientation,
        /// 0 when nothing can fall; whether from source 3; whether a hole lies below.
        std::uint32_t bits = 0;
    };
    /// What it takes to look around, by value: the bytes of the field may alias all else.
    struct Sight {
        explicit Sight(FastEngine& engine);
        /// CandidateTable entry of the cell around a hole.
        [[nodiscard]] std::uint16_t entry(std::uint32_t place) const;
        [[nodiscard]] Plan plan(std::uint32_t place, std::uint32_t tie) const;
        /// Plan::shared as it is now.
        [[nodiscard]] std::uint32_t shared_sources(std::uint32_t place) const;

        std::uint8_t* field;
        const std::uint16_t* entries;
        // Steps to nodes 2 and 3. Node 4 lies beside 2; 5, 6 and 7 are opposite to 2, 3 and 4.
        std::ptrdiff_t to_2, to_3;
    };

    void fill_by_site_numbers(std::size_t k, std::size_t count);
    void fill_by_stream(std::size_t k, std::size_t count);
    void carry_out(std::size_t k, std::size_t count);
    void note_reach(std::size_t k);
    /// Makes a list long enough for `more` holes.
    void make_room(HoleList& list, std::size_t more);
    void look_below(std::size_t k, std::uint32_t place);
    void await(std::ptrdiff_t k, std::uint32_t place);

    Parameters parameters_;
    Numbers numbers_;
    std::shared_ptr<const CandidateTable> table_;
    Filling filling_;
    std::vector<HoleList> lists_;       // by level, two more for the ghosts above
    std::vector<std::uint32_t> holes_;  // all lists; short ones, since few levels need long ones
    std::vector<std::uint32_t> order_, tie_, rank_;  // of the level at hand
    std::vector<Plan> plans_;                        // in the order in which they are carried out
    std::vector<std::uint32_t> arrivals_;            // grains that now lie above a hole
    IterationNumbers iteration_numbers_;
    std::uint64_t stream_place_ = 0;
};

}  // namespace crossgrain::hopper
