// The hopper automaton: advances a filling by whole iterations.
// An iteration empties the N sites of the outlet, then visits the levels; at each level the holes
// in a random order, each filled from above at once by the move of least energy (energy.hpp). A
// hole that is filled goes on one or two half-levels higher.
#pragma once

#include "native/hopper/candidate_table.hpp"
#include "native/hopper/geometry.hpp"
#include "native/hopper/parameters.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace crossgrain::hopper {

/// What a run has done so far.
struct Record {
    std::int64_t iterations = 0;
    std::vector<std::uint32_t> flow;  ///< shape (iterations): grains that left in each
    std::int64_t moves = 0;           ///< of grains from site to site
    /// Highest half-level whose outermost site at that wall was ever vacated; -1 for none.
    std::int32_t left_reach = -1, right_reach = -1;
};

class Engine {
  public:
    virtual ~Engine() = default;
    Engine() = default;
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Does `iterations` iterations, >= 0.
    virtual void advance(std::int64_t iterations) = 0;

    [[nodiscard]] virtual const Geometry& geometry() const = 0;
    /// 0 empty, 1 to 3 orientation; shape (sites), level by level, columns ascending.
    [[nodiscard]] virtual std::vector<std::uint8_t> state() const = 0;
    [[nodiscard]] virtual const Record& record() const = 0;
};

/// `plain`: the rules as written (plain_engine.hpp). `fast`: the same bits sooner.
enum class EngineKind { fast, plain };

/// Of zigzag rows there is the plain engine only. `table` is that of the parameters' rules, for
/// many runs of the same rules; made anew when there is none. Throws CaseError, see check().
[[nodiscard]] std::unique_ptr<Engine>
make_engine(const Parameters& parameters, EngineKind kind,
            std::shared_ptr<const CandidateTable> table = nullptr);

}  // namespace crossgrain::hopper
